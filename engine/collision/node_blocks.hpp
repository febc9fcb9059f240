// Blocks of node pairs, and memory for lists of them that many descents share.
//
//   a list that is full   gives its memory back and takes one twice as large
//   a list that is done   gives its memory back
//
// So however the pairs of bodies are ordered from step to step, what one of them needed another
// gets, and once a scene has been as full as it gets nothing is allocated.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace impetus::inline collision {

/// Nodes of a and b that overlap; b is 0 when a touches a wall.
struct NodePair {
  std::int32_t a{0};
  std::int32_t b{0};

  friend bool operator==(const NodePair&, const NodePair&) = default;
};

/// Pairs of siblings of `first`: bit kLanes · row + column is its a's node `row` and its b's node
/// `column` after them.
struct NodeBlock {
  NodePair first;
  std::uint64_t bits{0};  ///< not 0
};

class NodeBlockStore {
 public:
  /// Room for `blocks`, a power of two.
  std::vector<NodeBlock> take(std::size_t blocks) {
    std::vector<std::vector<NodeBlock>>& as_large = by_size_[size_class(blocks)];
    if (as_large.empty()) {
      return std::vector<NodeBlock>(blocks);
    }
    std::vector<NodeBlock> memory = std::move(as_large.back());
    as_large.pop_back();
    return memory;
  }

  /// What take() gave, or nothing.
  void give_back(std::vector<NodeBlock>&& memory) {
    if (!memory.empty()) {
      const std::size_t size = size_class(memory.size());
      by_size_[size].push_back(std::move(memory));
    }
  }

 private:
  static std::size_t size_class(std::size_t blocks) {
    return static_cast<std::size_t>(std::countr_zero(blocks));
  }

  std::array<std::vector<std::vector<NodeBlock>>, 64> by_size_;  ///< by the power of two
};

}  // namespace impetus::inline collision
