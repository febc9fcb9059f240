// SPDX-License-Identifier: MIT
#include "engine/volumes/enclosure.hpp"

#include <algorithm>

namespace impetus::inline volumes {
namespace {

/// What `question` of the kind at hand answers.
template <typename Question>
auto answer_of(const Enclosure& enclosure, const Question& question) {
  if (const auto* cube = std::get_if<ClosedCube>(&enclosure)) {
    return question(*cube);
  }
  return question(std::get<ViewFrustum>(enclosure));
}

}  // namespace

std::string problem_of(const Enclosure& enclosure) {
  return answer_of(enclosure, [](const auto& walls) { return problem_of(walls); });
}

double reach_beyond(const Enclosure& enclosure, int wall, const Sphere& sphere) {
  return answer_of(enclosure, [&](const auto& walls) { return reach_beyond(walls, wall, sphere); });
}

double reach_beyond(const Enclosure& enclosure, int wall, const Volume& volume) {
  return answer_of(enclosure, [&](const auto& walls) { return reach_beyond(walls, wall, volume); });
}

bool reaches_wall(const Enclosure& enclosure, const Sphere& sphere) {
  return answer_of(enclosure, [&](const auto& walls) { return reaches_wall(walls, sphere); });
}

bool reaches_wall(const Enclosure& enclosure, const Volume& volume) {
  return answer_of(enclosure, [&](const auto& walls) { return reaches_wall(walls, volume); });
}

Vector3 inward_normal(const Enclosure& enclosure, int wall) {
  return answer_of(enclosure, [&](const auto& walls) { return inward_normal(walls, wall); });
}

TouchPoint touch_wall(const Enclosure& enclosure, int wall, const Sphere& sphere) {
  return answer_of(enclosure, [&](const auto& walls) { return touch_wall(walls, wall, sphere); });
}

TouchPoint touch_wall(const Enclosure& enclosure, int wall, const Volume& volume) {
  return answer_of(enclosure, [&](const auto& walls) { return touch_wall(walls, wall, volume); });
}

Vector3 corner(const Enclosure& enclosure, int index) {
  return answer_of(enclosure, [&](const auto& walls) { return corner(walls, index); });
}

const ClosedCube* closed_cube(const std::optional<Enclosure>& enclosure) {
  return enclosure ? std::get_if<ClosedCube>(&*enclosure) : nullptr;
}

const ViewFrustum* view_frustum(const std::optional<Enclosure>& enclosure) {
  return enclosure ? std::get_if<ViewFrustum>(&*enclosure) : nullptr;
}

WallReach::WallReach(const Enclosure& walls) : cube_(std::get_if<ClosedCube>(&walls)) {
  if (cube_ != nullptr) {
    return;
  }
  const auto& frustum = std::get<ViewFrustum>(walls);
  for (int wall = 0; wall < kWallCount; ++wall) {
    const Vector3 outward = -inward_normal(frustum, wall);
    const double offset_m = wall == 4   ? frustum.front_m
                            : wall == 5 ? frustum.back_m
                                        : outward.dot(frustum.eye);
    planes_[static_cast<std::size_t>(wall)] = {outward, offset_m};
  }
}

bool WallReach::operator()(const Sphere& sphere) const {
  if (cube_ != nullptr) {
    return reaches_wall(*cube_, sphere);
  }
  return std::any_of(planes_.begin(), planes_.end(), [&](const Plane& plane) {
    return plane.outward.dot(sphere.centre) - plane.offset_m + sphere.radius_m >= 0.0;
  });
}

}  // namespace impetus::inline volumes
