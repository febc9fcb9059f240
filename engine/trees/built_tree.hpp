// A tree and the witness that it covers: the part of the surface that each node bounds.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/trees/surface_part.hpp"
#include "engine/trees/volume_tree.hpp"

namespace impetus::inline trees {

/// The parts of a node's children tile the node's own part, the root's is the whole surface, and
/// every volume holds every corner of its part. So each level holds the whole surface.
struct BuiltTree {
  VolumeTree tree;
  std::vector<SurfacePart> parts;  ///< one per node, in the tree's order
};

}  // namespace impetus::inline trees
