// SPDX-License-Identifier: MIT
#include "engine/volumes/core_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/numerics/few.hpp"

namespace impetus::inline volumes {
namespace {

constexpr double kRounding = 1e-13;
/// Squared sine of the angle below which two axes count as parallel.
constexpr double kParallelAxes = 1e-12;

double size_m(const Core& a, const Core& b) {
  return (b.centre - a.centre).cwiseAbs().sum() + a.half_m.sum() + b.half_m.sum();
}

/// Core b seen from the frame of core a.
struct Relative {
  Relative(const Core& a, const Core& b)
      : half_a(a.half_m),
        half_b(b.half_m),
        turn(a.axes.transpose() * b.axes),
        sizes(turn.cwiseAbs()),
        offset_in_a(a.axes.transpose() * (b.centre - a.centre)),
        offset_in_b(turn.transpose() * offset_in_a) {}

  [[nodiscard]] double gap_a(int i) const {
    return std::abs(offset_in_a[i]) - half_a[i] - sizes.row(i).dot(half_b);
  }
  [[nodiscard]] double gap_b(int j) const {
    return std::abs(offset_in_b[j]) - half_b[j] - sizes.col(j).dot(half_a);
  }
  /// Along the product of a's axis i and b's axis j, times that product's length.
  [[nodiscard]] double gap_product(int i, int j) const {
    const int i1 = (i + 1) % 3;
    const int i2 = (i + 2) % 3;
    const int j1 = (j + 1) % 3;
    const int j2 = (j + 2) % 3;
    return std::abs(offset_in_a[i2] * turn(i1, j) - offset_in_a[i1] * turn(i2, j)) -
           half_a[i1] * sizes(i2, j) - half_a[i2] * sizes(i1, j) - half_b[j1] * sizes(i, j2) -
           half_b[j2] * sizes(i, j1);
  }

  Vector3 half_a;
  Vector3 half_b;
  Matrix3 turn;
  Matrix3 sizes;
  Vector3 offset_in_a;
  Vector3 offset_in_b;
};

/// Times what rounding can do to a distance: closer than this the cores meet.
constexpr double kMeeting = 100.0;
/// Squared sine of the angle below which two edges count as parallel.
constexpr double kParallelCores = 1e-16;

/// The points centre + s half, |s| ≤ 1.
struct Edge {
  Vector3 centre;
  Vector3 half;
};

ClosestOfCores between(const Vector3& on_a, const Vector3& on_b) {
  return {on_a, on_b, (on_a - on_b).squaredNorm()};
}

/// Of edges with length. Ericson 2005, sec. 5.1.9, about the centres.
ClosestOfCores between_edges(const Edge& a, const Edge& b) {
  const Vector3 offset = a.centre - b.centre;
  const double aa = a.half.squaredNorm();
  const double bb = b.half.squaredNorm();
  const double ab = a.half.dot(b.half);
  const double a_offset = a.half.dot(offset);
  const double b_offset = b.half.dot(offset);
  const double spread = aa * bb - ab * ab;
  double s = 0.0;
  if (spread > kParallelCores * aa * bb) {
    s = std::clamp((ab * b_offset - a_offset * bb) / spread, -1.0, 1.0);
  }
  const double t = (ab * s + b_offset) / bb;
  const double t_within = std::clamp(t, -1.0, 1.0);
  if (t != t_within) {
    s = std::clamp((ab * t_within - a_offset) / aa, -1.0, 1.0);
  }
  return between(a.centre + s * a.half, b.centre + t_within * b.half);
}

/// Corner number `index`: bit i is the side along axis i.
Vector3 corner(const Core& core, int index) {
  Vector3 place = core.centre;
  for (int axis = 0; axis < core.dimension; ++axis) {
    const double side = (index >> axis & 1) != 0 ? core.half_m[axis] : -core.half_m[axis];
    place += side * core.axes.col(axis);
  }
  return place;
}

/// The edges of a core: `1 << (dimension - 1)` along each axis.
Few<Edge, 12> edges_of(const Core& core) {
  Few<Edge, 12> edges;
  for (int axis = 0; axis < core.dimension; ++axis) {
    const Vector3 half = core.half_m[axis] * core.axes.col(axis);
    for (int index = 0; index < 1 << core.dimension; ++index) {
      if ((index >> axis & 1) == 0) {
        edges.add({corner(core, index) + half, half});
      }
    }
  }
  return edges;
}

/// Keeps the closest of the pairs of points it is offered.
class Search {
 public:
  explicit Search(double enough_m) : enough_squared_(enough_m * enough_m) {
    best_.squared_m2 = std::numeric_limits<double>::infinity();
  }
  void offer(const ClosestOfCores& points) {
    if (points.squared_m2 < best_.squared_m2) {
      best_ = points;
    }
  }
  [[nodiscard]] bool done() const { return best_.squared_m2 <= enough_squared_; }
  [[nodiscard]] const ClosestOfCores& best() const { return best_; }

 private:
  double enough_squared_;
  ClosestOfCores best_;
};

void try_corners(const Core& a, const Core& b, Search& search) {
  for (int index = 0; index < 1 << a.dimension; ++index) {
    const Vector3 of_a = corner(a, index);
    search.offer(between(of_a, nearest_point(b, of_a)));
  }
  for (int index = 0; index < 1 << b.dimension; ++index) {
    const Vector3 of_b = corner(b, index);
    search.offer(between(nearest_point(a, of_b), of_b));
  }
}

bool are_points_or_segments(const Core& a, const Core& b) {
  return a.dimension == 0 || b.dimension == 0 || (a.dimension == 1 && b.dimension == 1);
}

ClosestOfCores of_points_or_segments(const Core& a, const Core& b) {
  if (a.dimension == 0) {
    return between(a.centre, nearest_point(b, a.centre));
  }
  if (b.dimension == 0) {
    return between(nearest_point(a, b.centre), b.centre);
  }
  return between_edges({a.centre, a.half_m[0] * a.axes.col(0)},
                       {b.centre, b.half_m[0] * b.axes.col(0)});
}

/// Ends early at points within `enough_m`.
/// Precondition: the cores do not cross, or are points or segments.
ClosestOfCores closest_features(const Core& a, const Core& b, double enough_m) {
  if (are_points_or_segments(a, b)) {
    return of_points_or_segments(a, b);
  }
  Search search(enough_m);
  try_corners(a, b, search);
  const Few<Edge, 12> of_b = edges_of(b);
  for (const Edge& edge_a : edges_of(a)) {
    for (const Edge& edge_b : of_b) {
      if (search.done()) {
        return search.best();
      }
      search.offer(between_edges(edge_a, edge_b));
    }
  }
  return search.best();
}

}  // namespace

double rounding_slack_m(const Core& a, const Core& b) { return kRounding * size_m(a, b); }

bool are_separated(const Core& a, const Core& b, double distance_m) {
  const Relative pair(a, b);
  const double slack = rounding_slack_m(a, b);
  const double needed = distance_m + slack;
  for (int axis = 0; axis < 3; ++axis) {
    if (pair.gap_a(axis) > needed || pair.gap_b(axis) > needed) {
      return true;
    }
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double gap = pair.gap_product(i, j) - slack;
      const double length_squared = 1.0 - pair.turn(i, j) * pair.turn(i, j);
      if (gap > 0.0 && length_squared > kParallelAxes &&
          gap * gap > distance_m * distance_m * length_squared) {
        return true;
      }
    }
  }
  return false;
}

double gap_along(const Core& a, const Core& b, const Vector3& direction) {
  return std::abs((b.centre - a.centre).dot(direction)) - reach_along(a, direction) -
         reach_along(b, direction);
}

Penetration least_penetration(const Core& a, const Core& b) {
  const double worthwhile_m = rounding_slack_m(a, b);
  Penetration least{a.axes.col(0), -gap_along(a, b, a.axes.col(0))};
  const auto offer = [&](const Vector3& axis) {
    const double depth_m = -gap_along(a, b, axis);
    if (depth_m < least.depth_m - worthwhile_m) {
      least = {axis, depth_m};
    }
  };
  offer(a.axes.col(1));
  offer(a.axes.col(2));
  for (int axis = 0; axis < 3; ++axis) {
    offer(b.axes.col(axis));
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vector3 product = a.axes.col(i).cross(b.axes.col(j));
      if (product.squaredNorm() > kParallelAxes) {
        offer(product.normalized());
      }
    }
  }
  return least;
}

std::optional<ClosestOfCores> closest_points(const Core& a, const Core& b) {
  if (!are_points_or_segments(a, b) && !are_separated(a, b, 0.0)) {
    return std::nullopt;
  }
  const double near_m = kMeeting * rounding_slack_m(a, b);
  const ClosestOfCores closest = closest_features(a, b, near_m);
  return closest.squared_m2 > near_m * near_m ? std::optional(closest) : std::nullopt;
}

bool come_within(const Core& a, const Core& b, double distance_m) {
  const double slack_m = rounding_slack_m(a, b);
  const double bound_m = bounding_radius_m(a) + bounding_radius_m(b) + distance_m + slack_m;
  if ((a.centre - b.centre).squaredNorm() > bound_m * bound_m) {
    return false;
  }
  if (!are_points_or_segments(a, b)) {
    if (are_separated(a, b, distance_m)) {
      return false;
    }
    if (!are_separated(a, b, 0.0)) {
      return true;
    }
  }
  const ClosestOfCores closest = closest_features(a, b, distance_m);
  const double apart_m = std::sqrt(closest.squared_m2);
  const double far_m = distance_m + slack_m;
  return apart_m <= far_m || gap_along(a, b, (closest.on_a - closest.on_b) / apart_m) <= far_m;
}

}  // namespace impetus::inline volumes
