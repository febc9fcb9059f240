// A volume of any kind: what a node of a volume tree may be; whether two of them overlap, and where
// they touch.
//
// All kinds are convex: a polygon lies within a volume when its corners do. The table in the source
// has a row for each kind. Every pair gives the same answer both ways round: the contact of (b, a)
// is that of (a, b), bit for bit, its normal turned.
// (Dingliana 2002, sec. 4.3, table 4.1, eq. 3.7 and 3.8, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "engine/volumes/box.hpp"
#include "engine/volumes/sphere.hpp"
#include "engine/volumes/swept.hpp"

namespace impetus::inline volumes {

/// Each kind answers the questions below in a file of its own, and has a row in the table of pairs
/// in the source.
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

/// Whether the volumes overlap or touch. Never denied to volumes that do; within rounding it is
/// exact.
bool overlap(const Volume& a, const Volume& b);

/// The contact of two volumes. The normal runs along the line of least distance of their cores,
/// and the point divides it in the ratio of the radii; where many lines are as short, the middle
/// one. Cores that meet have the axis of least penetration, its sense that of the line of the
/// centres, else of `fallback`, and the point is the centroid of what they share. Boxes are their
/// own cores. The contact of two cubes is that of the spheres that circumscribe them (sec. 4.1.2).
/// `fallback` (unit, from b to a) also gives the normal where the geometry leaves it open.
TouchPoint touch(const Volume& a, const Volume& b, const Vector3& fallback);

/// A volume's width along `direction` (unit; metres).
double width_along(const Volume& volume, const Vector3& direction);

/// How deep two volumes are in each other, from 0, touching, to 1, where the smaller is wholly
/// within the other along the normal: depth over the lesser width along it, of two cubes that of
/// the spheres that circumscribe them. For spheres,
/// (R_a + R_b − d) / (2 min(R_a, R_b)). (eq. 4.3, corrected)
double interpenetration(const Volume& a, const Volume& b, const TouchPoint& contact);

/// The same of a volume and a wall, which is wider than any.
double wall_interpenetration(const Volume& volume, const TouchPoint& contact);

}  // namespace impetus::inline volumes
