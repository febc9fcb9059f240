// A crowd of blocks in a closed cube.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/extremes/extreme_scene.hpp"

namespace impetus::inline extremes {

/// Blocks in trees of `kind` at random places and orientations, flying at about 1 m/s, spinning at
/// about 5 rad/s; their bounding balls would fill `filled` of the cube. The same for the same
/// arguments.
ExtremeScene crowd_scene(int count, double filled, double restitution, std::int64_t steps,
                         TreeKind kind = TreeKind::kBox);

}  // namespace impetus::inline extremes
