// SPDX-License-Identifier: MIT
#include "experiments/models/tree_cache.hpp"

#include <cstdlib>
#include <exception>
#include <string>
#include <system_error>
#include <utility>

#include "experiments/models/mesh_bytes.hpp"
#include "experiments/models/tree_file.hpp"

namespace impetus::inline models {
namespace {

/// An environment variable; "" when it is not set.
std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// "" for a whole tree.
std::string built(const TreeSettings& settings) {
  return levels_to_build(settings) < settings.depth
             ? " built to " + std::to_string(settings.built_depth)
             : "";
}

bool same_mesh(const TriangleMesh& one, const TriangleMesh& other) {
  return one.vertices == other.vertices && one.triangles == other.triangles;
}

/// The tree in the file, when it is just the one that would be built.
std::optional<VolumeTree> kept(const std::filesystem::path& file, const TriangleMesh& solid,
                               const TreeSettings& settings) {
  try {
    StoredTree stored = load_tree(file);
    if (stored.builder_version == kTreeBuilderVersion && stored.settings == settings &&
        same_mesh(stored.mesh, solid)) {
      return std::move(stored.tree);
    }
  } catch (const std::exception&) {
    // Not there, damaged or of another format: built anew.
  }
  return std::nullopt;
}

void keep(const StoredTree& stored, const std::filesystem::path& file) {
  std::error_code refused;
  std::filesystem::create_directories(file.parent_path(), refused);
  try {
    save_tree(stored, file, /*replace=*/true);
  } catch (const std::exception&) {
    // Then the next one builds too.
  }
}

/// Of the watch that lives, if one does.
Progress& present() {
  static Progress heard;
  return heard;
}

}  // namespace

TreeCache TreeCache::of_user() {
  const std::string chosen = variable("IMPETUS_TREE_CACHE");
  if (chosen == "off") {
    return {};
  }
  if (!chosen.empty()) {
    return TreeCache(chosen);
  }
  const std::filesystem::path caches = variable("XDG_CACHE_HOME");
  if (caches.is_absolute()) {  // the XDG specification ignores others
    return TreeCache(caches / "impetus" / "trees");
  }
  const std::filesystem::path home = variable("HOME");
  return home.empty() ? TreeCache() : TreeCache(home / ".cache" / "impetus" / "trees");
}

std::filesystem::path TreeCache::file_of(const TriangleMesh& solid,
                                         const TreeSettings& settings) const {
  const std::string key = content_hash(solid) + " " + name_of(settings.kind) + " depth " +
                          std::to_string(settings.depth) + " branching " +
                          std::to_string(settings.branching) + built(settings) + " builder " +
                          std::to_string(kTreeBuilderVersion) + " format " +
                          std::to_string(kTreeFileFormat);
  return *folder_ / (content_hash(key) + ".tree");
}

VolumeTree TreeCache::tree(const TriangleMesh& solid, const TreeSettings& settings,
                           const Progress& progress) const {
  const Progress& heard = progress ? progress : BuildingWatch::heard();
  if (!folder_) {
    return build_tree(solid, settings, heard);
  }
  const std::filesystem::path file = file_of(solid, settings);
  if (auto known = kept(file, solid, settings)) {
    return *std::move(known);
  }
  StoredTree stored{"", settings, solid, build_tree(solid, settings, heard)};
  keep(stored, file);
  return std::move(stored.tree);
}

BuildingWatch::BuildingWatch(Progress heard) { present() = std::move(heard); }

BuildingWatch::~BuildingWatch() { present() = {}; }

const Progress& BuildingWatch::heard() { return present(); }

}  // namespace impetus::inline models
