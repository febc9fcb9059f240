// SPDX-License-Identifier: MIT
#include "engine/scheduling/list_rules.hpp"

#include <algorithm>
#include <cmath>

#include "engine/numerics/at.hpp"
#include "engine/scheduling/named_kinds.hpp"
#include "engine/scheduling/solved_thresholds.hpp"

namespace impetus::inline scheduling {
namespace {

/// A pair falls into the first list whose limit it meets, or else into the last. Limits are in the
/// metric's own unit, from high priority to low. (Dingliana 2002, sec. 5.1.2)
class ThresholdLists final : public ListRule {
 public:
  [[nodiscard]] unsigned terms() const override { return kPriorityTerm; }
  [[nodiscard]] const ListLimits* limits() const override {
    static constexpr ListLimits limits{
        .words = "One fewer than lists, in the metric's own unit, from high priority to low.",
        .least = -1e9,
        .most = 1e9,
        .is_of_metric = true,
        .in_panel = "thresholds of the metric",
        .of_one = "Pairs up to this measure fall into this list, the others into a later one."};
    return &limits;
  }

  [[nodiscard]] std::string problem(std::size_t lists, const std::vector<double>& limits,
                                    const PriorityMetric& metric) const override {
    if (limits.size() != lists - 1) {
      return "expected " + std::to_string(lists - 1) + " thresholds, got " +
             std::to_string(limits.size());
    }
    for (std::size_t i = 0; i < limits.size(); ++i) {
      if (!std::isfinite(limits[i]) || (i > 0 && !metric.meets(limits[i - 1], limits[i]))) {
        return "expected finite thresholds from high priority to low, got " +
               std::to_string(limits[i]) + " as number " + std::to_string(i + 1);
      }
    }
    return "";
  }

  void part(const std::vector<PairBounds>& /*bounds*/, const ListInput& input,
            std::vector<MeasuredPair>& pairs) const override {
    for (MeasuredPair& pair : pairs) {
      const double measured = input.metric.priority(pair.priority);  // its sign turned back
      int& list = pair.scheduled.list;
      while (at(list) < input.limits.size() &&
             !input.metric.meets(measured, input.limits[at(list)])) {
        ++list;
      }
    }
  }
};

/// A pair's rank by the metric decides. Each limit is the share of the step's pairs that its list
/// takes, in [0, 1], together at most 1. Of equal measures the pair first in the broad phase's
/// order has the higher rank, so a share may part them.
class ShareLists final : public ListRule {
 public:
  [[nodiscard]] unsigned terms() const override { return kPriorityTerm; }
  [[nodiscard]] const ListLimits* limits() const override {
    static constexpr ListLimits limits{
        .words =
            "In place of thresholds: the share of a step's pairs that each list but the last "
            "takes, together at most 1.",
        .least = 0.0,
        .most = 1.0,
        .in_panel = "shares of the pairs",
        .unit_words = "of pairs",
        .of_one = "The share of a step's pairs that falls into this list."};
    return &limits;
  }

  [[nodiscard]] std::string problem(std::size_t lists, const std::vector<double>& limits,
                                    const PriorityMetric& /*metric*/) const override {
    return limits.size() == lists - 1 ? problem_of_shares(limits)
                                      : "expected " + std::to_string(lists - 1) +
                                            " pair shares, got " + std::to_string(limits.size());
  }

  void part(const std::vector<PairBounds>& /*bounds*/, const ListInput& input,
            std::vector<MeasuredPair>& pairs) const override {
    std::sort(pairs.begin(), pairs.end(), has_priority);
    std::size_t first = 0;
    double sum = 0.0;
    for (std::size_t list = 0; list <= input.limits.size(); ++list) {
      const bool is_last = list == input.limits.size();
      sum += is_last ? 0.0 : input.limits[list];
      const std::size_t end = is_last ? pairs.size() : cut_at(sum, pairs.size());
      for (; first < end; ++first) {
        pairs[first].scheduled.list = static_cast<int>(list);
      }
    }
  }
};

/// A pair is in list 0 where the place of its collision projects inside the step's region; outside
/// it, or without a region, in list 1. (Dingliana 2002, sec. 6.3.1)
class RegionLists final : public ListRule {
 public:
  [[nodiscard]] unsigned terms() const override { return kRegionTerm; }

  [[nodiscard]] std::string problem(std::size_t lists, const std::vector<double>& limits,
                                    const PriorityMetric& metric) const override {
    return lists == 2 ? ListRule::problem(lists, limits, metric)
                      : "expected two lists for a region, got " + std::to_string(lists);
  }

  void part(const std::vector<PairBounds>& bounds, const ListInput& input,
            std::vector<MeasuredPair>& pairs) const override {
    for (MeasuredPair& pair : pairs) {
      const PairBounds& bound = bounds[static_cast<std::size_t>(pair.place)];
      pair.scheduled.list = input.region && holds(*input.region, bound, input.viewer) ? 0 : 1;
    }
  }

 private:
  static bool holds(const GazeRegion& region, const PairBounds& bounds, const Viewer& viewer) {
    const Vector3 centre = on_screen(viewer, region.centre);
    return visual_angle_deg(viewer, collision_place(bounds), centre) <= region.radius_deg;
  }
};

const NamedKinds<ListRule>& all_list_rules() {
  static const NamedKinds<ListRule> all("list rule",
                                        {{"thresholds", std::make_shared<const ThresholdLists>()},
                                         {"pair_shares", std::make_shared<const ShareLists>()},
                                         {"region", std::make_shared<const RegionLists>()}});
  return all;
}

}  // namespace

std::string ListRule::problem(std::size_t /*lists*/, const std::vector<double>& limits,
                              const PriorityMetric& /*metric*/) const {
  return limits.empty() ? "" : "expected no limits, got " + std::to_string(limits.size());
}

std::shared_ptr<const ListRule> make_list_rule(std::string_view name) {
  return all_list_rules().called(name);
}

std::string_view list_rule_name(const ListRule& rule) { return all_list_rules().name(rule); }

std::vector<std::string_view> list_rule_names() { return all_list_rules().names(); }

std::vector<std::string> limited_list_rule_names() {
  std::vector<std::string> limited;
  for (const std::string_view name : list_rule_names()) {
    if (make_list_rule(name)->limits() != nullptr) {
      limited.emplace_back(name);
    }
  }
  return limited;
}

}  // namespace impetus::inline scheduling
