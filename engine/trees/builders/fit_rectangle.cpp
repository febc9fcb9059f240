// The rectangle-swept sphere: across the shortest axis of a frame, as thin as the points allow and
// as small as its round rim allows, turned and moved where that helps. (after Larsen et al. 1999)
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include "engine/trees/builders/compass_search.hpp"
#include "engine/trees/builders/reach_beyond.hpp"
#include "engine/trees/builders/volume_fits.hpp"

namespace impetus::inline trees {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

struct Interval {
  double first{kUnbounded};
  double last{-kUnbounded};

  void reach(double at, double slack) {
    first = std::min(first, at + slack);
    last = std::max(last, at - slack);
  }
  void close() {
    if (first > last) {
      first = last = 0.5 * (first + last);
    }
  }
  [[nodiscard]] double beyond(double at) const {
    return at < first ? at - first : at > last ? at - last : 0.0;
  }
};

/// Widens the sides until the round corner reaches a point that lies `u`, `v` beyond them.
void reach_corner(Interval& along, double u, double v, double slack) {
  const double distance = std::sqrt(u * u + v * v);
  if (distance <= slack) {
    return;
  }
  const double needed = std::fabs(u) - std::sqrt(std::max(0.0, slack * slack - v * v));
  if (u < 0.0) {
    along.first -= needed;
  } else {
    along.last += needed;
  }
}

/// In the frame's third axis the rectangle lies `shift_m` from the middle of the points.
RectangleSwept rectangle_along(const Matrix3& frame, double shift_m,
                               const std::vector<Vector3>& points) {
  const Matrix3 to_frame = frame.transpose();
  double lowest = kUnbounded;
  double highest = -kUnbounded;
  std::vector<Vector3> within;
  within.reserve(points.size());
  for (const Vector3& point : points) {
    within.emplace_back(to_frame * point);
    lowest = std::min(lowest, within.back().z());
    highest = std::max(highest, within.back().z());
  }
  const double height = 0.5 * (lowest + highest) + shift_m;
  const double radius_m = std::max(highest - height, height - lowest);
  const auto slack_of = [&](const Vector3& p) {
    return std::sqrt(std::max(0.0, radius_m * radius_m - (p.z() - height) * (p.z() - height)));
  };
  Interval u;
  Interval v;
  for (const Vector3& p : within) {
    u.reach(p.x(), slack_of(p));
    v.reach(p.y(), slack_of(p));
  }
  u.close();
  v.close();
  for (const Vector3& p : within) {
    const double u_beyond = u.beyond(p.x());
    const double v_beyond = v.beyond(p.y());
    // The side that needs the least widening; both stay right for the points before.
    Interval& widened = std::fabs(u_beyond) <= std::fabs(v_beyond) ? u : v;
    const bool is_u = &widened == &u;
    reach_corner(widened, is_u ? u_beyond : v_beyond, is_u ? v_beyond : u_beyond, slack_of(p));
  }
  const Vector3 centre(0.5 * (u.first + u.last), 0.5 * (v.first + v.last), height);
  return {frame * centre, 0.5 * (u.last - u.first) * frame.col(0),
          0.5 * (v.last - v.first) * frame.col(1), radius_m};
}

/// The frame with its axes in another order: the one along which the points spread least last.
Matrix3 shortest_last(const Matrix3& frame, const std::vector<Vector3>& points) {
  Vector3 least = frame.transpose() * points.front();
  Vector3 most = least;
  for (const Vector3& point : points) {
    const Vector3 within = frame.transpose() * point;
    least = least.cwiseMin(within);
    most = most.cwiseMax(within);
  }
  int shortest = 0;
  (most - least).minCoeff(&shortest);
  Matrix3 turned;
  turned << frame.col((shortest + 1) % 3), frame.col((shortest + 2) % 3), frame.col(shortest);
  return turned;
}

}  // namespace

Fit fit_rectangle(const FitTask& task) {
  const std::vector<Vector3>& points = task.shape->points;
  const int questions = questions_of(task.effort);
  const auto score = [&](const RectangleSwept& rectangle, double enough) {
    const double extent =
        kExtentShare * (rectangle.radius_m + rectangle.half_u.norm() + rectangle.half_v.norm());
    return extent < enough
               ? extent + reach_beyond_m(rectangle, task.solid, {questions, enough - extent})
               : extent;
  };
  double least = kUnbounded;
  Matrix3 start = Matrix3::Identity();
  for (const Matrix3& tried : task.frames) {
    const Matrix3 turned = shortest_last(tried, points);
    const double got = score(rectangle_along(turned, 0.0, points), least);
    if (got < least) {
      least = got;
      start = turned;
    }
  }
  const double radius_m = rectangle_along(start, 0.0, points).radius_m;
  const auto frame_of = [&](const std::array<double, 4>& by) {
    return Matrix3(start * small_turn(by[0], by[1], by[2]));
  };
  const auto moved = [&](const std::array<double, 4>& by) {
    return rectangle_along(frame_of(by), by[3], points);
  };
  const int rounds = task.effort == Effort::kCareful ? 12 : 0;
  const std::array<double, 4> by =
      compass_search<4>({kFirstTurn, kFirstTurn, kFirstTurn, 0.4 * radius_m}, rounds,
                        [&](const std::array<double, 4>& tried, double enough) {
                          return score(moved(tried), enough);
                        });
  const RectangleSwept rectangle = moved(by);
  return {rectangle, reach_beyond_m(rectangle, task.solid), frame_of(by)};
}

}  // namespace impetus::inline trees
