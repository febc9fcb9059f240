// SPDX-License-Identifier: MIT
#include "engine/trees/builders/voxel_tree.hpp"

#include <array>
#include <utility>

namespace impetus::inline trees {
namespace {

/// The grid is this much wider than the solid on each side, in shares of the solid's size.
constexpr double kGridMargin = 1e-11;

using Place = std::array<std::uint32_t, 3>;

/// A cell that the solid touches and the surface in it: none when it lies wholly inside.
struct VoxelCell {
  Place place;
  SurfacePart part;
};

VoxelGrid grid_round(const TriangleMesh& solid, int divisions) {
  const Bounds bounds = bounds_of(solid);
  const double half_m = (0.5 + kGridMargin) * bounds.sides().maxCoeff();
  return {bounds.middle() - Vector3::Constant(half_m), 2.0 * half_m, divisions};
}

int cube_root_of(int branching) {
  int root = 2;
  while (root * root * root < branching) {
    ++root;
  }
  return root;
}

/// Builds one tree, level by level.
class VoxelBuilder {
 public:
  VoxelBuilder(const TriangleMesh& solid, const TreeSettings& settings, const Progress& progress)
      : solid_(&solid),
        settings_(&settings),
        progress_(&progress),
        description_(solid),
        grid_(grid_round(solid, cube_root_of(settings.branching))) {}

  BuiltTree build() {
    std::vector<VoxelCell> level;
    level.push_back({{0, 0, 0}, whole_surface(*solid_)});
    add(std::move(level));
    for (int depth = 1; depth <= levels_to_build(*settings_); ++depth) {
      along_ *= static_cast<std::uint32_t>(grid_.divisions);
      std::vector<VoxelCell> finer = next_level(depth);
      if (finer.empty()) {
        break;
      }
      add(std::move(finer));
    }
    return described();
  }

 private:
  void report(double share) const {
    if (*progress_) {
      (*progress_)(share);
    }
  }

  void add(std::vector<VoxelCell> level) {
    starts_.push_back(static_cast<std::int32_t>(cells_.size()));
    places_.clear();
    for (VoxelCell& cell : level) {
      const auto& [x, y, z] = cell.place;
      cells_.push_back(x + along_ * (y + along_ * z));
      places_.push_back(cell.place);
      parts_.push_back(std::move(cell.part));
      links_.push_back({0, 0});
    }
  }

  /// The children of the last level's nodes, cells on the way from `along_` / k to `along_`.
  std::vector<VoxelCell> next_level(int depth) {
    std::vector<VoxelCell> finer;
    const auto begin = static_cast<std::size_t>(starts_.back());
    for (std::size_t i = 0; i < places_.size(); ++i) {
      report((depth - 1 + static_cast<double>(i) / static_cast<double>(places_.size())) /
             (2.0 * levels_to_build(*settings_)));
      NodeLinks& node = links_[begin + i];
      if (parts_[begin + i].empty()) {
        continue;
      }
      node.first_child = static_cast<std::int32_t>(cells_.size() + finer.size());
      for (VoxelCell& child : children_of(places_[i], parts_[begin + i])) {
        finer.push_back(std::move(child));
        ++node.child_count;
      }
    }
    return finer;
  }

  /// x fastest, then y, then z.
  std::vector<VoxelCell> children_of(const Place& place, const SurfacePart& part) const {
    const auto k = static_cast<std::uint32_t>(grid_.divisions);
    std::vector<VoxelCell> cells;
    for (VoxelCell& z : slices({{k * place[0], k * place[1], k * place[2]}, part}, 2)) {
      for (VoxelCell& y : slices(std::move(z), 1)) {
        for (VoxelCell& x : slices(std::move(y), 0)) {
          if (!x.part.empty() || description_.distance().signed_distance_m(centre_of(x)) < 0.0) {
            cells.push_back(std::move(x));
          }
        }
      }
    }
    return cells;
  }

  /// The k slices of a cell along one axis, cut from its least side on.
  [[nodiscard]] std::vector<VoxelCell> slices(VoxelCell cell, int axis) const {
    const auto index = static_cast<std::size_t>(axis);
    std::vector<VoxelCell> result;
    for (int slice = 1; slice < grid_.divisions; ++slice) {
      Place next = cell.place;
      ++next[index];
      auto [above, below] = cut(cell.part, {Vector3::Unit(axis), wall_at(axis, next[index])},
                                kSnapShare * grid_.edge_m);
      result.push_back({cell.place, std::move(below)});
      cell = {next, std::move(above)};
    }
    result.push_back(std::move(cell));
    return result;
  }

  [[nodiscard]] double wall_at(int axis, std::uint32_t index) const {
    return grid_.least[axis] + grid_.edge_m / along_ * index;
  }

  [[nodiscard]] Vector3 centre_of(const VoxelCell& cell) const {
    return grid_.least + grid_.edge_m / along_ *
                             Vector3(cell.place[0] + 0.5, cell.place[1] + 0.5, cell.place[2] + 0.5);
  }

  BuiltTree described() {
    NodeVolumes volumes(grid_, std::move(cells_), starts_);
    std::vector<NodeSurface> surfaces;
    for (std::int32_t node = 0; node < volumes.size(); ++node) {
      report(0.5 + 0.5 * node / volumes.size());
      const SurfacePart& part = parts_[static_cast<std::size_t>(node)];
      // Without surface a cell is solid throughout and reaches nowhere.
      surfaces.push_back(part.empty() ? NodeSurface{} : description_.of(volumes.at(node), part));
    }
    report(1.0);
    return {
        VolumeTree(std::move(volumes), std::move(links_), std::move(surfaces), std::move(starts_)),
        std::move(parts_)};
  }

  const TriangleMesh* solid_;
  const TreeSettings* settings_;
  const Progress* progress_;
  NodeDescription description_;
  VoxelGrid grid_;
  std::uint32_t along_{1};     ///< cells along an edge of the last level
  std::vector<Place> places_;  ///< of the last level
  std::vector<std::uint32_t> cells_;
  std::vector<std::int32_t> starts_;
  std::vector<NodeLinks> links_;
  std::vector<SurfacePart> parts_;
};

}  // namespace

BuiltTree build_voxel_tree(const TriangleMesh& solid, const TreeSettings& settings,
                           const Progress& progress) {
  require_buildable(solid, settings);
  return VoxelBuilder(solid, settings, progress).build();
}

}  // namespace impetus::inline trees
