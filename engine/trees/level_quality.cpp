// SPDX-License-Identifier: MIT
#include "engine/trees/level_quality.hpp"

#include <algorithm>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/surface_distance.hpp"
#include "engine/trees/coverage.hpp"
#include "engine/trees/fit_error.hpp"
#include "engine/trees/mean_protrusion.hpp"
#include "engine/trees/solid_grid.hpp"

namespace impetus::inline trees {
namespace {

constexpr int kDivisions = 128;
constexpr int kSurfaceSamples = 6'000;

/// What one node takes of the arrays that hold volumes.
std::size_t volume_bytes(const VolumeTree& tree, std::int32_t node, bool several_kinds) {
  if (tree.volumes().are_voxels()) {
    return sizeof(std::uint32_t);
  }
  return std::visit([](const auto& kind) { return sizeof(kind); }, tree.volume(node)) +
         (several_kinds ? sizeof(std::uint32_t) : 0);
}

bool has_several_kinds(const VolumeTree& tree) {
  for (std::int32_t node = 1; node < tree.node_count(); ++node) {
    if (tree.volume(node).index() != tree.volume(0).index()) {
      return true;
    }
  }
  return false;
}

std::size_t bytes_of(const VolumeTree& tree, int level) {
  const bool several_kinds = has_several_kinds(tree);
  std::size_t bytes = 0;
  for (std::int32_t node = tree.level_begin(level); node < tree.level_end(level); ++node) {
    bytes += volume_bytes(tree, node, several_kinds) + sizeof(NodeLinks) + sizeof(NodeSurface);
  }
  return bytes;
}

std::vector<Volume> volumes_at(const VolumeTree& tree, int level) {
  std::vector<Volume> volumes;
  for (const std::int32_t node : tree.standing_at(level)) {
    volumes.push_back(tree.volume(node));
  }
  return volumes;
}

LevelQuality quality_of(const TriangleMesh& solid, const SurfaceDistance& distance,
                        const VolumeTree& tree, int level) {
  const std::vector<Volume> volumes = volumes_at(tree, level);
  LevelQuality quality;
  quality.nodes = static_cast<std::int32_t>(volumes.size());
  for (const Volume& volume : volumes) {
    quality.worst_protrusion_m = std::max(
        quality.worst_protrusion_m, fit_error_m(volume, distance, quality.worst_protrusion_m));
    quality.largest_node_m =
        std::max(quality.largest_node_m, 2.0 * bounding_sphere(volume).radius_m);
  }
  quality.mean_protrusion_m = mean_protrusion_m(volumes, distance, kSurfaceSamples);
  quality.outside_ratio = outside_volume_m3(solid, volumes, kDivisions) /
                          solid_of(solid, /*density_kg_m3=*/1.0).volume_m3;
  quality.bytes = bytes_of(tree, level);
  quality.uncovered_area_m2 = uncovered_area_m2(solid, tree, level);
  return quality;
}

}  // namespace

std::vector<LevelQuality> measure_levels(const TriangleMesh& solid, const VolumeTree& tree,
                                         const Progress& progress) {
  const SurfaceDistance distance(solid);
  std::vector<LevelQuality> levels;
  for (int level = 0; level < tree.level_count(); ++level) {
    if (progress) {
      progress(static_cast<double>(level) / tree.level_count());
    }
    levels.push_back(quality_of(solid, distance, tree, level));
  }
  if (progress) {
    progress(1.0);
  }
  return levels;
}

}  // namespace impetus::inline trees
