// Points that stand for a piece of surface while a volume is being fitted to it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/trees/surface_part.hpp"

namespace impetus::inline trees {

struct SurfaceSample {
  Vector3 point;
  Vector3 normal;  ///< outward, unit
  std::uint32_t triangle{0};
};

/// About `count` points spread evenly over the part, in the order of its facets: large facets hold
/// a grid each, small ones share a point. Never none for a part with a facet of some area.
std::vector<SurfaceSample> samples_of(const SurfacePart& part, std::size_t count);

/// samples_of(), and about as many of the corners, which decide what a sphere has to reach: of each
/// small cube of space the corner farthest from the middle of them all.
std::vector<SurfaceSample> samples_and_corners_of(const SurfacePart& part, std::size_t count);

}  // namespace impetus::inline trees
