// The box: the best of the frames worth trying, then turned a little where that helps.
// SPDX-License-Identifier: MIT
#include "engine/trees/builders/compass_search.hpp"
#include "engine/trees/builders/reach_beyond.hpp"
#include "engine/trees/builders/volume_fits.hpp"

namespace impetus::inline trees {
namespace {

constexpr int kRounds = 8;

struct Extents {
  Vector3 centre;
  Vector3 half;
};

Extents extents_along(const Matrix3& frame, const std::vector<Vector3>& points) {
  const Matrix3 to_frame = frame.transpose();
  Vector3 least = to_frame * points.front();
  Vector3 most = least;
  for (const Vector3& point : points) {
    const Vector3 within = to_frame * point;
    least = least.cwiseMin(within);
    most = most.cwiseMax(within);
  }
  return {frame * (0.5 * (least + most)), 0.5 * (most - least)};
}

Box box_along(const Matrix3& frame, const std::vector<Vector3>& points) {
  const auto [centre, half] = extents_along(frame, points);
  return {centre, half, Quaternion(frame).normalized()};
}

}  // namespace

Fit fit_box(const FitTask& task) {
  const std::vector<Vector3>& points = task.shape->points;
  const int questions = questions_of(task.effort);
  const auto score = [&](const Matrix3& frame, double enough) {
    const Box box = box_along(frame, points);
    const double extent = kExtentShare * box.half_extents_m.sum();
    return extent < enough ? extent + reach_beyond_m(box, task.solid, {questions, enough - extent})
                           : extent;
  };
  Matrix3 best = task.frames.front();
  double least = score(best, 1e300);
  for (const Matrix3& frame : task.frames) {
    const double got = score(frame, least);
    if (got < least) {
      least = got;
      best = frame;
    }
  }
  if (task.effort == Effort::kCareful) {
    const Matrix3 start = best;
    const auto turned = [&](const std::array<double, 3>& by) {
      return Matrix3(start * small_turn(by[0], by[1], by[2]));
    };
    best = turned(compass_search<3>(
        {kFirstTurn, kFirstTurn, kFirstTurn}, kRounds,
        [&](const std::array<double, 3>& by, double enough) { return score(turned(by), enough); }));
  }
  const Box box = box_along(best, points);
  return {box, reach_beyond_m(box, task.solid), best};
}

}  // namespace impetus::inline trees
