// Solids whose section is the same along z: a disc, and a prism on any simple polygon.
//
//   outline, anticlockwise as seen from +z      3---2
//                                               |   |    drawn out by thickness_m along z,
//                                               0---1    half of it to either side
//
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// A point of an outline, metres.
using OutlinePoint = Eigen::Vector2d;

/// What keeps an outline from being one, as a sentence; empty when nothing does: it has three
/// corners or more, no two of its sides touch but neighbours where they join, and it has a content.
std::string problem_of(const std::vector<OutlinePoint>& outline);

/// The prism on the outline, either way round, about z = 0. Precondition: problem_of(outline) is
/// empty, and thickness_m is positive. about_centre_of_mass() gives a body's frame.
TriangleMesh prism_mesh(std::vector<OutlinePoint> outline, double thickness_m);

/// A thin disc about the origin, across z: corners lie on the circle, so close that none is seen.
TriangleMesh disc_mesh(double radius_m);

}  // namespace impetus::inline shapes
