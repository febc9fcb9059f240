// Interruptible refinement of one pair of volume trees, or of a tree and the walls round it: stop
// whenever you like, keep a valid answer.
//
//   frontier of this level --block--> overlap tests --> frontier of the next level
//                                                       (committed when complete)
//
// What makes interruption safe: the answer is always the last complete level. Node pairs of two
// leaves are carried from level to level untested; a leaf against an inner node descends the
// other one; the walls are one node that never descends. (Dingliana 2002, sec. 3.1.2 and app. B.2,
// corrected) SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/collision/placed_tree.hpp"
#include "engine/scheduling/priority_lists.hpp"
#include "engine/volumes/enclosure.hpp"

namespace impetus {

/// Why a refinement is where it is: apart, nothing finer exists, no work was left, its priority
/// list goes no deeper, or the bodies are too fast for finer nodes.
enum class StopReason { kSeparated, kFinest, kBudgetSpent, kGreatestLevel, kCapped };

/// Nodes of a and b that overlap; b is 0 when a touches a wall.
struct NodePair {
  std::int32_t a{0};
  std::int32_t b{0};

  friend bool operator==(const NodePair&, const NodePair&) = default;
};

class PairRefinement {
 public:
  /// Tests the two roots: level 0, one node-pair test. Both trees must outlive this.
  /// Refines no deeper than `greatest_level`; `at_greatest` says what that level was for.
  PairRefinement(PlacedTree& a, PlacedTree& b, int greatest_level = kUnlimitedLevel,
                 StopReason at_greatest = StopReason::kGreatestLevel);

  /// Nodes of `a` against the walls: one test a node. Both must outlive this.
  PairRefinement(PlacedTree& a, const Enclosure& walls, int greatest_level = kUnlimitedLevel);
  PairRefinement(PlacedTree& a, Enclosure&& walls, int greatest_level = kUnlimitedLevel) = delete;

  /// True when no work could change the answer: separated, nothing finer exists, or the greatest
  /// level is reached.
  [[nodiscard]] bool resolved() const { return next_block() == 0; }

  /// Tests the next block needs: the children of one node pair. Zero when resolved.
  [[nodiscard]] std::int64_t next_block() const;

  /// Tests one block; commits the next level when it was the last of this one.
  /// Precondition: !resolved().
  void refine_one_block();

  /// The node pairs that overlap at the last complete level; empty when separated.
  [[nodiscard]] const std::vector<NodePair>& overlapping() const { return committed_; }
  [[nodiscard]] int level() const { return level_; }
  [[nodiscard]] StopReason stop_reason() const;

  /// Whether its tests are of two spheres.
  [[nodiscard]] bool of_spheres() const {
    return b_ != nullptr && a_->of_spheres() && b_->of_spheres();
  }

  /// Node pairs found for the next level so far.
  [[nodiscard]] std::int64_t found_so_far() const {
    return static_cast<std::int64_t>(expanding_.size());
  }

  /// As many as there can be once the next block is done.
  [[nodiscard]] std::int64_t most_found_after_next_block() const;

  /// Tests until the next level is complete.
  [[nodiscard]] std::int64_t tests_of_next_level() const;

  /// How far the gap between the surfaces of two bodies whose nodes overlap at `level` can be
  /// (metres): both trees' fit errors.
  [[nodiscard]] double fit_error_m(int level) const;

  /// Of the overlapping nodes, the largest probability that their surfaces meet: κ ρ_a ρ_b, with κ
  /// that of the spheres about them. A wall is solid. (Dingliana 2002, eq. 4.6, corrected)
  [[nodiscard]] double likeliest_collision() const;

 private:
  void test_roots();
  [[nodiscard]] bool has_finer() const { return next_ < committed_.size(); }
  [[nodiscard]] bool touch_each_other(const NodePair& pair);
  [[nodiscard]] std::int64_t block_size(const NodePair& pair) const;
  void expand(const NodePair& pair);
  void skip_leaf_pairs();
  void commit_if_complete();

  PlacedTree* a_;
  PlacedTree* b_;           ///< null for walls
  const Enclosure* walls_;  ///< null for a tree
  int greatest_level_;
  StopReason at_greatest_{StopReason::kGreatestLevel};
  int level_{0};
  std::vector<NodePair> committed_;
  std::vector<NodePair> expanding_;
  std::size_t next_{0};
};

}  // namespace impetus
