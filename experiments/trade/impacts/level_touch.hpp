// Where the bounds of two bodies first touch, at a level, when one moves straight on.
//
//   nodes of a ──way──►  nodes of b      convex volumes overlap for one stretch of the way; a pair
//                                        of nodes counts once the pairs above it overlap too
//
// The way is found exactly, pair by pair; pairs that cannot be the first are passed over. Of convex
// volumes the distance is a convex function of the way, so Newton's steps never go too far.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/collision/placed_tree.hpp"

namespace impetus::inline trade {

/// How far (metres, 0 or more) `a` moves along `direction` (unit), unturned, from where it is
/// placed until nodes that a refinement to `level` would test overlap; none when the bounds pass
/// each other by. Precondition: the roots are apart where `a` is placed.
std::optional<double> first_touch_of_bounds(PlacedTree& a, PlacedTree& b, const Vector3& direction,
                                            int level);

}  // namespace impetus::inline trade
