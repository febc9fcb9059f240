// Whether a figure's parts may be where they are: apart from each other, but where a hinge joins
// two, and none folded.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/figures/figure.hpp"

namespace impetus::inline scenes {

/// Whether a hinge of the figure joins the two bodies.
bool are_neighbours(const Figure& figure, std::int32_t a, std::int32_t b);

/// Whether the figure's own rules leave out the pair: both are its parts, and neighbours, or others
/// where self_collision has no others.
bool leaves_out(const Figure& figure, std::int32_t a, std::int32_t b);

/// The first hinge that the poses fold past its threshold, where neighbours may collide; else null.
const Hinge* folded_hinge(const Figure& figure, const std::vector<Pose>& poses);

}  // namespace impetus::inline scenes
