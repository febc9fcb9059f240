// The volumes of a tree's nodes, each kind in an array of its own: what a kind does not use is not
// stored.
//
//   one kind      node i is element i of that kind's array
//   voxels        node i is a cell number; its place and edge follow from its level
//   several       `slots` says for each node the kind (three low bits) and the element
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/volumes/sphere_lanes.hpp"
#include "engine/volumes/volume.hpp"

namespace impetus::inline trees {

/// A cube split into `divisions`³ equal cubes, each of them again, and so on.
struct VoxelGrid {
  Vector3 least{Vector3::Zero()};  ///< the corner of the root cube with the least coordinates
  double edge_m{0.0};              ///< of the root cube
  int divisions{2};                ///< along each edge, from one level to the next

  friend bool operator==(const VoxelGrid&, const VoxelGrid&) = default;
};

/// By this share of the grid's edge a voxel's cube reaches beyond its cell on every side: rounding
/// must not leave a face in the wall between two cells outside the cube that it belongs to.
inline constexpr double kVoxelMargin = 1e-12;

class NodeVolumes {
 public:
  NodeVolumes() = default;

  explicit NodeVolumes(const std::vector<Volume>& volumes);

  /// Voxels: `cells` holds for each node x + n (y + n z), the place of its cube among the n =
  /// divisions^level along each edge. Throws std::invalid_argument for a cell outside the grid or
  /// levels that are none.
  NodeVolumes(const VoxelGrid& grid, std::vector<std::uint32_t> cells,
              std::vector<std::int32_t> level_starts);

  [[nodiscard]] std::int32_t size() const;
  [[nodiscard]] Volume at(std::int32_t node) const;

  /// Node by node when all are spheres, else empty.
  [[nodiscard]] const SphereArrays& all_spheres() const { return all_spheres_; }

  [[nodiscard]] bool are_voxels() const { return !cells_.empty(); }
  [[nodiscard]] const VoxelGrid& grid() const { return grid_; }
  [[nodiscard]] const std::vector<std::uint32_t>& cells() const { return cells_; }

  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] Cube voxel(std::int32_t node) const;

  SphereArrays all_spheres_;     ///< when there is nothing else
  std::vector<Sphere> spheres_;  ///< among other kinds
  std::vector<LineSwept> lines_;
  std::vector<RectangleSwept> rectangles_;
  std::vector<Box> boxes_;
  std::vector<Cube> cubes_;
  std::vector<std::uint32_t> slots_;  ///< empty for nodes of one kind

  VoxelGrid grid_;
  std::vector<std::uint32_t> cells_;
  std::vector<std::int32_t> level_starts_;  ///< of voxels
};

}  // namespace impetus::inline trees
