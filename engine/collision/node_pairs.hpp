// Pairs of nodes that overlap, in the order in which a descent finds them, kept as they are tested:
// by blocks of siblings, a bit for each pair.
//
//   block   first node of a | first node of b | 64 bits: row a + i, column b + j is bit 8 i + j
//
// A block of tests is one entry, however many of them overlap. A list keeps its memory when it is
// emptied, so a descent that is begun anew allocates nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "engine/numerics/bits.hpp"
#include "engine/volumes/sphere_lanes.hpp"

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

/// Memory for lists of blocks that many descents share, by size: a list that is full gives its
/// memory back and takes one twice as large, one that is done gives it back. So however the pairs
/// of bodies are ordered from step to step, what one of them needed another gets, and once a scene
/// has been as full as it gets nothing is allocated.
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

/// A list of overlapping node pairs.
class NodePairs {
 public:
  /// Which of them, in a list of any address.
  struct Place {
    std::size_t block{0};
    std::uint64_t bits_left{0};  ///< the pair's own is the lowest

    friend bool operator==(const Place& x, const Place& y) {
      return x.block == y.block && x.bits_left == y.bits_left;
    }
  };

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }

  [[nodiscard]] Place first() const { return {0, count_ > 0 ? blocks_[0].bits : 0}; }
  [[nodiscard]] Place past_the_end() const { return {count_, 0}; }
  [[nodiscard]] bool is_end(const Place& place) const { return place.block == count_; }
  [[nodiscard]] Place after(const Place& place) const {
    const std::uint64_t left = place.bits_left & (place.bits_left - 1);
    return left != 0 ? Place{place.block, left} : Place{place.block + 1, bits_of(place.block + 1)};
  }
  [[nodiscard]] NodePair at(const Place& place) const {
    const int bit = std::countr_zero(place.bits_left);
    const NodeBlock& block = blocks_[place.block];
    return {block.first.a + bit / kLanes, block.first.b + bit % kLanes};
  }

  /// Goes through the pairs in their order.
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = NodePair;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = NodePair;

    Iterator(const NodePairs& pairs, const Place& place) : pairs_(&pairs), place_(place) {}
    NodePair operator*() const { return pairs_->at(place_); }
    Iterator& operator++() {
      place_ = pairs_->after(place_);
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    friend bool operator==(const Iterator& x, const Iterator& y) { return x.place_ == y.place_; }

   private:
    const NodePairs* pairs_;
    Place place_;
  };
  using value_type = NodePair;
  using const_iterator = Iterator;

  [[nodiscard]] Iterator begin() const { return {*this, first()}; }
  [[nodiscard]] Iterator end() const { return {*this, past_the_end()}; }

  /// Their blocks, in the same order.
  [[nodiscard]] std::span<const NodeBlock> blocks() const { return {blocks_.data(), count_}; }

  void clear() {
    count_ = 0;
    size_ = 0;
  }

  /// Memory is taken from `store` from now on, which must outlive this.
  void take_from(NodeBlockStore& store) { store_ = &store; }

  /// Forgets the pairs and gives the memory back.
  void give_back() {
    clear();
    if (store_ != nullptr) {
      store_->give_back(std::exchange(blocks_, {}));
    }
  }

  void add(const NodePair& pair) { add_block(pair, 1); }

  /// The pairs of a block whose first nodes are those of `first`, as overlaps_of_block() says.
  void add_block(const NodePair& first, std::uint64_t bits) {
    if (bits == 0) {
      return;
    }
    if (count_ == blocks_.size()) {
      grow();
    }
    blocks_[count_++] = {first, bits};
    size_ += static_cast<std::size_t>(bits_in(bits));
  }

  void swap(NodePairs& other) {
    blocks_.swap(other.blocks_);
    std::swap(count_, other.count_);
    std::swap(size_, other.size_);
    std::swap(store_, other.store_);
  }

  friend bool operator==(const NodePairs& x, const NodePairs& y) {
    return x.size() == y.size() && std::equal(x.begin(), x.end(), y.begin());
  }

 private:
  void grow() {
    const std::size_t blocks = std::max<std::size_t>(2 * count_, 8);
    if (store_ == nullptr) {
      blocks_.resize(blocks);
      return;
    }
    std::vector<NodeBlock> larger = store_->take(blocks);
    std::copy(blocks_.begin(), blocks_.end(), larger.begin());
    blocks_.swap(larger);
    store_->give_back(std::move(larger));
  }

  [[nodiscard]] std::uint64_t bits_of(std::size_t block) const {
    return block < count_ ? blocks_[block].bits : 0;
  }

  std::vector<NodeBlock> blocks_;  ///< those from count_ on mean nothing
  std::size_t count_{0};           ///< blocks
  std::size_t size_{0};            ///< pairs
  NodeBlockStore* store_{nullptr};
};

}  // namespace impetus::inline collision
