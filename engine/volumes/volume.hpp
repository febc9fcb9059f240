// A volume of any kind: what a node of a volume tree may be.
//
// All kinds are convex: a polygon lies within a volume when its corners do.
// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "engine/volumes/box.hpp"
#include "engine/volumes/sphere.hpp"
#include "engine/volumes/swept.hpp"

namespace impetus::inline volumes {

/// Each kind answers the questions below in a file of its own, and has a row in the table of pairs
/// (see pair_procedures.hpp).
using Volume = std::variant<Sphere, LineSwept, RectangleSwept, Box, Cube>;

/// The smallest sphere about the volume's centre that holds it.
Sphere bounding_sphere(const Volume& volume);

/// The volume as a core and a radius.
CoredVolume cored(const Volume& volume);

/// A volume of a body's frame in the world.
Volume placed(const Volume& volume, const Pose& pose);

/// Whether `point` lies in the volume or on its surface.
bool holds(const Volume& volume, const Vector3& point);

/// The volume's content (m³).
double content_m3(const Volume& volume);

}  // namespace impetus::inline volumes
