// Which of many spheres reach a wall: what depends on the walls alone is computed once for them
// all. SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "engine/volumes/enclosure.hpp"

namespace impetus::inline volumes {

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
