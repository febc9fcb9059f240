// The part of an object's surface that a node bounds: pieces of triangles, cut exactly.
//
// A part is only ever cut by planes, and both sides keep the cut line, so the pieces of a triangle
// always cover it: what holds every corner of every piece holds the surface.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/shapes/triangle_mesh.hpp"
#include "engine/volumes/sphere.hpp"

namespace impetus::inline trees {

/// A convex piece of one triangle.
struct Facet {
  std::vector<Vector3> corners;
  Vector3 normal{Vector3::Zero()};  ///< outward, of any length
  std::uint32_t triangle{0};        ///< of the mesh
};

using SurfacePart = std::vector<Facet>;

/// The points p with normal · p ≥ offset; `normal` of any length but zero.
struct HalfSpace {
  Vector3 normal{Vector3::UnitX()};
  double offset{0.0};

  [[nodiscard]] double height(const Vector3& point) const { return normal.dot(point) - offset; }
};

/// Every triangle of the mesh, whole.
SurfacePart whole_surface(const TriangleMesh& mesh);

/// The pieces within the half space and those outside it. Corners nearer to the plane than `snap`
/// (in the units of height()) count as on it; a facet in the plane goes where the solid lies.
std::pair<SurfacePart, SurfacePart> cut(const SurfacePart& part, const HalfSpace& half_space,
                                        double snap = 0.0);

/// Of cuts made by builders: what lies nearer to a plane than this share of the size lies in it.
inline constexpr double kSnapShare = 1e-13;

/// Twice the area of a facet times its unit normal, summed: the area vector of the part, doubled.
Vector3 doubled_area_vector(const Facet& facet);

double area_m2(const SurfacePart& part);

/// Every corner of every facet, in order.
std::vector<Vector3> corners_of(const SurfacePart& part);

/// Shares a part among spheres: each gets what is nearest to it by power distance, the squared
/// distance to its centre less its squared radius. The piece of `part` in the cell of each sphere,
/// empty ones too; they tile the part. Cells are bounded by planes, so the pieces are cut exactly;
/// where spheres cover a point, its cell's sphere does. (Aurenhammer 1987)
std::vector<SurfacePart> power_cells(SurfacePart part, const std::vector<Sphere>& spheres);

/// The index of the sphere to which `point` has the least power. Precondition: one or more spheres.
std::size_t least_power(const std::vector<Sphere>& spheres, const Vector3& point);

}  // namespace impetus::inline trees
