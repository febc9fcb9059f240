// A cube seen from inside: bodies are kept within its six walls.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/volumes/volume.hpp"

namespace impetus::inline volumes {

inline constexpr int kWallCount = 6;

/// Axis-parallel walls at ±half_edge_m from the world's origin. Wall 2k lies on the positive side
/// of axis k, wall 2k+1 on the negative side.
struct ClosedCube {
  double half_edge_m{0.0};
};

/// What keeps it from being an enclosure, as a sentence; empty when nothing does.
std::string problem_of(const ClosedCube& cube);

/// How far the volume reaches beyond a wall (metres); negative when it stays within.
double reach_beyond(const ClosedCube& cube, int wall, const Sphere& sphere);
double reach_beyond(const ClosedCube& cube, int wall, const Volume& volume);

/// Whether the volume touches any wall or reaches beyond it.
bool reaches_wall(const ClosedCube& cube, const Sphere& sphere);
bool reaches_wall(const ClosedCube& cube, const Volume& volume);

/// The wall's inward unit normal.
Vector3 inward_normal(int wall);
inline Vector3 inward_normal(const ClosedCube& /*any*/, int wall) { return inward_normal(wall); }

/// The sphere against the wall: the point of the wall nearest to the centre, the inward normal.
TouchPoint touch_wall(const ClosedCube& cube, int wall, const Sphere& sphere);

/// The same of any volume: the point of the wall nearest to the middle of the part of the core
/// that reaches furthest towards it. A cube touches below its centre, as the sphere does that
/// circumscribes it, but no deeper than it reaches.
TouchPoint touch_wall(const ClosedCube& cube, int wall, const Volume& volume);

/// The eight corners (metres, world): bit i is the side along axis i.
Vector3 corner(const ClosedCube& cube, int index);

}  // namespace impetus::inline volumes
