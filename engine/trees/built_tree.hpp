// A tree with the witness that it covers: the part of the surface that each node bounds.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/trees/surface_part.hpp"
#include "engine/trees/volume_tree.hpp"

namespace impetus {

struct BuiltTree {
  VolumeTree tree;
  std::vector<SurfacePart> parts;  ///< one per node, in the tree's order
};

}  // namespace impetus
