// Points that stand for a piece of surface while spheres are fitted to it, and the balls of the
// medial axis at them: the largest within the solid that touch its surface at a given point.
//
//   a ball that touches at p is shrunk until nothing of the surface lies within it (Ma, Bae and
//   Choi 2012, the shrinking ball)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/shapes/surface_distance.hpp"
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

/// A place for a sphere's centre, and how far within the solid it lies.
struct InnerPoint {
  Vector3 point{Vector3::Zero()};
  double depth_m{0.0};       ///< minus the signed distance; negative outside
  std::uint32_t nearest{0};  ///< the triangle that the depth is measured to
};

/// `point` with its depth; quicker when `near` is a triangle near it.
InnerPoint inner_point(const SurfaceDistance& surface, const Vector3& point,
                       std::uint32_t near = 0);

/// The centre of the medial ball that touches the surface at `sample`; `size_m` bounds the solid.
InnerPoint medial_ball(const SurfaceDistance& surface, const SurfaceSample& sample, double size_m);

}  // namespace impetus::inline trees
