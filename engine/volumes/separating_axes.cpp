// SPDX-License-Identifier: MIT
#include "engine/volumes/separating_axes.hpp"

#include <cmath>

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

}  // namespace impetus::inline volumes
