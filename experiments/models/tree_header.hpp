// The JSON header of a tree file: what the tree is, and how many of everything follows.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/models/mesh_bytes.hpp"
#include "experiments/models/tree_file.hpp"

namespace impetus::inline models {

/// What the header says.
struct TreeHeader {
  std::string name;
  TreeSettings settings;
  int builder_version{0};
  std::string mesh_hash;
  MeshCounts mesh;
  std::int32_t nodes{0};
  std::vector<std::int32_t> level_starts;
  bool voxels{false};
  VoxelGrid grid;  ///< of voxels
  std::vector<LevelQuality> quality;
};

TreeHeader header_of(const StoredTree& stored);

std::string text_of(const TreeHeader& header);

/// Throws std::runtime_error, "header/key: expected ..., got ...", for a header that is not one.
TreeHeader tree_header_from(std::string_view text);

}  // namespace impetus::inline models
