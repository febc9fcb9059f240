// SPDX-License-Identifier: MIT
#include "engine/shapes/triangle_distance.hpp"

#include <algorithm>
#include <optional>

namespace impetus::inline shapes {
namespace {

/// Where the segment passes through the triangle, its border included; nothing for a segment in
/// the triangle's plane.
std::optional<Vector3> crossing(const Vector3& from, const Vector3& to, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  const Vector3 normal = (b - a).cross(c - a);
  const double height_from = normal.dot(from - a);
  const double height_to = normal.dot(to - a);
  if ((height_from > 0.0) == (height_to > 0.0) && height_from != 0.0 && height_to != 0.0) {
    return std::nullopt;
  }
  if (height_from == height_to) {
    return std::nullopt;
  }
  const Vector3 point = from + height_from / (height_from - height_to) * (to - from);
  const bool within = normal.dot((b - a).cross(point - a)) >= 0.0 &&
                      normal.dot((c - b).cross(point - b)) >= 0.0 &&
                      normal.dot((a - c).cross(point - c)) >= 0.0;
  return within ? std::optional(point) : std::nullopt;
}

std::optional<Vector3> common_point(const Triangle& a, const Triangle& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (auto point = crossing(a[i], a[(i + 1) % 3], b)) {
      return point;
    }
    if (auto point = crossing(b[i], b[(i + 1) % 3], a)) {
      return point;
    }
  }
  return std::nullopt;
}

void keep_closer(ClosestPoints& best, const ClosestPoints& other) {
  if (other.distance_m < best.distance_m) {
    best = other;
  }
}

ClosestPoints between_points(const Vector3& on_a, const Vector3& on_b) {
  return {(on_a - on_b).norm(), on_a, on_b};
}

bool parted_along(const Vector3& axis, const Triangle& triangle, const Vector3& half_extents_m) {
  const double a = axis.dot(triangle[0]);
  const double b = axis.dot(triangle[1]);
  const double c = axis.dot(triangle[2]);
  const double reach = axis.cwiseAbs().dot(half_extents_m);
  return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
}

}  // namespace

ClosestOnTriangle closest_feature(const Triangle& triangle, const Vector3& point) {
  const auto& [a, b, c] = triangle;
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const double d1 = ab.dot(point - a);
  const double d2 = ac.dot(point - a);
  if (d1 <= 0.0 && d2 <= 0.0) {
    return {a, TriangleFeature::kCorner0};
  }
  const double d3 = ab.dot(point - b);
  const double d4 = ac.dot(point - b);
  if (d3 >= 0.0 && d4 <= d3) {
    return {b, TriangleFeature::kCorner1};
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    return {a + d1 / (d1 - d3) * ab, TriangleFeature::kEdge0};
  }
  const double d5 = ab.dot(point - c);
  const double d6 = ac.dot(point - c);
  if (d6 >= 0.0 && d5 <= d6) {
    return {c, TriangleFeature::kCorner2};
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    return {a + d2 / (d2 - d6) * ac, TriangleFeature::kEdge2};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), TriangleFeature::kEdge1};
  }
  const double sum = va + vb + vc;
  return {a + vb / sum * ab + vc / sum * ac, TriangleFeature::kFace};
}

Vector3 closest_on_triangle(const Triangle& triangle, const Vector3& point) {
  return closest_feature(triangle, point).point;
}

ClosestPoints segment_distance(const Vector3& a0, const Vector3& a1, const Vector3& b0,
                               const Vector3& b1) {
  const Vector3 along_a = a1 - a0;
  const Vector3 along_b = b1 - b0;
  const Vector3 between = a0 - b0;
  const double aa = along_a.squaredNorm();
  const double bb = along_b.squaredNorm();
  const double ab = along_a.dot(along_b);
  const double a_between = along_a.dot(between);
  const double b_between = along_b.dot(between);
  const double denominator = aa * bb - ab * ab;
  double s = denominator > 0.0
                 ? std::clamp((ab * b_between - a_between * bb) / denominator, 0.0, 1.0)
                 : 0.0;
  double t = bb > 0.0 ? (ab * s + b_between) / bb : 0.0;
  if (t < 0.0 || t > 1.0) {
    t = std::clamp(t, 0.0, 1.0);
    s = aa > 0.0 ? std::clamp((ab * t - a_between) / aa, 0.0, 1.0) : 0.0;
  }
  return between_points(a0 + s * along_a, b0 + t * along_b);
}

ClosestPoints triangle_distance(const Triangle& a, const Triangle& b) {
  if (const auto point = common_point(a, b)) {
    return {0.0, *point, *point};
  }
  ClosestPoints best = between_points(a[0], b[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    keep_closer(best, between_points(a[i], closest_on_triangle(b, a[i])));
    keep_closer(best, between_points(closest_on_triangle(a, b[i]), b[i]));
    for (std::size_t j = 0; j < 3; ++j) {
      keep_closer(best, segment_distance(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
    }
  }
  return best;
}

bool triangles_cross(const Triangle& a, const Triangle& b) {
  return common_point(a, b).has_value();
}

bool meets_box(const Triangle& triangle, const Vector3& half_extents_m) {
  const auto parted = [&](const Vector3& axis) {
    return parted_along(axis, triangle, half_extents_m);
  };
  for (int axis = 0; axis < 3; ++axis) {
    if (parted(Vector3::Unit(axis))) {
      return false;
    }
  }
  if (parted((triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]))) {
    return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 edge = triangle[(i + 1) % 3] - triangle[i];
    for (int axis = 0; axis < 3; ++axis) {
      if (parted(edge.cross(Vector3::Unit(axis)))) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace impetus::inline shapes
