// What keeps bodies together: walls seen from inside, of one of the kinds below.
//
// The questions are those of the closed cube, and each kind answers them in a file of its own. A
// new kind is one file and its name in `Enclosure`.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "engine/volumes/closed_cube.hpp"
#include "engine/volumes/view_frustum.hpp"

namespace impetus::inline volumes {

using Enclosure = std::variant<ClosedCube, ViewFrustum>;

/// What keeps it from holding anything, as a sentence; empty when nothing does.
std::string problem_of(const Enclosure& enclosure);

double reach_beyond(const Enclosure& enclosure, int wall, const Sphere& sphere);
double reach_beyond(const Enclosure& enclosure, int wall, const Volume& volume);
bool reaches_wall(const Enclosure& enclosure, const Sphere& sphere);
bool reaches_wall(const Enclosure& enclosure, const Volume& volume);
Vector3 inward_normal(const Enclosure& enclosure, int wall);
TouchPoint touch_wall(const Enclosure& enclosure, int wall, const Sphere& sphere);
TouchPoint touch_wall(const Enclosure& enclosure, int wall, const Volume& volume);

/// Corner `index` of eight (metres, world).
Vector3 corner(const Enclosure& enclosure, int index);

/// The cube or the frustum when that is what there is, else null; lives as long as `enclosure`.
const ClosedCube* closed_cube(const std::optional<Enclosure>& enclosure);
const ViewFrustum* view_frustum(const std::optional<Enclosure>& enclosure);

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
