// SPDX-License-Identifier: MIT
#include "engine/collision/placed_tree.hpp"

#include <algorithm>

namespace impetus::inline collision {

PlacedTree::PlacedTree(const VolumeTree& tree)
    : tree_(&tree),
      own_spheres_(tree.volumes().all_spheres().empty() ? nullptr : &tree.volumes().all_spheres()),
      placed_in_(static_cast<std::size_t>(tree.node_count()), 0) {
  if (of_spheres()) {
    const std::size_t writable = placed_in_.size() + kLanes - 1;
    x_.resize(writable);
    y_.resize(writable);
    z_.resize(writable);
  } else {
    volumes_.resize(placed_in_.size());
  }
  constexpr double kRounding = 1e-9;
  for (std::int32_t node = 0; node < tree.node_count(); ++node) {
    const Sphere bound = bounding_sphere(tree.volume(node));
    reach_m_ = std::max(reach_m_, (1.0 + kRounding) * (bound.centre.norm() + bound.radius_m));
  }
}

void PlacedTree::place(std::size_t first, std::size_t count) {
  for (std::size_t block = first; block < first + count; block += kLanes) {
    place_block(own_spheres_->lanes(block), pose_, {&x_[block], &y_[block], &z_[block]});
  }
  std::fill_n(placed_in_.begin() + static_cast<std::ptrdiff_t>(first), count, step_);
  transformed_ += static_cast<std::int64_t>(count);
}

const Volume& PlacedTree::placed_volume(std::int32_t node) {
  const auto slot = static_cast<std::size_t>(node);
  if (placed_in_[slot] != step_) {
    volumes_[slot] = placed(tree_->volume(node), pose_);
    placed_in_[slot] = step_;
    ++transformed_;
  }
  return volumes_[slot];
}

}  // namespace impetus::inline collision
