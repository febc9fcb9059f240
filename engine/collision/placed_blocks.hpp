// Where a tree's blocks of sibling spheres are in the world, in memory that many trees share.
//
//   tree, block  ->  x0 … x7 | y0 … y7 | z0 … z7
//
// A body visits few of its tree's nodes in a step, and others in the next. So a world lends its
// trees as much memory as one step needs: what is placed in a step lies side by side, however large
// the trees are.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/numerics/lanes.hpp"

namespace impetus::inline collision {

/// The centres of a block's spheres. kLanes numbers can be read from any of them: those beyond the
/// last of a coordinate mean nothing.
struct alignas(64) PlacedBlock {
  double x[kLanes];
  double y[kLanes];
  double z[kLanes];
};

/// Memory for blocks, given away one after the other. A block stays where it is until all are free.
class BlockStore {
 public:
  /// All blocks are free again.
  void clear() { taken_ = 0; }

  /// A free block; more memory, where there is none.
  PlacedBlock& take() {
    if (taken_ == chunks_.size() * kChunk) {
      grow();
    }
    const std::size_t place = taken_++;
    return chunks_[place / kChunk][place % kChunk];
  }

 private:
  static constexpr std::size_t kChunk = 8;

  /// By half of what there is, so that a scene that is fuller than ever before rarely asks again.
  /// Behind the last block of a chunk there is one to be read.
  void grow() {
    const std::size_t more = std::max<std::size_t>(1, chunks_.size() / 2);
    for (std::size_t i = 0; i < more; ++i) {
      chunks_.push_back(std::make_unique<PlacedBlock[]>(kChunk + 1));
    }
  }

  std::vector<std::unique_ptr<PlacedBlock[]>> chunks_;
  std::size_t taken_{0};
};

/// The blocks of one tree: where they are, if they are placed as the tree lies now. In memory that
/// was lent, or else its own. Of a copy nothing is placed, and nothing is lent to it; its poses are
/// counted on, so that no volume that was placed in one of the other's counts as placed in its own.
class PlacedBlocks {
 public:
  explicit PlacedBlocks(std::uint32_t count) : blocks_(count) {}
  PlacedBlocks(const PlacedBlocks& other) : pose_(other.pose_ + 1), blocks_(other.blocks_.size()) {}
  PlacedBlocks(PlacedBlocks&&) noexcept = default;
  PlacedBlocks& operator=(const PlacedBlocks& other) { return *this = PlacedBlocks(other); }
  PlacedBlocks& operator=(PlacedBlocks&&) noexcept = default;
  ~PlacedBlocks() = default;

  /// Nothing is placed now. `store` must stay as long as blocks are asked for; when it is cleared,
  /// it is to be borrowed anew.
  void borrow(BlockStore& store) {
    lent_ = &store;
    before_lent_ = pose_++;
  }

  /// Room for so many blocks, with what there is.
  void expect(std::uint32_t count) { blocks_.resize(std::max<std::size_t>(blocks_.size(), count)); }

  /// The tree moved: nothing is placed.
  void move() { ++pose_; }

  /// Counts the poses.
  [[nodiscard]] std::uint64_t pose() const { return pose_; }

  /// Null unless it is placed.
  [[nodiscard]] const PlacedBlock* find(std::uint32_t block) const {
    const Placed& known = blocks_[block];
    return known.in_pose == pose_ ? known.block : nullptr;
  }

  /// The block counts as placed: to be filled.
  PlacedBlock& place(std::uint32_t block) {
    Placed& known = blocks_[block];
    if (known.in_pose <= before_lent_) {
      known.block = &store().take();
    }
    known.in_pose = pose_;
    return *known.block;
  }

 private:
  /// A block, and the last pose that it was placed in; 0: none.
  struct Placed {
    PlacedBlock* block{nullptr};
    std::uint64_t in_pose{0};
  };

  BlockStore& store() {
    if (lent_ == nullptr && own_ == nullptr) {
      own_ = std::make_unique<BlockStore>();
    }
    return lent_ != nullptr ? *lent_ : *own_;
  }

  std::uint64_t pose_{1};
  std::vector<Placed> blocks_;
  std::uint64_t before_lent_{0};  ///< blocks of poses up to this one are no longer the tree's
  BlockStore* lent_{nullptr};
  std::unique_ptr<BlockStore> own_;
};

}  // namespace impetus::inline collision
