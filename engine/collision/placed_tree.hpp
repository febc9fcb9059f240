// A volume tree placed in the world for one step: nodes are transformed when first visited.
//
// Trees of spheres alone, the commonest, are placed a block of siblings at a time, into arrays that
// a block is tested from (sphere_lanes.hpp).
// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <cstdint>
#include <vector>

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

  /// Moves the tree to `pose`; every node placed before is stale.
  void move_to(const Pose& pose) {
    pose_ = pose;
    ++step_;
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
    const auto slot = static_cast<std::size_t>(node);
    const Sphere own = own_spheres_->at(slot);
    return placed_in_[slot] == step_ ? Sphere{{x_[slot], y_[slot], z_[slot]}, own.radius_m}
                                     : placed(own, pose_);
  }

  /// The spheres of `first` and the nodes after it, in world coordinates, transformed at most once
  /// per step. `count` nodes from `first` are all the children of one node, or one of them after
  /// all were placed, or the root. Precondition: of_spheres().
  SphereLanes world_lanes(std::int32_t first, std::int32_t count) {
    assert(of_spheres());
    const auto slot = static_cast<std::size_t>(first);
    if (placed_in_[slot] != step_) {
      place(slot, static_cast<std::size_t>(count));
    }
    return {&x_[slot], &y_[slot], &z_[slot], own_spheres_->lanes(slot).radius_m};
  }

  /// Places the nodes as world_lanes() does, for whoever asks for one after the other; of any other
  /// tree each is placed when it is asked for.
  void place_siblings(std::int32_t first, std::int32_t count) {
    if (of_spheres()) {
      static_cast<void>(world_lanes(first, count));
    }
  }

  /// From node 0 on: the spheres of nodes that a descent has visited since the tree was moved,
  /// whose world_lanes() were asked for; others mean nothing. Precondition: of_spheres().
  [[nodiscard]] SphereLanes world_lanes_of_visited() const {
    return {x_.data(), y_.data(), z_.data(), own_spheres_->lanes(0).radius_m};
  }

  /// How many nodes were transformed into the world since the tree was first placed.
  [[nodiscard]] std::int64_t nodes_transformed() const { return transformed_; }

  /// The node's volume in world coordinates, transformed at most once per step.
  Volume world_volume(std::int32_t node) {
    return of_spheres() ? Volume(world_sphere(node)) : placed_volume(node);
  }

 private:
  void place(std::size_t first, std::size_t count);
  const Volume& placed_volume(std::int32_t node);

  const VolumeTree* tree_;
  const SphereArrays* own_spheres_;  ///< null unless all nodes are spheres
  double reach_m_{0.0};
  Pose pose_;
  std::uint64_t step_{1};
  std::vector<double> x_;  ///< of the centres of a tree of spheres, empty for any other
  std::vector<double> y_;
  std::vector<double> z_;
  std::vector<Volume> volumes_;  ///< empty for a tree of spheres
  std::vector<std::uint64_t> placed_in_;
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
