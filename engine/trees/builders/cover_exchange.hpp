// Betters a choice of candidate centres by exchanging one for another while that helps (the
// interchange heuristic of location problems, Teitz and Bart 1968).
//
// What is made small is the product of the greatest stand-off and the volume outside the solid:
// either alone is paid for with the other.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "engine/trees/builders/medial_balls.hpp"
#include "engine/trees/outside_points.hpp"

namespace impetus::inline trees {

/// Indices of candidates, as many as `chosen` or fewer where some stand for no point.
std::vector<std::size_t> exchanged(const OutsidePoints& outside, const std::vector<Vector3>& points,
                                   const std::vector<InnerPoint>& candidates,
                                   std::vector<std::size_t> chosen);

}  // namespace impetus::inline trees
