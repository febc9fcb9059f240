// SPDX-License-Identifier: MIT
#include "engine/trees/builders/build_tree.hpp"

#include "engine/trees/builders/fitted_tree.hpp"
#include "engine/trees/builders/heterogeneous_tree.hpp"
#include "engine/trees/builders/medial_tree.hpp"
#include "engine/trees/builders/octree.hpp"
#include "engine/trees/builders/voxel_tree.hpp"
#include "engine/trees/solid_requirement.hpp"

namespace impetus::inline trees {

VolumeTree build_tree(const TriangleMesh& solid, const TreeSettings& settings,
                      const Progress& progress) {
  require_buildable(solid, settings);
  if (progress) {
    progress(0.0);
  }
  switch (settings.kind) {
    case TreeKind::kBox:
    case TreeKind::kSwept:
      return build_fitted_tree(solid, settings, progress).tree;
    case TreeKind::kHeterogeneous:
      return heterogeneous_tree(solid, settings, progress).tree;
    case TreeKind::kVoxel:
      return build_voxel_tree(solid, settings, progress).tree;
    case TreeKind::kMedial:
      return medial_tree(solid, settings, progress).tree;
    case TreeKind::kOctree:
    default:
      return octree(solid, levels_to_build(settings));
  }
}

}  // namespace impetus::inline trees
