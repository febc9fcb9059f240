// The volume tree: bounds of an object at growing levels of detail.
//
//   level 0   [ root ]
//   level 1   [ n1 n2 n3 ]            a level is a contiguous range of nodes
//   level 2   [ n4 n5 | n6 | n7 n8 ]  the children of a node are contiguous
//
// Invariant: the part of the object that a node bounds lies within the node, and is covered by
// its children. A node without children keeps standing for its part at every deeper level.
// (Dingliana 2002, sec. 2.2.1 and 3.1.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/shapes/sphere.hpp"

namespace impetus {

struct VolumeNode {
  Sphere volume;  ///< in the body's frame, from its centre of mass
  std::int32_t first_child{0};
  std::int32_t child_count{0};
};

class VolumeTree {
 public:
  /// Takes nodes in breadth-first order and the index of each level's first node.
  /// `fit_errors_m`, one per level, may be left out: then the diameter of the level's largest
  /// node stands in, which is right for any node that touches the object.
  /// Throws std::invalid_argument when they do not form such a tree.
  VolumeTree(std::vector<VolumeNode> nodes, std::vector<std::int32_t> level_starts,
             std::vector<double> fit_errors_m = {});

  [[nodiscard]] const VolumeNode& node(std::int32_t index) const {
    return nodes_[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] std::int32_t node_count() const { return static_cast<std::int32_t>(nodes_.size()); }
  [[nodiscard]] int level_count() const { return static_cast<int>(level_starts_.size()); }

  /// How far the nodes that stand for the object at `level` reach beyond it, at worst (metres): an
  /// upper bound. Levels past the last are as good as the last.
  [[nodiscard]] double fit_error_m(int level) const;

  /// Radius about the centre of mass that bounds the whole object (metres).
  [[nodiscard]] double bounding_radius_m() const { return bounding_radius_m_; }

 private:
  std::vector<VolumeNode> nodes_;
  std::vector<std::int32_t> level_starts_;
  std::vector<double> fit_errors_m_;
  double bounding_radius_m_;
};

/// A sphere is its own tree of one node: nothing finer exists.
VolumeTree single_node_tree(const Sphere& sphere);

}  // namespace impetus
