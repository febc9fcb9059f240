// SPDX-License-Identifier: MIT
#include "engine/trees/builders/volume_fits.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "engine/trees/minimal_ball.hpp"

namespace impetus::inline trees {
namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();
/// Of two volumes that reach as far, the smaller: a reach is worth this share of the extent.
constexpr double kExtentShare = 0.01;
/// The first turn that a search of frames tries (of small_turn()).
constexpr double kFirstTurn = 0.1;

/// Of points as a frame sees them.
Bounds bounds_in(const Matrix3& frame, const std::vector<Vector3>& points) {
  const Matrix3 to_frame = frame.transpose();
  const Vector3 first = to_frame * points.front();
  Bounds bounds{first, first};
  for (const Vector3& point : points) {
    bounds.include(to_frame * point);
  }
  return bounds;
}

/// The frame with its axes in another order, `first` first.
Matrix3 reordered(const Matrix3& frame, int first) {
  Matrix3 turned;
  turned << frame.col(first % 3), frame.col((first + 1) % 3), frame.col((first + 2) % 3);
  return turned;
}

/// The axis along which the points spread most comes first.
Matrix3 longest_first(const Matrix3& frame, const std::vector<Vector3>& points) {
  int longest = 0;
  bounds_in(frame, points).sides().maxCoeff(&longest);
  return reordered(frame, longest);
}

/// The axis along which the points spread least comes last.
Matrix3 shortest_last(const Matrix3& frame, const std::vector<Vector3>& points) {
  int shortest = 0;
  bounds_in(frame, points).sides().minCoeff(&shortest);
  return reordered(frame, shortest + 1);
}

/// What is made small: the reach, and the extent for a little. Any value above `enough` may be
/// returned once it is known to be exceeded.
double score_of(const Volume& volume, double extent_m, const FitTask& task, double enough) {
  const double price = kExtentShare * extent_m;
  const int questions = task.effort == Effort::kQuick ? 20 : 60;
  return price < enough ? price + reach_beyond_m(volume, task.solid, {questions, enough - price})
                        : price;
}

/// The rotation by the unit quaternion of (1, x, y, z).
Matrix3 small_turn(double x, double y, double z) {
  const double scale = 1.0 / std::sqrt(1.0 + x * x + y * y + z * z);
  return Quaternion(scale, scale * x, scale * y, scale * z).toRotationMatrix();
}

Sphere sphere_about(const Vector3& centre, const std::vector<Vector3>& points) {
  double squared_m2 = 0.0;
  for (const Vector3& point : points) {
    squared_m2 = std::max(squared_m2, (point - centre).squaredNorm());
  }
  return {centre, std::sqrt(squared_m2)};
}

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

Vector3 middle_across(const Vector3& axis, const std::vector<Vector3>& points) {
  std::vector<Vector3> across;
  across.reserve(points.size());
  for (const Vector3& point : points) {
    across.push_back(point - point.dot(axis) * axis);
  }
  return minimal_ball(across).centre;
}

/// One side of the rectangle, in the making.
struct Interval {
  double first{kUnreached};
  double last{-kUnreached};

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
  double lowest = kUnreached;
  double highest = -kUnreached;
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

constexpr int kRounds = 8;

Box box_along(const Matrix3& frame, const std::vector<Vector3>& points) {
  const Bounds within = bounds_in(frame, points);
  return {frame * within.middle(), 0.5 * within.sides(), Quaternion(frame).normalized()};
}

double share_along(const Vector3& half, const Vector3& offset) {
  const double length_squared = half.squaredNorm();
  return length_squared > 0.0 ? std::clamp(offset.dot(half) / length_squared, -1.0, 1.0) : 0.0;
}

double distance_to_core(const Sphere& sphere, const Vector3& point) {
  return (point - sphere.centre).norm();
}

double distance_to_core(const LineSwept& line, const Vector3& point) {
  const Vector3 offset = point - line.centre;
  return (offset - share_along(line.half_axis, offset) * line.half_axis).norm();
}

double distance_to_core(const RectangleSwept& rectangle, const Vector3& point) {
  const Vector3 offset = point - rectangle.centre;
  return (offset - share_along(rectangle.half_u, offset) * rectangle.half_u -
          share_along(rectangle.half_v, offset) * rectangle.half_v)
      .norm();
}

template <typename Swept>
void refit(Swept& swept, const std::vector<Vector3>& corners) {
  swept.radius_m = 0.0;
  for (const Vector3& corner : corners) {
    swept.radius_m = std::max(swept.radius_m, distance_to_core(swept, corner));
  }
}

void refit(Box& box, const std::vector<Vector3>& corners) {
  const Quaternion to_box = box.orientation.conjugate();
  const Vector3 first = to_box * (corners.front() - box.centre);
  Bounds within{first, first};
  for (const Vector3& corner : corners) {
    within.include(to_box * (corner - box.centre));
  }
  box.centre += box.orientation * within.middle();
  box.half_extents_m = 0.5 * within.sides();
}

void refit(Cube& cube, const std::vector<Vector3>& corners) {
  cube.half_edge_m = 0.0;
  for (const Vector3& corner : corners) {
    const Vector3 within = cube.orientation.conjugate() * (corner - cube.centre);
    cube.half_edge_m = std::max(cube.half_edge_m, within.cwiseAbs().maxCoeff());
  }
}

template <typename Swept>
void grow(Swept& swept, double by_m) {
  swept.radius_m += by_m;
}
void grow(Box& box, double by_m) { box.half_extents_m += Vector3::Constant(by_m); }
void grow(Cube& cube, double by_m) { cube.half_edge_m += by_m; }

bool holds_all(const Volume& volume, const std::vector<Vector3>& corners) {
  return std::all_of(corners.begin(), corners.end(),
                     [&](const Vector3& corner) { return holds(volume, corner); });
}

}  // namespace

Volume grown_to_hold(const Volume& volume, const std::vector<Vector3>& corners, double margin_m) {
  Volume grown = volume;
  std::visit([&](auto& kind) { refit(kind, corners); }, grown);
  double by_m = margin_m;
  std::visit([&](auto& kind) { grow(kind, by_m); }, grown);
  while (!holds_all(grown, corners)) {
    std::visit([&](auto& kind) { grow(kind, by_m); }, grown);
    by_m *= 2.0;
  }
  return grown;
}

// The sphere: round the points from where it reaches least beyond the object, which is often well
// inside it.
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

// The line-swept sphere: along the longest axis of a frame, as thin as the points allow and as
// short as its round ends allow, moved and tilted where that helps.
Fit fit_line(const FitTask& task) {
  const std::vector<Vector3>& points = task.shape->points;
  const auto score = [&](const LineSwept& line, double enough) {
    return score_of(line, line.radius_m + line.half_axis.norm(), task, enough);
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

// The rectangle-swept sphere: across the shortest axis of a frame, as thin as the points allow and
// as small as its round rim allows, turned and moved where that helps. (after Larsen et al. 1999)
Fit fit_rectangle(const FitTask& task) {
  const std::vector<Vector3>& points = task.shape->points;
  const auto score = [&](const RectangleSwept& rectangle, double enough) {
    const double extent_m = rectangle.radius_m + rectangle.half_u.norm() + rectangle.half_v.norm();
    return score_of(rectangle, extent_m, task, enough);
  };
  double least = kUnreached;
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

// The box: the best of the frames worth trying, then turned a little where that helps.
Fit fit_box(const FitTask& task) {
  const std::vector<Vector3>& points = task.shape->points;
  const auto score = [&](const Matrix3& frame, double enough) {
    const Box box = box_along(frame, points);
    return score_of(box, box.half_extents_m.sum(), task, enough);
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
