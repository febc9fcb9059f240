// SPDX-License-Identifier: MIT
#include "engine/trees/outside_points.hpp"

#include <cmath>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline trees {

OutsidePoints::OutsidePoints(const SurfaceDistance& surface, const std::vector<Vector3>& points,
                             std::size_t count) {
  const Bounds bounds = bounds_of(points);
  const Vector3 half = Vector3::Constant(0.75 * bounds.sides().maxCoeff());
  const Vector3 least = bounds.middle() - half;
  const Vector3 most = bounds.middle() + half;
  const double edge_m = cube_root((most - least).prod() / static_cast<double>(count));
  each_m3_ = edge_m * edge_m * edge_m;
  Vector3 point;
  for (point.z() = least.z() + 0.5 * edge_m; point.z() < most.z(); point.z() += edge_m) {
    for (point.y() = least.y() + 0.5 * edge_m; point.y() < most.y(); point.y() += edge_m) {
      double known_until = least.x();  // the row is on one side of the surface up to here
      bool outside = false;
      for (point.x() = least.x() + 0.5 * edge_m; point.x() < most.x(); point.x() += edge_m) {
        if (point.x() >= known_until) {
          const double distance_m = surface.signed_distance_m(point);
          outside = distance_m > 0.0;
          known_until = point.x() + std::fabs(distance_m);
        }
        if (outside) {
          points_.emplace_back(point.cast<float>());
        }
      }
    }
  }
}

double OutsidePoints::volume_m3(const Vector3& centre, double radius_m) const {
  const Eigen::Vector3f middle = centre.cast<float>();
  const auto reach = static_cast<float>(radius_m * radius_m);
  std::size_t within = 0;
  for (const Eigen::Vector3f& point : points_) {
    within += (point - middle).squaredNorm() <= reach ? 1U : 0U;
  }
  return each_m3_ * static_cast<double>(within);
}

std::vector<double> OutsidePoints::volumes_m3(const Vector3& centre, double step_m,
                                              std::size_t steps) const {
  std::vector<double> volumes(steps, 0.0);
  const Eigen::Vector3f middle = centre.cast<float>();
  for (const Eigen::Vector3f& point : points_) {
    const double distance_m = static_cast<double>((point - middle).norm());
    const auto bin = static_cast<std::size_t>(distance_m / step_m) + 1;
    if (bin < steps) {
      volumes[bin] += each_m3_;
    }
  }
  for (std::size_t i = 1; i < steps; ++i) {
    volumes[i] += volumes[i - 1];
  }
  return volumes;
}

}  // namespace impetus::inline trees
