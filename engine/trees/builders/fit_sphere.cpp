// The sphere: round the points from where it reaches least beyond the object, which is often well
// inside it.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "engine/trees/builders/compass_search.hpp"
#include "engine/trees/builders/reach_beyond.hpp"
#include "engine/trees/builders/volume_fits.hpp"
#include "engine/trees/minimal_ball.hpp"

namespace impetus::inline trees {
namespace {

Sphere sphere_about(const Vector3& centre, const std::vector<Vector3>& points) {
  double squared_m2 = 0.0;
  for (const Vector3& point : points) {
    squared_m2 = std::max(squared_m2, (point - centre).squaredNorm());
  }
  return {centre, std::sqrt(squared_m2)};
}

}  // namespace

Fit fit_sphere(const FitTask& task) {
  const std::vector<Vector3>& points = task.shape->points;
  const auto score = [&](const Vector3& centre) {
    const Sphere sphere = sphere_about(centre, points);
    return reach_beyond_m(sphere, task.solid) + kExtentShare * sphere.radius_m;
  };
  const Sphere ball = minimal_ball(points);
  Vector3 start = ball.centre;
  double least = score(start);
  for (const double depth : {0.25, 0.5, 1.0, 2.0, 4.0, 8.0}) {
    const Vector3 deeper = ball.centre - depth * ball.radius_m * task.shape->facing;
    const double got = score(deeper);
    if (got < least) {
      least = got;
      start = deeper;
    }
  }
  const int rounds = task.effort == Effort::kCareful ? 24 : 6;
  const double step_m = 0.4 * ball.radius_m;
  const auto moved = [&](const std::array<double, 3>& by) {
    return Vector3(start + task.shape->axes * Vector3(by[0], by[1], by[2]));
  };
  const Vector3 centre = moved(
      compass_search<3>({step_m, step_m, step_m}, rounds,
                        [&](const std::array<double, 3>& by, double) { return score(moved(by)); }));
  const Sphere sphere = sphere_about(centre, points);
  return {sphere, reach_beyond_m(sphere, task.solid), task.shape->axes};
}

}  // namespace impetus::inline trees
