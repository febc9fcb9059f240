// SPDX-License-Identifier: MIT
#include "engine/trees/build_tree.hpp"

#include <stdexcept>

#include "engine/trees/octree.hpp"

namespace impetus {

VolumeTree build_tree(const TriangleMesh& solid, const TreeSettings& settings,
                      const Progress& progress) {
  const std::string problem = problem_of(settings);
  if (!problem.empty()) {
    throw std::invalid_argument(problem);
  }
  if (progress) {
    progress(0.0);
  }
  switch (settings.kind) {
    case TreeKind::kOctree:
    default:
      return octree(solid, settings.depth);
  }
}

}  // namespace impetus
