// Lists by a region of the screen. (Dingliana 2002, sec. 6.3.1)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/scheduling/list_rules.hpp"

namespace impetus::inline scheduling {

/// A pair is in list 0 where the place of its collision projects inside the step's region; outside
/// it, or without a region, in list 1.
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

}  // namespace impetus::inline scheduling
