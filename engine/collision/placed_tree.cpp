// SPDX-License-Identifier: MIT
#include "engine/collision/placed_tree.hpp"

#include <algorithm>

namespace impetus {

PlacedTree::PlacedTree(const VolumeTree& tree)
    : tree_(&tree),
      own_spheres_(tree.volumes().all_spheres().empty() ? nullptr
                                                        : tree.volumes().all_spheres().data()),
      placed_in_(static_cast<std::size_t>(tree.node_count()), 0) {
  if (of_spheres()) {
    spheres_.resize(placed_in_.size());
  } else {
    volumes_.resize(placed_in_.size());
  }
  constexpr double kRounding = 1e-9;
  for (std::int32_t node = 0; node < tree.node_count(); ++node) {
    const Sphere bound = bounding_sphere(tree.volume(node));
    reach_m_ = std::max(reach_m_, (1.0 + kRounding) * (bound.centre.norm() + bound.radius_m));
  }
}

const Volume& PlacedTree::placed_volume(std::int32_t node) {
  const auto slot = static_cast<std::size_t>(node);
  if (placed_in_[slot] != step_) {
    volumes_[slot] = placed(tree_->volume(node), pose_);
    placed_in_[slot] = step_;
  }
  return volumes_[slot];
}

}  // namespace impetus
