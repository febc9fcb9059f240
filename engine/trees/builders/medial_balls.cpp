// SPDX-License-Identifier: MIT
#include "engine/trees/builders/medial_balls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/shapes/triangle_distance.hpp"

namespace impetus::inline trees {
namespace {

/// The middles of the n² equal triangles that a triangle splits into.
void add_grid(const Triangle& triangle, int n, SurfaceSample sample,
              std::vector<SurfaceSample>& samples) {
  const Vector3 u = (triangle[1] - triangle[0]) / n;
  const Vector3 v = (triangle[2] - triangle[0]) / n;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; i + j < n; ++j) {
      const Vector3 corner = triangle[0] + i * u + j * v;
      sample.point = corner + (u + v) / 3.0;
      samples.push_back(sample);
      if (i + j + 1 < n) {
        sample.point = corner + 2.0 * (u + v) / 3.0;
        samples.push_back(sample);
      }
    }
  }
}

/// Of each small cube of space the corner farthest from the middle of them all.
void add_corners(const SurfacePart& part, double edge_m, std::vector<SurfaceSample>& samples) {
  Vector3 middle = Vector3::Zero();
  std::size_t count = 0;
  for (const Facet& facet : part) {
    for (const Vector3& corner : facet.corners) {
      middle += corner;
      ++count;
    }
  }
  middle /= static_cast<double>(count);
  std::map<std::array<std::int64_t, 3>, SurfaceSample> farthest;
  for (const Facet& facet : part) {
    for (const Vector3& corner : facet.corners) {
      std::array<std::int64_t, 3> cell{};
      for (int axis = 0; axis < 3; ++axis) {
        cell[static_cast<std::size_t>(axis)] = std::llround((corner[axis] - middle[axis]) / edge_m);
      }
      const SurfaceSample sample{corner, facet.normal.normalized(), facet.triangle};
      const auto [found, is_new] = farthest.try_emplace(cell, sample);
      if (!is_new &&
          (corner - middle).squaredNorm() > (found->second.point - middle).squaredNorm()) {
        found->second = sample;
      }
    }
  }
  for (const auto& [cell, sample] : farthest) {
    samples.push_back(sample);
  }
}

constexpr int kMostShrinkings = 12;
constexpr double kSettled = 1e-3;  ///< share of the radius

}  // namespace

std::vector<SurfaceSample> samples_of(const SurfacePart& part, std::size_t count) {
  std::vector<SurfaceSample> samples;
  const double each_m2 = area_m2(part) / static_cast<double>(std::max<std::size_t>(count, 1));
  double owed_m2 = 0.0;
  for (const Facet& facet : part) {
    for (std::size_t i = 1; i + 1 < facet.corners.size(); ++i) {
      const Triangle triangle{facet.corners[0], facet.corners[i], facet.corners[i + 1]};
      const Vector3 doubled = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
      const double area = 0.5 * doubled.norm();
      owed_m2 += area;
      if (!(area > 0.0) || (owed_m2 < each_m2 && !samples.empty())) {
        continue;
      }
      add_grid(triangle, std::max(1, static_cast<int>(std::lround(std::sqrt(area / each_m2)))),
               {Vector3::Zero(), doubled.normalized(), facet.triangle}, samples);
      owed_m2 = 0.0;
    }
  }
  return samples;
}

std::vector<SurfaceSample> samples_and_corners_of(const SurfacePart& part, std::size_t count) {
  std::vector<SurfaceSample> samples = samples_of(part, count);
  const double edge_m = std::sqrt(area_m2(part) / static_cast<double>(count));
  if (edge_m > 0.0) {
    add_corners(part, edge_m, samples);
  }
  return samples;
}

InnerPoint inner_point(const SurfaceDistance& surface, const Vector3& point, std::uint32_t near) {
  const SignedDistance found = surface.signed_distance(point, near);
  return {point, -found.distance_m, found.triangle};
}

InnerPoint medial_ball(const SurfaceDistance& surface, const SurfaceSample& sample, double size_m) {
  double radius_m = 0.5 * size_m;
  Vector3 centre = sample.point - radius_m * sample.normal;
  std::uint32_t near = sample.triangle;
  for (int turn = 0; turn < kMostShrinkings; ++turn) {
    const NearestOnSurface nearest = surface.nearest(centre, near);
    near = nearest.triangle;
    const Vector3 to_sample = sample.point - nearest.point;
    const double along = sample.normal.dot(to_sample);
    if (nearest.distance_m >= (1.0 - kSettled) * radius_m || !(along > 0.0)) {
      break;
    }
    // The ball that touches at the sample and passes through the nearest point.
    radius_m = to_sample.squaredNorm() / (2.0 * along);
    centre = sample.point - radius_m * sample.normal;
  }
  return inner_point(surface, centre, near);
}

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
