// Where a surface that moves straight on first touches another, by conservative advancement.
//
//   way ──> closest points there ──> move on by their distance: nothing can meet before ──> way
//
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "engine/shapes/triangle_distance.hpp"

namespace impetus::inline shapes {

struct FirstTouch {
  double way_m{0.0};      ///< how far the surface had moved
  ClosestPoints closest;  ///< just before the surfaces meet
};

/// The closest points of the surfaces once one has moved by `way_m`; 0 apart when they cross.
using ClosestAtWay = std::function<ClosestPoints(double way_m)>;

/// The first way at which the surfaces are within `gap_m` (> 0) of each other, and not less than
/// half of it; none when they are not before `farthest_m`, or cross at the start. A surface that
/// passes another so slowly by that 400 moves do not tell counts as passing it by.
/// (Mirtich 1996)
std::optional<FirstTouch> first_touch(const ClosestAtWay& closest_at, double gap_m,
                                      double farthest_m);

}  // namespace impetus::inline shapes
