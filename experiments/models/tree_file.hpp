// A volume tree in a file, with the mesh it bounds and all that says how it was made.
//
//   "impetree"  format (32 bits)  length of the header (64 bits)  header (JSON)
//   volumes  links  surfaces  mesh      arrays, one after the other, little-endian
//   checksum (XXH3, 128 bits) of all that stands before it
//
// What is read back is what was written, bit for bit; every number is checked before it is used.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/shapes/triangle_mesh.hpp"
#include "engine/trees/builders/build_tree.hpp"
#include "engine/trees/level_quality.hpp"

namespace impetus::inline models {

inline constexpr std::uint32_t kTreeFileFormat = 1;

/// A tree and all that its file says of it.
struct StoredTree {
  std::string name;  ///< of what was built: a shape's, or the mesh file's
  TreeSettings settings;
  TriangleMesh mesh;  ///< in the tree's frame
  VolumeTree tree;
  std::vector<LevelQuality> quality{};       ///< one per level, or none: not measured
  int builder_version{kTreeBuilderVersion};  ///< of the program that built it
};

/// The file's bytes.
std::string bytes_of(const StoredTree& stored);

/// The tree in a file's bytes. Throws std::runtime_error, in one sentence that begins with `name`,
/// for anything but what bytes_of() makes.
StoredTree stored_tree_from(std::string_view bytes, const std::string& name);

/// `content` and its checksum: what ends a file.
std::string sealed(std::string content);

/// Writes the file whole or not at all. An existing one is replaced only when `replace` is set.
/// What could not be read again is not written. Throws std::runtime_error, in one sentence that
/// names the file.
void save_tree(const StoredTree& stored, const std::filesystem::path& file, bool replace = false);

/// Throws std::runtime_error, in one sentence that names the file.
StoredTree load_tree(const std::filesystem::path& file);

}  // namespace impetus::inline models
