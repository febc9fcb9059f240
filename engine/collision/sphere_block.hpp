// Sibling spheres of two placed trees, side by side: what is tested at once.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/collision/node_pairs.hpp"
#include "engine/collision/placed_tree.hpp"

namespace impetus::inline collision {

/// What stands for a node one level deeper: its children, or itself.
inline NodeLinks one_level_deeper(const VolumeTree& tree, std::int32_t node) {
  const NodeLinks& links = tree.links(node);
  return links.child_count > 0 ? links : NodeLinks{node, 1};
}

/// `rows` spheres of a from node `first.a` on, `columns` of b from `first.b` on, in world.
struct SphereBlock {
  NodePair first;
  SphereLanes a;
  int rows;
  SphereLanes b;
  int columns;

  /// The bits of all its pairs, as overlaps_of_block() numbers them.
  [[nodiscard]] std::uint64_t all() const {
    std::uint64_t bits = 0;
    for (int row = 0; row < rows; ++row) {
      bits |= ((std::uint64_t{1} << columns) - 1) << (kLanes * row);
    }
    return bits;
  }
};

inline Sphere sphere_of(const SphereLanes& lanes, int index) {
  return {{lanes.x[index], lanes.y[index], lanes.z[index]}, lanes.radius_m[index]};
}

/// A number for each sphere of a block's row or column.
using LaneValues = std::array<double, kLanes>;
inline std::size_t lane(int index) { return static_cast<std::size_t>(index); }

/// Visits the blocks of all pairs one level below `nodes`, row by row. Precondition: trees of
/// spheres, and both nodes are placed with their siblings.
template <typename Visit>
void for_each_block_below(PlacedTree& a, PlacedTree& b, const NodePair& nodes, const Visit& visit) {
  const NodeLinks of_a = one_level_deeper(a.tree(), nodes.a);
  const NodeLinks of_b = one_level_deeper(b.tree(), nodes.b);
  const NodePair first{of_a.first_child, of_b.first_child};
  const SphereLanes rows = a.world_lanes(first.a, of_a.child_count);
  const SphereLanes columns = b.world_lanes(first.b, of_b.child_count);
  if (of_a.child_count <= kLanes && of_b.child_count <= kLanes) {
    visit(SphereBlock{first, rows, of_a.child_count, columns, of_b.child_count});
    return;
  }
  for (std::int32_t i = first.a; i < first.a + of_a.child_count; ++i) {
    for (std::int32_t j = 0; j < of_b.child_count; j += kLanes) {
      const int count = std::min(of_b.child_count - j, kLanes);
      visit(SphereBlock{{i, first.b + j}, a.world_lanes(i), 1, b.world_lanes(first.b + j), count});
    }
  }
}

}  // namespace impetus::inline collision
