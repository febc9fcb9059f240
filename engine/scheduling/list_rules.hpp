// Rules that put the pairs of a step into priority lists.
//
//   thresholds   what the metric measures of a pair, against limits
//   pair_shares  its rank by the metric among the step's pairs, against limits
//   region       whether it lies within the step's region
//
// Each is a class and a line of the table in list_rules.cpp: of one's own, a class alone.
// (Dingliana 2002, sec. 5.1.2 and 6.3.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scheduling/priority.hpp"

namespace impetus::inline scheduling {

/// A pair with its place in the schedule.
struct ScheduledPair {
  BodyPair pair;
  int list{0};
};

/// And with what orders it within its list: of larger priorities the pair that came first.
struct MeasuredPair {
  ScheduledPair scheduled;
  double priority{0.0};
  std::int32_t place{0};    ///< among the pairs as they came
  bool is_measured{false};  ///< whether the priority is known
};

/// Whether x has the higher priority: a total order. Of equal priorities the pair that came first
/// has it; what is not a number has it last.
inline bool has_priority(const MeasuredPair& x, const MeasuredPair& y) {
  const bool x_is_number = !std::isnan(x.priority);
  const bool y_is_number = !std::isnan(y.priority);
  if (x_is_number != y_is_number) {
    return x_is_number;
  }
  if (x_is_number && x.priority != y.priority) {
    return x.priority > y.priority;
  }
  return x.place < y.place;
}

/// What a rule may look at beside the pairs.
struct ListInput {
  const PriorityMetric& metric;
  const std::vector<double>& limits;  ///< Schedule::limits
  const Viewer& viewer;
  const std::optional<GazeRegion>& region;
};

/// What a rule may look at, as bits.
enum ListTerm : unsigned {
  kPriorityTerm = 1,  ///< MeasuredPair::priority: pairs are not measured for rules without it
  kRegionTerm = 2,    ///< ListInput::region
};

/// How scenes and panels speak of the limits that a rule parts the lists by (Schedule::limits).
struct ListLimits {
  std::string_view words;  ///< what a scene's limits mean, in one sentence
  double least{0.0};       ///< a limit's range in a scene
  double most{1.0};
  bool is_of_metric{false};       ///< in the metric's own unit: of another metric they mean nothing
  std::string_view in_panel;      ///< what lists are parted by, in a panel's choice
  std::string_view unit_words{};  ///< above a panel's limits; of the metric's, its unit is said
  std::string_view of_one;        ///< what one limit means, in one sentence
};

/// Decides which priority list a pair is put into.
class ListRule {
 public:
  virtual ~ListRule() = default;

  /// The terms that the rule looks at; all, unless it says less.
  [[nodiscard]] virtual unsigned terms() const { return kPriorityTerm | kRegionTerm; }

  /// What is to be said of Schedule::limits, one fewer than lists; null when it has none.
  [[nodiscard]] virtual const ListLimits* limits() const { return nullptr; }

  /// What is wrong with so many lists, and such limits of pairs measured by `metric`, as
  /// "expected ..., got ..."; empty when nothing is.
  [[nodiscard]] virtual std::string problem(std::size_t lists, const std::vector<double>& limits,
                                            const PriorityMetric& metric) const;

  /// Gives each of `pairs` its list, which is 0 until then, where there are several lists.
  /// `bounds[pair.place]` is what is known of the pair beside. Pairs may change their order.
  virtual void part(const std::vector<PairBounds>& bounds, const ListInput& input,
                    std::vector<MeasuredPair>& pairs) const = 0;
};

/// The rule called `name`, always the same. Throws std::invalid_argument that lists the names there
/// are.
std::shared_ptr<const ListRule> make_list_rule(std::string_view name);

/// The name that makes it; empty for one of a user's own.
std::string_view list_rule_name(const ListRule& rule);

/// The names make_list_rule() takes; the first is what a schedule does as it stands.
std::vector<std::string_view> list_rule_names();

/// Those of rules that part lists by limits: the keys by which scenes say them.
std::vector<std::string> limited_list_rule_names();

}  // namespace impetus::inline scheduling
