// SPDX-License-Identifier: MIT
#include "engine/trees/volume_tree.hpp"

#include <algorithm>
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

/// The diameter of the largest node that stands for the object at each level.
std::vector<double> diameters(const std::vector<VolumeNode>& nodes,
                              const std::vector<std::int32_t>& starts) {
  std::vector<double> result;
  double of_leaves = 0.0;
  for (std::size_t level = 0; level < starts.size(); ++level) {
    const auto begin = static_cast<std::size_t>(starts[level]);
    const std::size_t end =
        level + 1 < starts.size() ? static_cast<std::size_t>(starts[level + 1]) : nodes.size();
    double largest = of_leaves;
    for (std::size_t index = begin; index < end; ++index) {
      const double diameter = 2.0 * nodes[index].volume.radius_m;
      largest = std::max(largest, diameter);
      of_leaves = nodes[index].child_count == 0 ? std::max(of_leaves, diameter) : of_leaves;
    }
    result.push_back(largest);
  }
  return result;
}

}  // namespace

VolumeTree::VolumeTree(std::vector<VolumeNode> nodes, std::vector<std::int32_t> level_starts,
                       std::vector<double> fit_errors_m)
    : nodes_(std::move(nodes)),
      level_starts_(std::move(level_starts)),
      fit_errors_m_(std::move(fit_errors_m)),
      bounding_radius_m_(0.0) {
  if (nodes_.empty() || !is_breadth_first(nodes_) || !levels_match(nodes_, level_starts_)) {
    throw std::invalid_argument("volume tree: nodes are not in breadth-first order by level");
  }
  if (fit_errors_m_.empty()) {
    fit_errors_m_ = diameters(nodes_, level_starts_);
  }
  if (fit_errors_m_.size() != level_starts_.size()) {
    throw std::invalid_argument("volume tree: expected one fit error per level");
  }
  const Sphere& root = nodes_.front().volume;
  bounding_radius_m_ = root.centre.norm() + root.radius_m;
}

double VolumeTree::fit_error_m(int level) const {
  return fit_errors_m_[static_cast<std::size_t>(std::min(level, level_count() - 1))];
}

VolumeTree single_node_tree(const Sphere& sphere) {
  return {{VolumeNode{sphere, 0, 0}}, {0}, {0.0}};
}

}  // namespace impetus
