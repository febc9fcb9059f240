// A volume tree placed in the world for one step: nodes are transformed when first visited.
//
// Trees of spheres alone, the commonest, are placed a block of siblings at a time, in memory that a
// world lends (placed_blocks.hpp), from which a block is tested (sphere_lanes.hpp).
// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <cstdint>
#include <vector>

#include "engine/collision/placed_blocks.hpp"
#include "engine/trees/volume_tree.hpp"
#include "engine/volumes/enclosure.hpp"
#include "engine/volumes/sphere_lanes.hpp"
#include "engine/volumes/volume.hpp"

namespace impetus::inline collision {

/// A tree and where its nodes are in the world.
class PlacedTree {
 public:
  /// `tree` must outlive this.
  explicit PlacedTree(const VolumeTree& tree);

  /// Nothing is placed now, and from now on in memory of `store` (placed_blocks.hpp).
  void take_memory_from(BlockStore& store) { blocks_.borrow(store); }

  /// Becomes the tree that `other` has, of which nothing is placed, in the memory that this has.
  void take_tree_of(const PlacedTree& other);

  /// Moves the tree to `pose`; every node placed before is stale.
  void move_to(const Pose& pose) {
    pose_ = pose;
    blocks_.move();
  }

  [[nodiscard]] const VolumeTree& tree() const { return *tree_; }
  [[nodiscard]] const Pose& pose() const { return pose_; }

  /// Radius about the centre of mass that holds every node of every level, rounding included
  /// (metres).
  [[nodiscard]] double reach_m() const { return reach_m_; }

  [[nodiscard]] bool of_spheres() const { return own_spheres_ != nullptr; }

  /// The node's sphere in world coordinates. Precondition: of_spheres().
  [[nodiscard]] Sphere world_sphere(std::int32_t node) const {
    assert(of_spheres());
    const Sphere own = own_spheres_->at(at(node));
    const PlacedBlock* block = blocks_.find(tree_->blocks().block_of(node));
    const std::uint32_t lane = tree_->blocks().lane_of(node);
    return block != nullptr ? Sphere{{block->x[lane], block->y[lane], block->z[lane]}, own.radius_m}
                            : placed(own, pose_);
  }

  /// The spheres of `first` and the nodes after it in its block, in world coordinates, transformed
  /// at most once per step. `count` nodes from `first` are all the children of one node, all of
  /// which are placed, or one of them after all were placed, or the root. Precondition:
  /// of_spheres().
  SphereLanes world_lanes(std::int32_t first, std::int32_t count = 1) {
    assert(of_spheres());
    const PlacedBlock* block = blocks_.find(tree_->blocks().block_of(first));
    if (block == nullptr) {
      block = &place(first, count);
    }
    const std::uint32_t lane = tree_->blocks().lane_of(first);
    return {block->x + lane, block->y + lane, block->z + lane,
            own_spheres_->lanes(at(first)).radius_m};
  }

  /// Places the nodes as world_lanes() does, for whoever asks for one after the other; of any other
  /// tree each is placed when it is asked for.
  void place_siblings(std::int32_t first, std::int32_t count) {
    if (of_spheres()) {
      static_cast<void>(world_lanes(first, count));
    }
  }

  /// How many nodes were transformed into the world since the tree was first placed.
  [[nodiscard]] std::int64_t nodes_transformed() const { return transformed_; }

  /// The node's volume in world coordinates, transformed at most once per step.
  Volume world_volume(std::int32_t node) {
    return of_spheres() ? Volume(world_sphere(node)) : placed_volume(node);
  }

 private:
  /// The block that `first` is in, once all are placed.
  const PlacedBlock& place(std::int32_t first, std::int32_t count);
  const Volume& placed_volume(std::int32_t node);

  const VolumeTree* tree_;
  const SphereArrays* own_spheres_;  ///< null unless all nodes are spheres
  PlacedBlocks blocks_;              ///< of a tree of spheres; also counts the poses of any other
  Pose pose_;
  double reach_m_{0.0};
  std::vector<Volume> volumes_;           ///< of any other, by node
  std::vector<std::uint64_t> placed_in_;  ///< likewise: the pose
  std::int64_t transformed_{0};
};

/// Whether two placed nodes overlap.
inline bool nodes_overlap(PlacedTree& a, std::int32_t node_a, PlacedTree& b, std::int32_t node_b) {
  return a.of_spheres() && b.of_spheres() ? overlap(a.world_sphere(node_a), b.world_sphere(node_b))
                                          : overlap(a.world_volume(node_a), b.world_volume(node_b));
}

/// The contact of two placed nodes; see touch() of two volumes.
inline TouchPoint touch_of_nodes(PlacedTree& a, std::int32_t node_a, PlacedTree& b,
                                 std::int32_t node_b, const Vector3& fallback) {
  return a.of_spheres() && b.of_spheres()
             ? touch(a.world_sphere(node_a), b.world_sphere(node_b), fallback)
             : touch(a.world_volume(node_a), b.world_volume(node_b), fallback);
}

/// Whether a placed node touches a wall or reaches beyond it.
inline bool node_reaches_wall(PlacedTree& tree, std::int32_t node, const Enclosure& walls) {
  return tree.of_spheres() ? reaches_wall(walls, tree.world_sphere(node))
                           : reaches_wall(walls, tree.world_volume(node));
}

/// The contact of a placed node and a wall.
inline TouchPoint touch_of_wall(PlacedTree& tree, std::int32_t node, const Enclosure& walls,
                                int wall) {
  return tree.of_spheres() ? touch_wall(walls, wall, tree.world_sphere(node))
                           : touch_wall(walls, wall, tree.world_volume(node));
}

}  // namespace impetus::inline collision
