// SPDX-License-Identifier: MIT
#include "engine/collision/pair_refinement.hpp"

#include <algorithm>
#include <cassert>

namespace impetus {
namespace {

/// The nodes that stand for `index` one level deeper: its children, or itself when it has none.
struct NodeRange {
  std::int32_t first;
  std::int32_t count;
};

NodeRange one_level_deeper(const VolumeTree& tree, std::int32_t index) {
  const VolumeNode& node = tree.node(index);
  return node.child_count > 0 ? NodeRange{node.first_child, node.child_count} : NodeRange{index, 1};
}

bool has_children(const VolumeTree& tree, std::int32_t index) {
  return tree.node(index).child_count > 0;
}

}  // namespace

PairRefinement::PairRefinement(PlacedTree& a, PlacedTree& b) : a_(&a), b_(&b) {
  if (overlap(a.world_volume(0), b.world_volume(0))) {
    committed_.push_back({0, 0});
  }
  skip_leaf_pairs();
}

std::int64_t PairRefinement::block_size(const NodePair& pair) const {
  if (!has_children(a_->tree(), pair.a) && !has_children(b_->tree(), pair.b)) {
    return 0;
  }
  return static_cast<std::int64_t>(one_level_deeper(a_->tree(), pair.a).count) *
         one_level_deeper(b_->tree(), pair.b).count;
}

std::int64_t PairRefinement::next_block() const {
  return next_ < committed_.size() ? block_size(committed_[next_]) : 0;
}

void PairRefinement::refine_one_block() {
  assert(!resolved());
  expand(committed_[next_]);
  ++next_;
  skip_leaf_pairs();
  commit_if_complete();
}

void PairRefinement::expand(const NodePair& pair) {
  const NodeRange of_a = one_level_deeper(a_->tree(), pair.a);
  const NodeRange of_b = one_level_deeper(b_->tree(), pair.b);
  for (std::int32_t i = of_a.first; i < of_a.first + of_a.count; ++i) {
    for (std::int32_t j = of_b.first; j < of_b.first + of_b.count; ++j) {
      if (overlap(a_->world_volume(i), b_->world_volume(j))) {
        expanding_.push_back({i, j});
      }
    }
  }
}

void PairRefinement::skip_leaf_pairs() {
  // Leaf pairs cost nothing and stay as they are; a level of leaf pairs alone is the finest.
  const bool finer_exists =
      next_ > 0 || std::any_of(committed_.begin(), committed_.end(),
                               [this](const NodePair& pair) { return block_size(pair) > 0; });
  if (!finer_exists) {
    next_ = committed_.size();
    return;
  }
  while (next_ < committed_.size() && block_size(committed_[next_]) == 0) {
    expanding_.push_back(committed_[next_]);
    ++next_;
  }
}

void PairRefinement::commit_if_complete() {
  if (next_ < committed_.size()) {
    return;
  }
  committed_.swap(expanding_);
  expanding_.clear();
  next_ = 0;
  ++level_;
  skip_leaf_pairs();
}

StopReason PairRefinement::stop_reason() const {
  if (committed_.empty()) {
    return StopReason::kSeparated;
  }
  return resolved() ? StopReason::kFinest : StopReason::kBudgetSpent;
}

}  // namespace impetus
