// Balls of the medial axis: the largest within the solid that touch its surface at a given point.
//
//   a ball that touches at p is shrunk until nothing of the surface lies within it (Ma, Bae and
//   Choi 2012, the shrinking ball)
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/shapes/surface_distance.hpp"
#include "engine/trees/builders/surface_samples.hpp"

namespace impetus::inline trees {

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
