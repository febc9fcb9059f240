// SPDX-License-Identifier: MIT
#include "engine/trees/fit_cell.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline trees {
namespace {

/// The point of a cell (or, on its cone's rim, of the volume) farthest from a ball.
Farthest farthest_from_ball(const Anchor& anchor, const FitCell& cell, const Cone& cone) {
  Farthest farthest;
  const Vector3& centre = anchor.core[0];
  for (unsigned which = 0; which < 8; ++which) {
    const Vector3 core = cell.corner(0, which);
    const Vector3 direction = cone.farthest_along(core - centre);
    for (const double radius_m : cell.ranges[FitCell::kRadius]) {
      const Vector3 point = core + radius_m * direction;
      const double distance_m = anchor.distance_m(point);
      if (distance_m > farthest.distance_m) {
        farthest = {point, distance_m};
      }
    }
  }
  return farthest;
}

/// A bound for the cell's points from the corners of a hull round it, and the corner of the cell
/// next to the one that it comes from. A direction w of the cell is a sum
/// of the unit vectors w_i to its corners, made unit; the sum is no shorter than the cone's cosine,
/// so w lies in the hull of the w_i and w_i/cosine.
Farthest farthest_from_convex(const Anchor& anchor, const FitCell& cell, const Cone& cone) {
  Farthest farthest;
  const auto differs = [&](std::size_t first, unsigned which) {
    for (std::size_t i = 0; i < 3; ++i) {  // of corners that coincide the first
      const auto& [low, high] = cell.ranges[first + i];
      if (low == high && ((which >> i) & 1U) != 0) {
        return false;
      }
    }
    return true;
  };
  for (unsigned at = 0; at < 8; ++at) {
    for (unsigned towards = 0; towards < 8 && differs(0, at); ++towards) {
      if (!differs(FitCell::kDirection, towards)) {
        continue;
      }
      const Vector3 corner = cell.corner(FitCell::kDirection, towards);
      const Vector3 direction = corner.isZero() ? corner : Vector3(corner.normalized());
      const Vector3 core = cell.corner(0, at);
      for (const double radius_m : cell.ranges[FitCell::kRadius]) {
        for (const double stretch : {1.0, 1.0 / cone.cosine}) {
          const Vector3 point = core + stretch * radius_m * direction;
          const double distance_m = anchor.distance_m(point);
          if (distance_m > farthest.distance_m) {
            farthest = {core + radius_m * direction, distance_m};
          }
        }
      }
    }
  }
  return farthest;
}

}  // namespace

double Anchor::distance_m(const Vector3& point) const {
  switch (kind) {
    case Kind::kTriangle:
      return (point - closest_on_triangle(core, point)).norm();
    case Kind::kBox:
      return (core[0] - point).cwiseMax(point - core[1]).cwiseMax(0.0).norm();
    case Kind::kBall:
    default:
      return (point - core[0]).norm() - radius_m;
  }
}

Anchor ball_about(const Vector3& centre, double radius_m) {
  return {Anchor::Kind::kBall, {centre, centre, centre}, radius_m};
}

Vector3 FitCell::corner(std::size_t first, unsigned which) const {
  return {ranges[first][which & 1U], ranges[first + 1][(which >> 1U) & 1U],
          ranges[first + 2][(which >> 2U) & 1U]};
}

Vector3 FitCell::middle(std::size_t first) const {
  return {0.5 * (ranges[first][0] + ranges[first][1]),
          0.5 * (ranges[first + 1][0] + ranges[first + 1][1]),
          0.5 * (ranges[first + 2][0] + ranges[first + 2][1])};
}

void FitCell::remember(const Anchor& anchor) {
  anchor_count = std::min(anchor_count + 1, kMostAnchors);
  std::copy_backward(anchors.begin(), anchors.begin() + anchor_count - 1,
                     anchors.begin() + anchor_count);
  anchors[0] = anchor;
}

Vector3 Cone::farthest_along(const Vector3& v) const {
  const double along = v.dot(axis);
  const double length = v.norm();
  if (length == 0.0 || axis.isZero()) {
    return axis;
  }
  if (along >= cosine * length) {
    return v / length;
  }
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  const Vector3 across = v - along * axis;
  const double width = across.norm();
  // Straight against the axis the rim is all the same.
  const Vector3 towards = width > 0.0 ? Vector3(across / width) : Vector3(axis.unitOrthogonal());
  return cosine * axis + sine * towards;
}

Cone cone_of(const FitCell& cell) {
  const Vector3 middle = cell.middle(FitCell::kDirection);
  if (middle.isZero()) {
    return {};
  }
  Cone cone{middle.normalized(), 1.0};
  for (unsigned which = 0; which < 8; ++which) {
    const Vector3 corner = cell.corner(FitCell::kDirection, which).normalized();
    cone.cosine = std::min(cone.cosine, corner.dot(cone.axis));
  }
  return cone;
}

Farthest farthest_from(const Anchor& anchor, const FitCell& cell, const Cone& cone) {
  return anchor.kind == Anchor::Kind::kBall ? farthest_from_ball(anchor, cell, cone)
                                            : farthest_from_convex(anchor, cell, cone);
}

}  // namespace impetus::inline trees
