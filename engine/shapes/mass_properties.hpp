// Mass, centre of mass and inertia of homogeneous solids.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/vector.hpp"
#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// `centre` in the shape's own frame (metres); `inertia` (kg m²) about the centre of mass, in the
/// same axes.
struct MassProperties {
  double mass_kg{0.0};
  double volume_m3{0.0};
  Vector3 centre{Vector3::Zero()};
  Matrix3 inertia{Matrix3::Zero()};
};

/// A solid sphere about the origin: 4/3 π r³ and 2/5 m r².
MassProperties solid_sphere(double radius_m, double density_kg_m3);

/// The solid inside a closed, outward-oriented mesh, by the divergence theorem over its triangles
/// (Mirtich 1996; Tonon 2004 for the tetrahedron's moments). Coordinates are taken from the first
/// vertex, so a mesh far from the origin loses no more than its coordinates have lost, and sums are
/// compensated, so a fine mesh is as exact as a coarse one.
/// Of a mesh that is inside out, volume and mass are below 0. Precondition:
/// find_defects(mesh).none().
MassProperties solid_of(const TriangleMesh& mesh, double density_kg_m3);

/// The mesh moved so that the centre of mass of its solid is the origin: a body's own frame.
TriangleMesh about_centre_of_mass(TriangleMesh mesh);

}  // namespace impetus::inline shapes
