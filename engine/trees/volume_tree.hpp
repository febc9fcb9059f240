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
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/numerics/at.hpp"
#include "engine/trees/node_volumes.hpp"

namespace impetus::inline trees {

/// The children of a node: `count` of them from `first_child` on.
struct NodeLinks {
  std::int32_t first_child{0};
  std::int32_t child_count{0};

  friend bool operator==(const NodeLinks&, const NodeLinks&) = default;
};

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
  std::vector<NodeSurface> surfaces_;
  std::vector<std::int32_t> level_starts_;
  std::vector<double> fit_errors_m_;        ///< by level
  std::vector<double> half_thicknesses_m_;  ///< by level
  double bounding_radius_m_;
};

/// A volume is its own tree of one node: nothing finer exists.
VolumeTree single_node_tree(const Volume& volume);

}  // namespace impetus::inline trees
