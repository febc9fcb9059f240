// How much of a sphere lies outside a solid, estimated from a grid of points outside it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "engine/shapes/surface_distance.hpp"

namespace impetus::inline trees {

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
