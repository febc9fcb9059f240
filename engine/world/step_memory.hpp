// What the phases of a step hand to each other, kept from one step to the next so that a step
// allocates nothing once its scene has been as full as it gets.
//
// Nothing here decides anything: each part is filled anew before it is read. A copy of a world
// starts with an empty memory; a world that is assigned to keeps its own, but for what it lends.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/collision/broad_phase.hpp"
#include "engine/collision/budgeted_refinement.hpp"
#include "engine/collision/placed_blocks.hpp"
#include "engine/dynamics/motion.hpp"
#include "engine/dynamics/responder.hpp"
#include "engine/dynamics/stop_at_entry.hpp"
#include "engine/scheduling/priority_lists.hpp"
#include "engine/scheduling/workers.hpp"
#include "engine/world/step.hpp"

namespace impetus::inline world {

/// What pairs are measured by, in a step whose bodies are where they will be tested.
struct Measuring {
  const Schedule& schedule;
  const StepInput& input;
  const std::vector<BodyModel>& models;
  const std::vector<BodyState>& states;
};

/// The step's pairs in their lists and by priority, measured no sooner than somebody asks.
///
///   lists      one, or by the region: nothing is measured; by thresholds or shares: every pair is
///   order      only when pairs wait for work beyond the floor: of one list those that do, if more
///              than one does
///   measure    of a pair that touches, for the report
///
/// A pair's terms are computed when it is measured, and only those that the metric looks at. What
/// is measured depends on the state, so when it is measured changes nothing.
class StepOrder {
 public:
  /// Gives each of `candidates` its list; what was known before is forgotten. The candidates must
  /// stay as long as anything is asked of their order.
  void put_into_lists(std::vector<PairBounds>& candidates, const Measuring& by);

  /// With their lists, in an order that means nothing; lists may be changed.
  [[nodiscard]] std::vector<MeasuredPair>& pairs() { return pairs_; }

  /// Places in pairs(), by list and by falling priority within each, when those at `waiting` wait
  /// for work: of these where there is one list, else of all; none when none waits. Valid until the
  /// next call.
  std::span<const std::size_t> places_by_priority(std::span<const std::size_t> waiting,
                                                  const Measuring& by);

  /// All places, by list and by falling priority within each. Valid until the next call.
  std::span<const std::size_t> all_places_by_priority(const Measuring& by);

  /// All pairs as they are scheduled, by list and by falling priority within each, instead of what
  /// `listed` held. To be asked for once work was done by places_by_priority().
  void list_pairs(const Measuring& by, std::vector<ScheduledPair>& listed);

  /// What the metric says of the pair at that place, in its unit.
  double measured(std::size_t place, const Measuring& by);

 private:
  /// A pair and its place, side by side to be sorted.
  struct Ranked {
    MeasuredPair pair;
    std::size_t place;
  };

  void sort_places(const Measuring& by);
  [[nodiscard]] double measure(std::int32_t candidate, const Measuring& by);

  std::vector<PairBounds>* candidates_{nullptr};
  std::vector<MeasuredPair> pairs_;
  std::vector<std::size_t> places_;
  std::vector<Ranked> ranked_;
};

/// Pairs that are refined, in objects that are used again.
class RefinedPairs {
 public:
  void clear() {
    for (RefinedPair& pair : all()) {
      pair.refinement.give_memory_back();
    }
    count_ = 0;
  }

  /// Room for `pairs`, so far beyond it in a world of `bodies` that it is rarely moved later.
  void expect(std::size_t pairs, std::size_t bodies) {
    constexpr std::size_t kPairsOfABody = 32;
    if (pairs > pairs_.capacity()) {
      const std::size_t all_there_are = bodies * (bodies + 1) / 2;  // with walls
      pairs_.reserve(std::max(2 * pairs, std::min(kPairsOfABody * bodies, all_there_are)));
    }
  }

  RefinedPair& add() {
    if (count_ == pairs_.size()) {
      pairs_.emplace_back().refinement.take_memory_from(*store_);
    }
    return pairs_[count_++];
  }
  [[nodiscard]] std::span<RefinedPair> all() { return {pairs_.data(), count_}; }

 private:
  std::unique_ptr<NodeBlockStore> store_{std::make_unique<NodeBlockStore>()};
  std::vector<RefinedPair> pairs_;
  std::size_t count_{0};
};

/// The collisions as they are modelled, whoever is refined first.
class ModelledCollisions {
 public:
  void clear();

  /// The contacts of one refined pair are added here, at the end ...
  [[nodiscard]] std::vector<Contact>& contacts() { return contacts_; }

  /// ... and then become collisions, one for each run of the same bodies, in all else like `like`.
  void add_contacts_as(const CollisionReport& like);

  /// Reports the collisions by their bodies, and their contacts behind them; `contact` of each is
  /// its deepest, of equals the first.
  void report_in_order(StepReport& report);

 private:
  std::vector<CollisionReport> collisions_;
  std::vector<std::size_t> order_;  ///< memory for their places, by their bodies
  std::vector<Contact> contacts_;
  std::size_t taken_{0};  ///< contacts that are of a collision
};

/// A reported collision, by how much it is seen.
struct RankedCollision {
  int list;
  double priority;
  std::size_t place;
};

/// How deep the bounds of a pair reach into each other, where not all can be looked at.
struct PairDepth {
  double overlap_m;
  BodyPair pair;
};

/// What the phases of a step hand on to each other; kept between steps only to allocate nothing.
struct StepMemory {
  StepMemory() = default;
  StepMemory(const StepMemory& /*other*/) : StepMemory() {}
  StepMemory(StepMemory&&) = default;
  StepMemory& operator=(const StepMemory& other) {
    if (this != &other) {
      pairs.clear();
    }
    return *this;
  }
  StepMemory& operator=(StepMemory&&) = default;
  ~StepMemory() = default;

  std::shared_ptr<Workers> workers;  ///< lent by whoever steps the world; none: nobody helps

  // move
  std::vector<Fall> falls;  ///< by body; none without gravity
  std::vector<MovedBound> bounds;
  // pair
  BlockStore placed;              ///< lent to all trees anew, step by step
  std::vector<BodyPair> found;    ///< whose bounds touched on the way
  std::vector<PairDepth> depths;  ///< means nothing between steps
  std::vector<PairBounds> candidates;
  std::vector<PairBounds> stoppable;  ///< where there are figures: those that are of no part
  EntryMemory entries;  ///< its result is that of the last step in which bodies could be stopped
  // prioritise
  StepOrder order;
  // refine
  RefinedPairs refined;
  WorkSharing sharing;
  std::int64_t work_of_folds{0};     ///< of figures, which the floor pays for
  std::vector<ScheduledPair> pairs;  ///< by list and priority; only when they are watched
  // model
  ContactModelling modelling;
  ModelledCollisions modelled;
  // respond
  std::vector<RankedCollision> ranked_collisions;  ///< the most visible first; when asked for
  std::vector<std::size_t> by_visibility;          ///< contacts likewise
  std::vector<Contact> contacts;                   ///< that are responded to
  std::vector<double> restitutions;
  Responder responder;
  // remember
  std::vector<BodyPair> touching;

  StepReport report;
};

}  // namespace impetus::inline world
