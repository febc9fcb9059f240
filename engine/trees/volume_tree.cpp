// SPDX-License-Identifier: MIT
#include "engine/trees/volume_tree.hpp"

#include <stdexcept>
#include <utility>

namespace impetus {
namespace {

/// Breadth-first order means: each node's children follow the children of the node before it.
bool is_breadth_first(const std::vector<VolumeNode>& nodes) {
  std::int32_t next_child = 1;
  for (const VolumeNode& node : nodes) {
    if (node.child_count < 0 || (node.child_count > 0 && node.first_child != next_child)) {
      return false;
    }
    next_child += node.child_count;
  }
  return next_child == static_cast<std::int32_t>(nodes.size());
}

bool levels_match(const std::vector<VolumeNode>& nodes, const std::vector<std::int32_t>& starts) {
  std::int32_t begin = 0;
  std::int32_t end = 1;
  for (const std::int32_t start : starts) {
    if (start != begin || begin == end) {
      return false;
    }
    std::int32_t children = 0;
    for (std::int32_t index = begin; index < end; ++index) {
      children += nodes[static_cast<std::size_t>(index)].child_count;
    }
    begin = std::exchange(end, end + children);
  }
  return begin == end;
}

}  // namespace

VolumeTree::VolumeTree(std::vector<VolumeNode> nodes, std::vector<std::int32_t> level_starts)
    : nodes_(std::move(nodes)), level_starts_(std::move(level_starts)), bounding_radius_m_(0.0) {
  if (nodes_.empty() || !is_breadth_first(nodes_) || !levels_match(nodes_, level_starts_)) {
    throw std::invalid_argument("volume tree: nodes are not in breadth-first order by level");
  }
  const Sphere& root = nodes_.front().volume;
  bounding_radius_m_ = root.centre.norm() + root.radius_m;
}

VolumeTree single_node_tree(const Sphere& sphere) { return {{VolumeNode{sphere, 0, 0}}, {0}}; }

}  // namespace impetus
