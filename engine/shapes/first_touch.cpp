// SPDX-License-Identifier: MIT
#include "engine/shapes/first_touch.hpp"

namespace impetus::inline shapes {

std::optional<FirstTouch> first_touch(const ClosestAtWay& closest_at, double gap_m,
                                      double farthest_m) {
  constexpr int kMostMoves = 400;
  double way_m = 0.0;
  for (int move = 0; move < kMostMoves && way_m <= farthest_m; ++move) {
    const ClosestPoints closest = closest_at(way_m);
    if (closest.distance_m <= gap_m) {
      return closest.distance_m > 0.0 ? std::optional(FirstTouch{way_m, closest}) : std::nullopt;
    }
    way_m += closest.distance_m - 0.5 * gap_m;
  }
  return std::nullopt;
}

}  // namespace impetus::inline shapes
