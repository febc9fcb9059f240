// What a node knows of the object: how much of it is solid, which way the surface faces, which
// group of surface it lies on, and how far it reaches beyond.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/surface_distance.hpp"
#include "engine/trees/surface_part.hpp"
#include "engine/trees/volume_tree.hpp"

namespace impetus {

class NodeDescription {
 public:
  /// Precondition: find_defects(solid).none(), one triangle or more.
  explicit NodeDescription(const TriangleMesh& solid);

  /// Of a node that bounds `part`.
  [[nodiscard]] NodeSurface of(const Volume& volume, const SurfacePart& part) const;

  [[nodiscard]] const SurfaceDistance& distance() const { return distance_; }

 private:
  SurfaceDistance distance_;
};

}  // namespace impetus
