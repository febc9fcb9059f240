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

/// `placed` is null for walls, which have one node.
NodeRange one_level_deeper(const PlacedTree* placed, std::int32_t index) {
  if (placed == nullptr) {
    return {index, 1};
  }
  const NodeLinks& node = placed->tree().links(index);
  return node.child_count > 0 ? NodeRange{node.first_child, node.child_count} : NodeRange{index, 1};
}

bool has_children(const PlacedTree* placed, std::int32_t index) {
  return placed != nullptr && placed->tree().links(index).child_count > 0;
}

}  // namespace

PairRefinement::PairRefinement(PlacedTree& a, PlacedTree& b, int greatest_level,
                               StopReason at_greatest)
    : a_(&a), b_(&b), walls_(nullptr), greatest_level_(greatest_level), at_greatest_(at_greatest) {
  test_roots();
}

PairRefinement::PairRefinement(PlacedTree& a, const Enclosure& walls, int greatest_level)
    : a_(&a), b_(nullptr), walls_(&walls), greatest_level_(greatest_level) {
  test_roots();
}

void PairRefinement::test_roots() {
  if (touch_each_other({0, 0})) {
    committed_.push_back({0, 0});
  }
  skip_leaf_pairs();
}

bool PairRefinement::touch_each_other(const NodePair& pair) {
  return b_ != nullptr ? nodes_overlap(*a_, pair.a, *b_, pair.b)
                       : node_reaches_wall(*a_, pair.a, *walls_);
}

std::int64_t PairRefinement::block_size(const NodePair& pair) const {
  if (!has_children(a_, pair.a) && !has_children(b_, pair.b)) {
    return 0;
  }
  return static_cast<std::int64_t>(one_level_deeper(a_, pair.a).count) *
         one_level_deeper(b_, pair.b).count;
}

std::int64_t PairRefinement::next_block() const {
  return has_finer() && level_ < greatest_level_ ? block_size(committed_[next_]) : 0;
}

std::int64_t PairRefinement::most_found_after_next_block() const {
  // What the block finds, and the pairs of leaves behind it, which are carried over untested.
  std::size_t end = next_ + 1;
  while (end < committed_.size() && block_size(committed_[end]) == 0) {
    ++end;
  }
  return found_so_far() + next_block() + static_cast<std::int64_t>(end - next_ - 1);
}

std::int64_t PairRefinement::tests_of_next_level() const {
  std::int64_t tests = 0;
  for (std::size_t pair = next_; pair < committed_.size(); ++pair) {
    tests += block_size(committed_[pair]);
  }
  return tests;
}

double PairRefinement::fit_error_m(int level) const {
  return a_->tree().fit_error_m(level) + (b_ != nullptr ? b_->tree().fit_error_m(level) : 0.0);
}

void PairRefinement::refine_one_block() {
  assert(!resolved());
  expand(committed_[next_]);
  ++next_;
  skip_leaf_pairs();
  commit_if_complete();
}

void PairRefinement::expand(const NodePair& pair) {
  const NodeRange of_a = one_level_deeper(a_, pair.a);
  const NodeRange of_b = one_level_deeper(b_, pair.b);
  for (std::int32_t i = of_a.first; i < of_a.first + of_a.count; ++i) {
    for (std::int32_t j = of_b.first; j < of_b.first + of_b.count; ++j) {
      if (touch_each_other({i, j})) {
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
  if (!has_finer()) {
    return StopReason::kFinest;
  }
  return level_ < greatest_level_ ? StopReason::kBudgetSpent : at_greatest_;
}

}  // namespace impetus
