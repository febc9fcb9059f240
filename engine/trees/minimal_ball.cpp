// SPDX-License-Identifier: MIT
#include "engine/trees/minimal_ball.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace impetus::inline trees {
namespace {

constexpr double kTolerance = 1e-12;
constexpr double kFlat = 1e-12;  ///< determinants over the product of lengths
constexpr int kMostRounds = 100;

Sphere ball_through(const Vector3& a, const Vector3& b) {
  const Vector3 centre = 0.5 * (a + b);
  return {centre, std::max((a - centre).norm(), (b - centre).norm())};
}

/// None when the points lie on a line.
std::optional<Sphere> ball_through(const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 u = b - a;
  const Vector3 v = c - a;
  const Vector3 normal = u.cross(v);
  const double squared = normal.squaredNorm();
  if (!(squared > kFlat * kFlat * u.squaredNorm() * v.squaredNorm())) {
    return std::nullopt;
  }
  const Vector3 to_centre =
      (u.squaredNorm() * v.cross(normal) + v.squaredNorm() * normal.cross(u)) / (2.0 * squared);
  return Sphere{a + to_centre, to_centre.norm()};
}

/// None when the points lie in a plane.
std::optional<Sphere> ball_through(const Vector3& a, const Vector3& b, const Vector3& c,
                                   const Vector3& d) {
  const Vector3 u = b - a;
  const Vector3 v = c - a;
  const Vector3 w = d - a;
  const double content = u.dot(v.cross(w));
  if (!(std::fabs(content) > kFlat * u.norm() * v.norm() * w.norm())) {
    return std::nullopt;
  }
  const Vector3 to_centre =
      (u.squaredNorm() * v.cross(w) + v.squaredNorm() * w.cross(u) + w.squaredNorm() * u.cross(v)) /
      (2.0 * content);
  return Sphere{a + to_centre, to_centre.norm()};
}

std::optional<Sphere> ball_through(const std::vector<Vector3>& points) {
  switch (points.size()) {
    case 1:
      return Sphere{points[0], 0.0};
    case 2:
      return ball_through(points[0], points[1]);
    case 3:
      return ball_through(points[0], points[1], points[2]);
    default:
      return ball_through(points[0], points[1], points[2], points[3]);
  }
}

bool holds_all(const Sphere& ball, const std::vector<Vector3>& points) {
  return std::all_of(points.begin(), points.end(), [&](const Vector3& point) {
    return (point - ball.centre).norm() <= (1.0 + kTolerance) * ball.radius_m;
  });
}

/// The smallest ball of the points `held_up` and `added`, on whose surface `added` lies; what holds
/// it up takes the place of `held_up`. False when rounding leaves none.
bool support(std::vector<Vector3>& held_up, const Vector3& added, Sphere& ball) {
  std::vector<Vector3> all = held_up;
  all.push_back(added);
  bool found = false;
  std::vector<Vector3> best;
  for (std::uint32_t chosen = 1; chosen < (1U << held_up.size()); ++chosen) {
    std::vector<Vector3> through{added};
    for (std::size_t i = 0; i < held_up.size(); ++i) {
      if ((chosen >> i & 1U) != 0) {
        through.push_back(held_up[i]);
      }
    }
    if (through.size() > 4) {
      continue;
    }
    const std::optional<Sphere> tried = ball_through(through);
    if (tried && holds_all(*tried, all) && (!found || tried->radius_m < ball.radius_m)) {
      ball = *tried;
      best = through;
      found = true;
    }
  }
  if (found) {
    held_up = best;
  }
  return found;
}

const Vector3& farthest_from(const Vector3& centre, const std::vector<Vector3>& points) {
  return *std::max_element(points.begin(), points.end(), [&](const Vector3& a, const Vector3& b) {
    return (a - centre).squaredNorm() < (b - centre).squaredNorm();
  });
}

}  // namespace

Sphere minimal_ball(const std::vector<Vector3>& points) {
  std::vector<Vector3> held_up{points.front()};
  Sphere ball{points.front(), 0.0};
  for (int round = 0; round < kMostRounds; ++round) {
    const Vector3& farthest = farthest_from(ball.centre, points);
    if ((farthest - ball.centre).norm() <= (1.0 + kTolerance) * ball.radius_m ||
        !support(held_up, farthest, ball)) {
      break;
    }
  }
  ball.radius_m = (farthest_from(ball.centre, points) - ball.centre).norm();
  return ball;
}

}  // namespace impetus::inline trees
