// The middle of what two cores share: of segments the middle of their overlap, of rectangles and
// faces the centroid of the overlap's polygon, of blocks that of the overlap itself.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/volumes/core.hpp"

namespace impetus::inline volumes {

/// The centroid of the points that lie in both cores, each grown by `tolerance_m`; none when no
/// such point is found. The region may have any dimension.
std::optional<Vector3> centroid_of_shared(const Core& a, const Core& b, double tolerance_m);

}  // namespace impetus::inline volumes
