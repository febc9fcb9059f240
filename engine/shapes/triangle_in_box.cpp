// SPDX-License-Identifier: MIT
#include "engine/shapes/triangle_in_box.hpp"

#include <algorithm>

namespace impetus::inline shapes {
namespace {

bool parted_along(const Vector3& axis, const Triangle& triangle, const Vector3& half_extents_m) {
  const double a = axis.dot(triangle[0]);
  const double b = axis.dot(triangle[1]);
  const double c = axis.dot(triangle[2]);
  const double reach = axis.cwiseAbs().dot(half_extents_m);
  return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
}

}  // namespace

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
