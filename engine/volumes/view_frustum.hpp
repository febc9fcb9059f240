// What a viewer sees through the screen, from inside: bodies are kept in view.
//
//        eye                 walls 0 to 3 hold the eye and an edge of the screen;
//       /   \                walls 4 and 5 are parallel to the screen
//      /--4--\   front_m
//     /-------\  screen
//    /----5----\ back_m
//
// A wall is the whole half-space beyond its plane, so a body meets it at any depth, and every place
// that is out of view lies beyond some wall, behind the eye too. (Dingliana 2002, sec. 6.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/volumes/closed_cube.hpp"

namespace impetus::inline volumes {

/// Six walls: 0 right, 1 left, 2 above, 3 below, 4 towards the eye, 5 away from it.
struct ViewFrustum {
  Vector3 eye{Vector3::UnitZ()};    ///< metres, world; the screen's centre is the origin
  Vector3 right{Vector3::UnitX()};  ///< unit, along the screen, which faces the eye
  Vector3 up{Vector3::UnitY()};     ///< unit, along the screen
  double half_width_m{0.0};         ///< of the screen
  double half_height_m{0.0};
  double front_m{0.0};  ///< how far it reaches before the screen, less than the eye
  double back_m{0.0};   ///< and behind it
};

/// What keeps it from being an enclosure, as a sentence; empty when nothing does.
std::string problem_of(const ViewFrustum& frustum);

/// As of the closed cube: see there.
double reach_beyond(const ViewFrustum& frustum, int wall, const Sphere& sphere);
double reach_beyond(const ViewFrustum& frustum, int wall, const Volume& volume);
bool reaches_wall(const ViewFrustum& frustum, const Sphere& sphere);
bool reaches_wall(const ViewFrustum& frustum, const Volume& volume);
Vector3 inward_normal(const ViewFrustum& frustum, int wall);
TouchPoint touch_wall(const ViewFrustum& frustum, int wall, const Sphere& sphere);
TouchPoint touch_wall(const ViewFrustum& frustum, int wall, const Volume& volume);

/// The eight corners (metres, world): bit 0 right, bit 1 above, bit 2 away from the eye.
Vector3 corner(const ViewFrustum& frustum, int index);

}  // namespace impetus::inline volumes
