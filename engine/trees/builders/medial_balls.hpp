// What spheres are fitted by: points that stand for a piece of surface, the balls of the medial
// axis at them, the largest within the solid that touch its surface at a given point, and points
// outside it.
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

/// A point of the surface that stands for what is about it.
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

/// How much of a sphere lies outside a solid, estimated from a grid of points outside it.
class OutsidePoints {
 public:
  /// Of nothing: every ball has no volume outside.
  OutsidePoints() = default;

  /// About `count` grid points over a cube about `points` that holds any sensible sphere round
  /// them; those outside are kept.
  OutsidePoints(const SurfaceDistance& surface, const std::vector<Vector3>& points,
                std::size_t count);

  /// Volume of the ball that is outside the solid (m³); what lies beyond the grid does not count.
  [[nodiscard]] double volume_m3(const Vector3& centre, double radius_m) const;

  /// The same for many radii: element i for radius i * step_m.
  [[nodiscard]] std::vector<double> volumes_m3(const Vector3& centre, double step_m,
                                               std::size_t steps) const;

 private:
  std::vector<Eigen::Vector3f> points_;  ///< an estimate needs no more

  double each_m3_{0.0};
};

}  // namespace impetus::inline trees
