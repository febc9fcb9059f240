// The line-swept sphere: along the longest axis of a frame, as thin as the points allow and as
// short as its round ends allow, moved and tilted where that helps.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include "engine/trees/builders/compass_search.hpp"
#include "engine/trees/builders/reach_beyond.hpp"
#include "engine/trees/builders/volume_fits.hpp"
#include "engine/trees/minimal_ball.hpp"

namespace impetus::inline trees {
namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();

/// About the line through `on_line` along `axis` (unit).
LineSwept line_along(const Vector3& axis, const Vector3& on_line,
                     const std::vector<Vector3>& points) {
  double squared_m2 = 0.0;
  for (const Vector3& point : points) {
    squared_m2 = std::max(squared_m2, (point - on_line).cross(axis).squaredNorm());
  }
  double first_m = kUnreached;
  double last_m = -kUnreached;
  for (const Vector3& point : points) {
    const double along_m = (point - on_line).dot(axis);
    const double left_m2 = squared_m2 - (point - on_line).cross(axis).squaredNorm();
    const double slack_m = std::sqrt(std::max(0.0, left_m2));
    first_m = std::min(first_m, along_m + slack_m);
    last_m = std::max(last_m, along_m - slack_m);
  }
  const double half_m = std::max(0.0, 0.5 * (last_m - first_m));
  return {on_line + 0.5 * (first_m + last_m) * axis, half_m * axis, std::sqrt(squared_m2)};
}

/// The frame with its axes in another order: the one along which the points spread most first.
Matrix3 longest_first(const Matrix3& frame, const std::vector<Vector3>& points) {
  Vector3 least = frame.transpose() * points.front();
  Vector3 most = least;
  for (const Vector3& point : points) {
    const Vector3 within = frame.transpose() * point;
    least = least.cwiseMin(within);
    most = most.cwiseMax(within);
  }
  int longest = 0;
  (most - least).maxCoeff(&longest);
  Matrix3 turned;
  turned << frame.col(longest), frame.col((longest + 1) % 3), frame.col((longest + 2) % 3);
  return turned;
}

Vector3 middle_across(const Vector3& axis, const std::vector<Vector3>& points) {
  std::vector<Vector3> across;
  across.reserve(points.size());
  for (const Vector3& point : points) {
    across.push_back(point - point.dot(axis) * axis);
  }
  return minimal_ball(across).centre;
}

}  // namespace

Fit fit_line(const FitTask& task) {
  const std::vector<Vector3>& points = task.shape->points;
  const int questions = questions_of(task.effort);
  const auto score = [&](const LineSwept& line, double enough) {
    const double extent = kExtentShare * (line.radius_m + line.half_axis.norm());
    return extent < enough ? extent + reach_beyond_m(line, task.solid, {questions, enough - extent})
                           : extent;
  };
  double least = kUnreached;
  Matrix3 frame = Matrix3::Identity();
  Vector3 middle = Vector3::Zero();
  for (const Matrix3& tried : task.frames) {
    const Matrix3 turned = longest_first(tried, points);
    const Vector3 on_line = middle_across(turned.col(0), points);
    const double got = score(line_along(turned.col(0), on_line, points), least);
    if (got < least) {
      least = got;
      frame = turned;
      middle = line_along(turned.col(0), on_line, points).centre;
    }
  }
  const double radius_m = line_along(frame.col(0), middle, points).radius_m;
  const auto moved = [&](const std::array<double, 4>& by) {
    const Vector3 axis = frame * small_turn(0.0, by[2], by[3]).col(0);
    return line_along(axis, middle + frame * Vector3(0.0, by[0], by[1]), points);
  };
  const int rounds = task.effort == Effort::kCareful ? 16 : 4;
  const LineSwept line = moved(compass_search<4>(
      {0.4 * radius_m, 0.4 * radius_m, kFirstTurn, kFirstTurn}, rounds,
      [&](const std::array<double, 4>& by, double enough) { return score(moved(by), enough); }));
  return {line, reach_beyond_m(line, task.solid), frame};
}

}  // namespace impetus::inline trees
