// The arrays of a volume tree as bytes, exactly.
//
//   volumes    voxels: a cell number per node; otherwise the kind of every node (one byte, its row
//              in `Volume`) and then the numbers of every node
//   links      first child, number of children
//   surfaces   occupancy, group, density normal, fit error
//
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/trees/volume_tree.hpp"
#include "experiments/models/little_endian.hpp"
#include "experiments/models/tree_header.hpp"

namespace impetus::inline models {

void append_tree(std::string& bytes, const VolumeTree& tree);

/// Throws std::out_of_range when bytes are missing, std::runtime_error or std::invalid_argument
/// (expected ..., got ...) when they are no tree.
VolumeTree take_tree(ByteReader& bytes, const TreeHeader& header);

}  // namespace impetus::inline models
