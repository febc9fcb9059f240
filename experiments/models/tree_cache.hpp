// Built trees, kept by content: the same mesh, settings and builder give the same tree, so it is
// built once on a machine.
//
//   mesh, settings, builder ─hash─> FOLDER/HASH.tree ─there and whole─> the tree
//                                        │ no                            ▲
//                                        └─> build_tree() ─> written ────┘
//
// What comes back is the same, bit for bit, with the cache and without. A file that is damaged or
// another's is built anew; a folder that cannot be written is no error. Writers do not disturb each
// other: files are put in place whole.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "engine/trees/builders/build_tree.hpp"

namespace impetus::inline models {

/// A folder of trees, or none.
class TreeCache {
 public:
  /// Keeps nothing.
  TreeCache() = default;

  /// Keeps its files in `folder`, which is made when the first is written.
  explicit TreeCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// ${XDG_CACHE_HOME:-~/.cache}/impetus/trees, or the folder that IMPETUS_TREE_CACHE names; none
  /// when that is "off" or nobody's home is known.
  static TreeCache of_user();

  [[nodiscard]] const std::optional<std::filesystem::path>& folder() const { return folder_; }

  /// Where the tree is kept. Precondition: there is a folder.
  [[nodiscard]] std::filesystem::path file_of(const TriangleMesh& solid,
                                              const TreeSettings& settings) const;

  /// build_tree(solid, settings, progress), from the cache when it is there. Throws what
  /// build_tree() throws.
  [[nodiscard]] VolumeTree tree(const TriangleMesh& solid, const TreeSettings& settings,
                                const Progress& progress = {}) const;

 private:
  std::optional<std::filesystem::path> folder_;
};

/// Who hears of the trees that a process builds, wherever it does: a check that needs one knows
/// nobody to tell. While it lives, `heard` is told of each tree that TreeCache builds and whose
/// progress nobody else asked for, its share from 0 to 1. One at a time.
class BuildingWatch {
 public:
  explicit BuildingWatch(Progress heard);
  ~BuildingWatch();
  BuildingWatch(const BuildingWatch&) = delete;
  BuildingWatch& operator=(const BuildingWatch&) = delete;

  /// Empty where there is no watch.
  static const Progress& heard();
};

}  // namespace impetus::inline models
