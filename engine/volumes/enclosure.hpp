// What keeps bodies together: walls seen from inside, of one of the kinds below.
//
// The questions are those of the closed cube, and each kind answers them in a file of its own. A
// new kind is one file and its name in `Enclosure`.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <variant>

#include "engine/volumes/closed_cube.hpp"
#include "engine/volumes/view_frustum.hpp"

namespace impetus::inline volumes {

using Enclosure = std::variant<ClosedCube, ViewFrustum>;

/// What keeps it from holding anything, as a sentence; empty when nothing does.
inline std::string problem_of(const Enclosure& enclosure) {
  return std::visit([](const auto& kind) { return problem_of(kind); }, enclosure);
}

template <typename Shape>
concept SphereOrVolume = std::same_as<Shape, Sphere> || std::same_as<Shape, Volume>;

template <SphereOrVolume Shape>
double reach_beyond(const Enclosure& enclosure, int wall, const Shape& shape) {
  return std::visit([&](const auto& kind) { return reach_beyond(kind, wall, shape); }, enclosure);
}

template <SphereOrVolume Shape>
bool reaches_wall(const Enclosure& enclosure, const Shape& shape) {
  return std::visit([&](const auto& kind) { return reaches_wall(kind, shape); }, enclosure);
}

inline Vector3 inward_normal(const Enclosure& enclosure, int wall) {
  return std::visit([&](const auto& kind) { return inward_normal(kind, wall); }, enclosure);
}

template <SphereOrVolume Shape>
TouchPoint touch_wall(const Enclosure& enclosure, int wall, const Shape& shape) {
  return std::visit([&](const auto& kind) { return touch_wall(kind, wall, shape); }, enclosure);
}

/// Corner `index` of eight (metres, world).
inline Vector3 corner(const Enclosure& enclosure, int index) {
  return std::visit([&](const auto& kind) { return corner(kind, index); }, enclosure);
}

/// The cube or the frustum when that is what there is, else null; lives as long as `enclosure`.
inline const ClosedCube* closed_cube(const std::optional<Enclosure>& enclosure) {
  return enclosure ? std::get_if<ClosedCube>(&*enclosure) : nullptr;
}
inline const ViewFrustum* view_frustum(const std::optional<Enclosure>& enclosure) {
  return enclosure ? std::get_if<ViewFrustum>(&*enclosure) : nullptr;
}

/// Which of many spheres reach a wall: what depends on the walls alone is computed once for them
/// all.
class WallReach {
 public:
  /// `walls` must outlive this.
  explicit WallReach(const Enclosure& walls);

  /// As reaches_wall(walls, sphere), to the last bit.
  [[nodiscard]] bool operator()(const Sphere& sphere) const;

 private:
  /// The points whose way along `outward` (unit) is `offset_m`.
  struct Plane {
    Vector3 outward{Vector3::UnitX()};
    double offset_m{0.0};
  };

  const ClosedCube* cube_;  ///< null: the walls are `planes_`
  std::array<Plane, kWallCount> planes_{};
};

}  // namespace impetus::inline volumes
