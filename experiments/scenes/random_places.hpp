// Random places, directions and orientations: the same numbers of a stream, the same start, on
// every machine, for no draw needs trigonometry.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/random_stream.hpp"
#include "engine/numerics/vector.hpp"
#include "engine/volumes/enclosure.hpp"

namespace impetus::inline scenes {

/// Uniform from -1 to 1.
double draw_symmetric(RandomStream& stream);

/// Uniform over the unit sphere.
Vector3 draw_direction(RandomStream& stream);

/// Uniform over rotations.
Quaternion draw_orientation(RandomStream& stream);

/// Where the middles of balls may be that are within the walls: a box about `centre`, or less.
struct Room {
  Vector3 centre{Vector3::Zero()};
  Vector3 half_extents_m{Vector3::Zero()};
  const Enclosure* walls{nullptr};  ///< null: all of the box is within
};

Room room_within(const Enclosure& enclosure, double radius_m);

/// Uniform over the room's box.
Vector3 draw_place(const Room& room, RandomStream& stream);

}  // namespace impetus::inline scenes
