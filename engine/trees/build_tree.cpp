// SPDX-License-Identifier: MIT
#include "engine/trees/build_tree.hpp"

#include "engine/trees/fitted_tree.hpp"
#include "engine/trees/heterogeneous_tree.hpp"
#include "engine/trees/medial_tree.hpp"
#include "engine/trees/octree.hpp"
#include "engine/trees/solid_requirement.hpp"
#include "engine/trees/voxel_tree.hpp"

namespace impetus {

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

}  // namespace impetus
