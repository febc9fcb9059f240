// SPDX-License-Identifier: MIT
#include "engine/collision/placed_tree.hpp"

#include <algorithm>

namespace impetus::inline collision {

PlacedTree::PlacedTree(const VolumeTree& tree)
    : tree_(&tree),
      own_spheres_(tree.volumes().all_spheres().empty() ? nullptr : &tree.volumes().all_spheres()),
      blocks_(tree.blocks().count()) {
  if (!of_spheres()) {
    volumes_.resize(at(tree.node_count()));
    placed_in_.resize(volumes_.size());
  }
  constexpr double kRounding = 1e-9;
  for (std::int32_t node = 0; node < tree.node_count(); ++node) {
    const Sphere bound = bounding_sphere(tree.volume(node));
    reach_m_ = std::max(reach_m_, (1.0 + kRounding) * (bound.centre.norm() + bound.radius_m));
  }
}

void PlacedTree::take_tree_of(const PlacedTree& other) {
  tree_ = other.tree_;
  own_spheres_ = other.own_spheres_;
  reach_m_ = other.reach_m_;
  blocks_.expect(tree_->blocks().count());
  blocks_.move();
  volumes_.resize(std::max(volumes_.size(), other.volumes_.size()));
  placed_in_.resize(volumes_.size());
}

const PlacedBlock& PlacedTree::place(std::int32_t first, std::int32_t count) {
  const SiblingBlocks& siblings = tree_->blocks();
  for (std::int32_t node = first; node < first + count; node += kLanes) {
    PlacedBlock& placed = blocks_.place(siblings.block_of(node));
    const std::size_t first_of_block = at(node) - siblings.lane_of(node);
    place_block(own_spheres_->lanes(first_of_block), pose_, {placed.x, placed.y, placed.z});
  }
  transformed_ += count;
  return *blocks_.find(siblings.block_of(first));
}

const Volume& PlacedTree::placed_volume(std::int32_t node) {
  const std::size_t slot = at(node);
  if (placed_in_[slot] != blocks_.pose()) {
    volumes_[slot] = placed(tree_->volume(node), pose_);
    placed_in_[slot] = blocks_.pose();
    ++transformed_;
  }
  return volumes_[slot];
}

}  // namespace impetus::inline collision
