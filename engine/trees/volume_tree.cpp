// SPDX-License-Identifier: MIT
#include "engine/trees/volume_tree.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "engine/volumes/rounded_box.hpp"

namespace impetus::inline trees {
namespace {

/// Breadth-first order means: each node's children follow the children of the node before it.
bool is_breadth_first(const std::vector<NodeLinks>& links) {
  std::int64_t next_child = 1;
  for (const NodeLinks& node : links) {
    if (node.child_count < 0 || (node.child_count > 0 && node.first_child != next_child)) {
      return false;
    }
    next_child += node.child_count;
  }
  return next_child == static_cast<std::int64_t>(links.size());
}

bool levels_match(const std::vector<NodeLinks>& links, const std::vector<std::int32_t>& starts) {
  std::int32_t begin = 0;
  std::int32_t end = 1;
  for (const std::int32_t start : starts) {
    if (start != begin || begin == end) {
      return false;
    }
    std::int32_t children = 0;
    for (std::int32_t index = begin; index < end; ++index) {
      children += links[static_cast<std::size_t>(index)].child_count;
    }
    begin = std::exchange(end, end + children);
  }
  return begin == end;
}

std::vector<Volume> volumes_of(const std::vector<VolumeNode>& nodes) {
  std::vector<Volume> volumes;
  volumes.reserve(nodes.size());
  for (const VolumeNode& node : nodes) {
    volumes.push_back(node.volume);
  }
  return volumes;
}

std::vector<NodeLinks> links_of(const std::vector<VolumeNode>& nodes) {
  std::vector<NodeLinks> links;
  links.reserve(nodes.size());
  for (const VolumeNode& node : nodes) {
    links.push_back({node.first_child, node.child_count});
  }
  return links;
}

std::vector<NodeSurface> surfaces_of(const std::vector<VolumeNode>& nodes) {
  std::vector<NodeSurface> surfaces;
  surfaces.reserve(nodes.size());
  for (const VolumeNode& node : nodes) {
    surfaces.push_back(node.surface);
  }
  return surfaces;
}

}  // namespace

VolumeTree::VolumeTree(const std::vector<VolumeNode>& nodes, std::vector<std::int32_t> level_starts)
    : VolumeTree(NodeVolumes(volumes_of(nodes)), links_of(nodes), surfaces_of(nodes),
                 std::move(level_starts)) {}

VolumeTree::VolumeTree(NodeVolumes volumes, std::vector<NodeLinks> links,
                       std::vector<NodeSurface> surfaces, std::vector<std::int32_t> level_starts)
    : volumes_(std::move(volumes)),
      links_(std::move(links)),
      surfaces_(std::move(surfaces)),
      level_starts_(std::move(level_starts)),
      bounding_radius_m_(0.0) {
  if (links_.empty() || !is_breadth_first(links_) || !levels_match(links_, level_starts_)) {
    throw std::invalid_argument("volume tree: nodes are not in breadth-first order by level");
  }
  if (volumes_.size() != node_count() || surfaces_.size() != links_.size()) {
    throw std::invalid_argument("volume tree: expected a volume and a surface for every node");
  }
  measure_half_thicknesses();
  double of_leaves = 0.0;
  for (int level = 0; level < level_count(); ++level) {
    double worst = of_leaves;
    for (std::int32_t node = level_begin(level); node < level_end(level); ++node) {
      const double error_m = surfaces_[at(node)].fit_error_m;
      worst = std::max(worst, error_m);
      of_leaves = links_[at(node)].child_count == 0 ? std::max(of_leaves, error_m) : of_leaves;
    }
    fit_errors_m_.push_back(worst);
  }
  const Sphere root = bounding_sphere(volume(0));
  bounding_radius_m_ = root.centre.norm() + root.radius_m;
}

void VolumeTree::measure_half_thicknesses() {
  double of_leaves = std::numeric_limits<double>::infinity();
  for (int level = 0; level < level_count(); ++level) {
    double least = of_leaves;
    for (std::int32_t node = level_begin(level); node < level_end(level); ++node) {
      const double thickness_m = least_half_width_m(volume(node));
      least = std::min(least, thickness_m);
      of_leaves = links_[at(node)].child_count == 0 ? std::min(of_leaves, thickness_m) : of_leaves;
    }
    half_thicknesses_m_.push_back(least);
  }
}

std::vector<std::int32_t> VolumeTree::standing_at(int level) const {
  std::vector<std::int32_t> standing{0};
  for (int depth = 0; depth < level; ++depth) {
    std::vector<std::int32_t> deeper;
    for (const std::int32_t node : standing) {
      const auto& [first, count] = links(node);
      if (count == 0) {
        deeper.push_back(node);
      }
      for (std::int32_t child = first; child < first + count; ++child) {
        deeper.push_back(child);
      }
    }
    standing = std::move(deeper);
  }
  return standing;
}

double VolumeTree::fit_error_m(int level) const {
  return fit_errors_m_[at(std::min(level, level_count() - 1))];
}

double VolumeTree::least_half_thickness_m(int level) const {
  return half_thicknesses_m_[at(std::min(level, level_count() - 1))];
}

std::size_t VolumeTree::bytes() const {
  return volumes_.bytes() + links_.size() * sizeof(NodeLinks) +
         surfaces_.size() * sizeof(NodeSurface) + level_starts_.size() * sizeof(std::int32_t) +
         (fit_errors_m_.size() + half_thicknesses_m_.size()) * sizeof(double);
}

VolumeTree single_node_tree(const Volume& volume) {
  return {std::vector<VolumeNode>{{volume, 0, 0, {}}}, {0}};
}

}  // namespace impetus::inline trees
