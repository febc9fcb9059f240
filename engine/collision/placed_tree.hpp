// A volume tree placed in the world for one step: nodes are transformed when first visited.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/trees/volume_tree.hpp"

namespace impetus {

class PlacedTree {
 public:
  /// `tree` must outlive this.
  explicit PlacedTree(const VolumeTree& tree)
      : tree_(&tree),
        world_(static_cast<std::size_t>(tree.node_count())),
        placed_in_(static_cast<std::size_t>(tree.node_count()), 0) {}

  /// Moves the tree to `pose`; every node placed before is stale.
  void move_to(const Pose& pose) {
    pose_ = pose;
    ++step_;
  }

  [[nodiscard]] const VolumeTree& tree() const { return *tree_; }

  /// The node's volume in world coordinates, transformed at most once per step.
  const Sphere& world_volume(std::int32_t index) {
    const auto slot = static_cast<std::size_t>(index);
    if (placed_in_[slot] != step_) {
      const Sphere volume = std::get<Sphere>(tree_->volume(index));
      world_[slot] = {pose_.transform(volume.centre), volume.radius_m};
      placed_in_[slot] = step_;
    }
    return world_[slot];
  }

 private:
  const VolumeTree* tree_;
  Pose pose_;
  std::uint64_t step_{1};
  std::vector<Sphere> world_;
  std::vector<std::uint64_t> placed_in_;
};

}  // namespace impetus
