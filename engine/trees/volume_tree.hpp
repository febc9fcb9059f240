// The volume tree: bounds of an object at growing levels of detail.
//
//   level 0   [ root ]
//   level 1   [ n1 n2 n3 ]            a level is a contiguous range of nodes
//   level 2   [ n4 n5 | n6 | n7 n8 ]  the children of a node are contiguous
//
// Invariant: the part of the object that a node bounds lies within the node, and is covered by
// its children. A node without children keeps standing for its part at every deeper level.
// Each attribute has an array of its own, so a descent reads volumes and links alone.
// (Dingliana 2002, sec. 2.2.1 and 3.1.1)
//
// The volumes of its nodes lie each kind in an array of its own: what a kind does not use is not
// stored.
//
//   one kind      node i is element i of that kind's array
//   voxels        node i is a cell number; its place and edge follow from its level
//   several       `slots` says for each node the kind (three low bits) and the element
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include "engine/numerics/at.hpp"
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

/// The volumes of all nodes of a tree.
class NodeVolumes {
 public:
  NodeVolumes() = default;

  explicit NodeVolumes(const std::vector<Volume>& volumes);

  /// Voxels: `cells` holds for each node x + n (y + n z), the place of its cube among the n =
  /// divisions^level along each edge. Throws std::invalid_argument for a cell outside the grid or
  /// levels that are none.
  NodeVolumes(const VoxelGrid& grid, std::vector<std::uint32_t> cells,
              std::vector<std::int32_t> level_starts);

  [[nodiscard]] std::int32_t size() const { return size_; }
  [[nodiscard]] Volume at(std::int32_t node) const;

  /// Node by node when all are spheres, else empty.
  [[nodiscard]] const SphereArrays& all_spheres() const { return all_spheres_; }

  [[nodiscard]] bool are_voxels() const { return !cells_.empty(); }
  [[nodiscard]] const VoxelGrid& grid() const { return grid_; }
  [[nodiscard]] const std::vector<std::uint32_t>& cells() const { return cells_; }

  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] Cube voxel(std::int32_t node) const;

  /// A vector for each kind of volume, in their order.
  template <typename... Kinds>
  static std::tuple<std::vector<Kinds>...> arrays_of(const std::variant<Kinds...>&);

  template <std::size_t kKind = 0>
  [[nodiscard]] Volume element(std::size_t kind, std::size_t index) const {
    if constexpr (kKind + 1 < std::variant_size_v<Volume>) {
      if (kind != kKind) {
        return element<kKind + 1>(kind, index);
      }
    }
    return std::get<kKind>(arrays_)[index];
  }

  SphereArrays all_spheres_;  ///< when there is nothing else
  decltype(arrays_of(Volume())) arrays_;
  std::vector<std::uint32_t> slots_;  ///< empty for nodes of one kind
  std::size_t only_kind_{0};          ///< of those
  std::int32_t size_{0};

  VoxelGrid grid_;
  std::vector<std::uint32_t> cells_;
  std::vector<std::int32_t> level_starts_;  ///< of voxels
};

/// The children of a node: `count` of them from `first_child` on.
struct NodeLinks {
  std::int32_t first_child{0};
  std::int32_t child_count{0};

  friend bool operator==(const NodeLinks&, const NodeLinks&) = default;
};

/// The nodes of a tree in blocks of up to kLanes siblings, as spheres are placed and tested: in
/// which block each node is, and where in it.
///
///     node      0 | 1 2 3 4 5 6 7 8 | 9 10 11 | ...      children of one node lie side by side
///     block     0 |        1        |    2    | ...      a ninth child begins a new one
class SiblingBlocks {
 public:
  SiblingBlocks() = default;

  /// Of nodes in breadth-first order.
  explicit SiblingBlocks(const std::vector<NodeLinks>& links);

  [[nodiscard]] std::uint32_t count() const { return count_; }
  [[nodiscard]] std::uint32_t block_of(std::int32_t node) const { return slots_[at(node)] >> 3; }
  [[nodiscard]] std::uint32_t lane_of(std::int32_t node) const { return slots_[at(node)] & 7; }
  [[nodiscard]] std::size_t bytes() const { return slots_.size() * sizeof(std::uint32_t); }

 private:
  void add_siblings(std::int32_t nodes);

  std::vector<std::uint32_t> slots_;  ///< by node: the block, and in three low bits the place in it
  std::uint32_t count_{0};
};

/// The least float that is not below `x`.
inline float rounded_up(double x) {
  const auto nearest = static_cast<float>(x);
  return static_cast<double>(nearest) < x
             ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
             : nearest;
}

inline constexpr std::int32_t kNoGroup = -1;

/// What a node knows of the piece of the object that it bounds.
struct NodeSurface {
  float occupancy{1.0F};         ///< share of the node that is solid (Dingliana 2002, sec. 4.2.4)
  std::int32_t group{kNoGroup};  ///< the nearly plane piece of surface it lies on (sec. 4.2.3)
  /// Outward, unit: −∇ρ/‖∇ρ‖ of the object's density about the node (eq. 4.9, corrected). Zero
  /// where the gradient has no direction: inside, or where opposite faces cancel.
  Eigen::Vector3f density_normal{Eigen::Vector3f::Zero()};
  /// How far the node reaches beyond the object, at worst (metres): an upper bound.
  float fit_error_m{0.0F};

  friend bool operator==(const NodeSurface&, const NodeSurface&) = default;
};

/// A node as a builder hands it over.
struct VolumeNode {
  Volume volume;
  std::int32_t first_child{0};
  std::int32_t child_count{0};
  NodeSurface surface{};
};

/// The tree of one object.
class VolumeTree {
 public:
  /// Takes nodes in breadth-first order and the index of each level's first node. A fit error of a
  /// node that was left at zero stays zero: builders state it.
  /// Throws std::invalid_argument when they do not form such a tree.
  VolumeTree(const std::vector<VolumeNode>& nodes, std::vector<std::int32_t> level_starts);

  /// The same from arrays of one length.
  VolumeTree(NodeVolumes volumes, std::vector<NodeLinks> links, std::vector<NodeSurface> surfaces,
             std::vector<std::int32_t> level_starts);

  [[nodiscard]] std::int32_t node_count() const { return static_cast<std::int32_t>(links_.size()); }
  [[nodiscard]] int level_count() const { return static_cast<int>(level_starts_.size()); }
  [[nodiscard]] std::int32_t level_begin(int level) const { return level_starts_[at(level)]; }
  [[nodiscard]] std::int32_t level_end(int level) const {
    return level + 1 < level_count() ? level_starts_[at(level + 1)] : node_count();
  }

  [[nodiscard]] const NodeLinks& links(std::int32_t node) const { return links_[at(node)]; }
  /// In the body's frame, from its centre of mass.
  [[nodiscard]] Volume volume(std::int32_t node) const { return volumes_.at(node); }
  [[nodiscard]] const NodeVolumes& volumes() const { return volumes_; }
  /// Of a tree of spheres; of any other there are none.
  [[nodiscard]] const SiblingBlocks& blocks() const { return blocks_; }
  [[nodiscard]] const NodeSurface& surface(std::int32_t node) const { return surfaces_[at(node)]; }

  /// The nodes that stand for the whole object at `level`: those of the level, and those without
  /// children of the levels before it, in the order of a staircase descent.
  [[nodiscard]] std::vector<std::int32_t> standing_at(int level) const;

  /// How far the nodes that stand for the object at `level` reach beyond it, at worst (metres): an
  /// upper bound. Levels past the last are as good as the last.
  [[nodiscard]] double fit_error_m(int level) const;

  /// Half the least width of any node that stands for the object at `level` (metres): what moves by
  /// less cannot pass through one unseen. Levels past the last are as the last.
  [[nodiscard]] double least_half_thickness_m(int level) const;

  /// Radius about the centre of mass that bounds the whole object (metres).
  [[nodiscard]] double bounding_radius_m() const { return bounding_radius_m_; }

  /// What the arrays take in memory.
  [[nodiscard]] std::size_t bytes() const;

 private:
  void measure_half_thicknesses();
  NodeVolumes volumes_;
  std::vector<NodeLinks> links_;
  SiblingBlocks blocks_;
  std::vector<NodeSurface> surfaces_;
  std::vector<std::int32_t> level_starts_;
  std::vector<double> fit_errors_m_;        ///< by level
  std::vector<double> half_thicknesses_m_;  ///< by level
  double bounding_radius_m_;
};

/// A volume is its own tree of one node: nothing finer exists.
VolumeTree single_node_tree(const Volume& volume);

}  // namespace impetus::inline trees
