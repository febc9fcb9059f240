// The nodes of a tree in blocks of up to kLanes siblings, as spheres are placed and tested.
//
//   node      0 | 1 2 3 4 5 6 7 8 | 9 10 11 | ...      children of one node lie side by side
//   block     0 |        1        |    2    | ...      the ninth child of a node begins a new one
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/numerics/at.hpp"

namespace impetus::inline trees {

struct NodeLinks;

/// In which block each node is, and where in it.
class SiblingBlocks {
 public:
  SiblingBlocks() = default;

  /// Of nodes in breadth-first order.
  explicit SiblingBlocks(const std::vector<NodeLinks>& links);

  [[nodiscard]] std::uint32_t count() const { return count_; }
  [[nodiscard]] std::uint32_t block_of(std::int32_t node) const { return slots_[at(node)] >> 3; }
  [[nodiscard]] std::uint32_t lane_of(std::int32_t node) const { return slots_[at(node)] & 7; }
  [[nodiscard]] std::size_t bytes() const { return slots_.size() * sizeof(std::uint32_t); }

 private:
  void add_siblings(std::int32_t nodes);

  std::vector<std::uint32_t> slots_;  ///< by node: the block, and in three low bits the place in it
  std::uint32_t count_{0};
};

}  // namespace impetus::inline trees
