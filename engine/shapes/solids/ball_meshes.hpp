// Balls as closed triangle meshes: the icosphere, an icosahedron whose triangles are split into
// four, and the ball pulled apart to a sphere-swept line or rectangle.
//
//    ( ball )   cut by x = 0 and y = 0   (  |  )  each quarter moved by the core's corner on its
//    side
//
// No vertex of that ball lies on the cuts, so that every quarter moves whole and the cells that lie
// across a cut become the flat sides. Convex, and inscribed: all vertices are on the swept surface.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// 20 · 4^subdivisions outward triangles with their vertices on the sphere of `radius_m` about the
/// origin; `subdivisions` from 0 to 7.
TriangleMesh icosphere_mesh(double radius_m, int subdivisions);

/// Outward triangles about the origin within everything that is `radius_m` or less from the
/// rectangle |x| ≤ half_x_m, |y| ≤ half_y_m, z = 0; a half of zero makes it a line, both a ball.
/// The ball is a cube of `cells` by `cells` quadrangles a side, blown up: 12 cells² triangles;
/// `cells` is odd.
TriangleMesh swept_mesh(double half_x_m, double half_y_m, double radius_m, int cells);

/// The greatest radius that stays within a convex mesh about the origin when it is swept along the
/// core of these halves (metres): by the planes of the triangles.
double swept_inner_radius_m(const TriangleMesh& mesh, const Vector3& half_u_m,
                            const Vector3& half_v_m);

}  // namespace impetus::inline shapes
