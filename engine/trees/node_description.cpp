// SPDX-License-Identifier: MIT
#include "engine/trees/node_description.hpp"

#include <algorithm>

#include "engine/numerics/rounding.hpp"

namespace impetus {

NodeDescription::NodeDescription(const TriangleMesh& solid) : distance_(solid) {}

NodeSurface NodeDescription::of(const Volume& volume, const SurfacePart& part) const {
  NodeSurface surface;
  const Sphere bound = bounding_sphere(volume);
  surface.fit_error_m =
      rounded_up(std::max(0.0, bound.radius_m + distance_.signed_distance_m(bound.centre)));
  Vector3 area = Vector3::Zero();
  for (const Facet& facet : part) {
    area += doubled_area_vector(facet);
  }
  if (area.norm() > 0.0) {
    surface.density_normal = area.normalized().cast<float>();
  }
  return surface;
}

}  // namespace impetus
