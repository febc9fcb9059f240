// The step's pairs in their lists and by priority, measured no sooner than somebody asks.
//
//   lists      one, or by the region: nothing is measured; by thresholds or shares: every pair is
//   order      only when pairs wait for work beyond the floor, and more than one of one list
//   measure    of a pair that touches, for the report
//
// A pair's terms are computed when it is measured, and only those that the metric looks at. What
// is measured depends on the state, so when it is measured changes nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/dynamics/body.hpp"
#include "engine/scheduling/priority_lists.hpp"
#include "engine/world/step.hpp"

namespace impetus::inline world {

/// What pairs are measured by, in a step whose bodies are where they will be tested.
struct Measuring {
  const Schedule& schedule;
  const StepInput& input;
  const std::vector<BodyModel>& models;
  const std::vector<BodyState>& states;
};

class StepOrder {
 public:
  /// Gives each of `candidates` its list; what was known before is forgotten. The candidates must
  /// stay as long as anything is asked of their order.
  void put_into_lists(std::vector<PairBounds>& candidates, const Measuring& by);

  /// With their lists, in an order that means nothing; lists may be changed.
  [[nodiscard]] std::vector<MeasuredPair>& pairs() { return pairs_; }

  /// Places in pairs(), by list and by falling priority within each, when `waiting` of them wait
  /// for work: none when none does; in any order when one does and there is one list. Valid until
  /// the next call.
  std::span<const std::size_t> places_by_priority(std::size_t waiting, const Measuring& by);

  /// All pairs as they are scheduled, by list and by falling priority within each, instead of what
  /// `listed` held. To be asked for once work was done by places_by_priority().
  void list_pairs(const Measuring& by, std::vector<ScheduledPair>& listed);

  /// What the metric says of the pair at that place, in its unit.
  double measured(std::size_t place, const Measuring& by);

 private:
  void sort_places(const Measuring& by);
  [[nodiscard]] double measure(std::int32_t candidate, const Measuring& by);

  std::vector<PairBounds>* candidates_{nullptr};
  std::vector<MeasuredPair> pairs_;
  std::vector<std::size_t> places_;
  bool are_measured_{false};
};

}  // namespace impetus::inline world
