// What a node knows of the object: how much of it is solid, which way the surface faces, which
// group of surface it lies on, and how far it reaches beyond.
//
// And a tree and the witness that it covers: the part of the surface that each node bounds.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/shapes/surface_distance.hpp"
#include "engine/trees/surface_part.hpp"
#include "engine/trees/volume_tree.hpp"

namespace impetus::inline trees {

/// A part whose area vector is a smaller share of its area than this faces no way: the opposite
/// sides of a thin limb cancel, and what is left is chance.
inline constexpr double kLeastFacing = 0.2;

/// Points that an occupancy is counted by.
inline constexpr int kOccupancyPoints = 384;

/// Describes nodes of one solid.
class NodeDescription {
 public:
  /// Precondition: find_defects(solid).none(), one triangle or more.
  explicit NodeDescription(const TriangleMesh& solid);

  /// Of a node that bounds `part`, pieces of triangles of `solid` within `volume`, with this fit
  /// error (metres).
  [[nodiscard]] NodeSurface of(const Volume& volume, const SurfacePart& part,
                               double fit_error_m) const;

  /// The same with the certified fit error of fit_error.hpp.
  [[nodiscard]] NodeSurface of(const Volume& volume, const SurfacePart& part) const;

  [[nodiscard]] const SurfaceDistance& distance() const { return distance_; }

 private:
  [[nodiscard]] std::int32_t group_of(const SurfacePart& part) const;

  SurfaceDistance distance_;
  std::vector<std::int32_t> groups_;  ///< by triangle
};

/// The share of the volume that is solid: exactly 1 or 0 where its bounding sphere lies wholly
/// inside or outside, else counted over kOccupancyPoints points spread evenly over the volume,
/// which is within about .03 of the truth.
double occupancy_of(const Volume& volume, const SurfaceDistance& solid);

/// Outward and unit, −∇ρ/‖∇ρ‖ with the density ρ of the object about the node; zero where the part
/// faces no way (kLeastFacing). By the divergence theorem the density's gradient, averaged over a
/// region, is minus the area vector of the surface in it over the region's volume, so the sum over
/// the facets is exact where central differences of sampled densities over 2h, eq. 4.8 as
/// corrected, are its discrete form. (Dingliana 2002, eq. 4.7 to 4.9, corrected)
Vector3 density_normal_of(const SurfacePart& part);

/// The parts of a node's children tile the node's own part, the root's is the whole surface, and
/// every volume holds every corner of its part. So each level holds the whole surface.
struct BuiltTree {
  VolumeTree tree;
  std::vector<SurfacePart> parts;  ///< one per node, in the tree's order
};

}  // namespace impetus::inline trees
