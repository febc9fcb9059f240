// SPDX-License-Identifier: MIT
#include "engine/trees/build_tree.hpp"

#include <stdexcept>

#include "engine/shapes/mass_properties.hpp"
#include "engine/trees/medial_tree.hpp"
#include "engine/trees/octree.hpp"

namespace impetus {

VolumeTree build_tree(const TriangleMesh& solid, const TreeSettings& settings,
                      const Progress& progress) {
  const std::string problem = problem_of(settings);
  if (!problem.empty()) {
    throw std::invalid_argument(problem);
  }
  if (solid.triangles.empty() || !find_defects(solid).none() ||
      !(solid_of(solid, /*density_kg_m3=*/1.0).volume_m3 > 0.0)) {
    throw std::invalid_argument("tree: expected a closed mesh with its triangles facing outward");
  }
  switch (settings.kind) {
    case TreeKind::kMedial:
      return medial_tree(solid, settings, progress).tree;
    case TreeKind::kOctree:
    default:
      return octree(solid, settings.depth);
  }
}

}  // namespace impetus
