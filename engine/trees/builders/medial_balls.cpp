// SPDX-License-Identifier: MIT
#include "engine/trees/builders/medial_balls.hpp"

namespace impetus::inline trees {
namespace {

constexpr int kMostShrinkings = 12;
constexpr double kSettled = 1e-3;  ///< share of the radius

}  // namespace

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

}  // namespace impetus::inline trees
