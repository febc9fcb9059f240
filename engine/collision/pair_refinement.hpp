// Interruptible refinement of one pair of volume trees, or of a tree and the walls round it: stop
// whenever you like, keep a valid answer.
//
//   frontier of this level --block--> overlap tests --> frontier of the next level
//                                                       (committed when complete)
//
// What makes interruption safe: the answer is always the last complete level. Node pairs of two
// leaves are carried from level to level untested; a leaf against an inner node descends the
// other one; the walls are one node that never descends. (Dingliana 2002, sec. 3.1.2 and app. B.2,
// corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/collision/node_pairs.hpp"
#include "engine/collision/placed_tree.hpp"
#include "engine/scheduling/priority_lists.hpp"
#include "engine/volumes/enclosure.hpp"

namespace impetus::inline collision {

/// Why a refinement is where it is: apart, nothing finer exists, no work was left, its priority
/// list goes no deeper, or the bodies are too fast for finer nodes.
enum class StopReason { kSeparated, kFinest, kBudgetSpent, kGreatestLevel, kCapped };

/// The descent of one pair of bodies, or of a body and the walls.
class PairRefinement {
 public:
  /// Of nothing, until it begins.
  PairRefinement() = default;

  /// Begins at once.
  PairRefinement(PlacedTree& a, PlacedTree& b, int greatest_level = kUnlimitedLevel,
                 StopReason at_greatest = StopReason::kGreatestLevel) {
    begin(a, b, greatest_level, at_greatest);
  }
  PairRefinement(PlacedTree& a, const Enclosure& walls, int greatest_level = kUnlimitedLevel) {
    begin(a, walls, greatest_level);
  }
  PairRefinement(PlacedTree& a, Enclosure&& walls, int greatest_level = kUnlimitedLevel) = delete;

  /// Tests the two roots: level 0, one node-pair test. Both trees must outlive this.
  /// Refines no deeper than `greatest_level`; `at_greatest` says what that level was for.
  /// Forgets what it refined before, and keeps the memory.
  void begin(PlacedTree& a, PlacedTree& b, int greatest_level = kUnlimitedLevel,
             StopReason at_greatest = StopReason::kGreatestLevel);

  /// Nodes of `a` against the walls: one test a node. Both must outlive this.
  void begin(PlacedTree& a, const Enclosure& walls, int greatest_level = kUnlimitedLevel);
  void begin(PlacedTree& a, Enclosure&& walls, int greatest_level = kUnlimitedLevel) = delete;

  /// Memory is taken from `store` from now on, which must outlive this.
  void take_memory_from(NodeBlockStore& store) {
    committed_.take_from(store);
    expanding_.take_from(store);
  }

  /// Forgets what overlaps and gives the memory back: until it begins anew it is of nothing, and
  /// resolved.
  void give_memory_back() {
    level_ = 0;
    next_block_ = 0;
    committed_.give_back();
    expanding_.give_back();
  }

  /// True when no work could change the answer: separated, nothing finer exists, or the greatest
  /// level is reached.
  [[nodiscard]] bool resolved() const { return next_block_ == 0; }

  /// Tests the next block needs: the children of one node pair. Zero when resolved.
  [[nodiscard]] std::int64_t next_block() const { return next_block_; }

  /// Tests one block; commits the next level when it was the last of this one.
  /// Precondition: !resolved().
  void refine_one_block();

  /// The node pairs that overlap at the last complete level; empty when separated.
  [[nodiscard]] const NodePairs& overlapping() const { return committed_; }
  [[nodiscard]] int level() const { return level_; }
  [[nodiscard]] StopReason stop_reason() const;

  /// Whether its tests are of two spheres.
  [[nodiscard]] bool of_spheres() const { return of_spheres_; }

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

  /// Of the overlapping nodes, how deep the deepest reach into each other (metres), or beyond a
  /// wall: the least along the line of their centres and along their own axes, so never less than
  /// they do. Precondition: some overlap.
  [[nodiscard]] double deepest_overlap_m() const;

  /// The finest level that it may come to: of either tree, or its greatest.
  [[nodiscard]] int finest_level() const {
    return greatest_level_ < deepest_level_ ? greatest_level_ : deepest_level_;
  }

 private:
  void test_roots(bool touch);
  [[nodiscard]] bool has_finer() const { return !committed_.is_end(next_); }
  [[nodiscard]] std::int64_t block_size(const NodePair& pair) const;
  void expand(const NodePair& pair);
  void pass_leaf_pairs();
  void look_for_next_block();
  void commit();

  PlacedTree* a_{nullptr};
  PlacedTree* b_{nullptr};           ///< null for walls
  const Enclosure* walls_{nullptr};  ///< null for a tree
  int greatest_level_{0};
  StopReason at_greatest_{StopReason::kGreatestLevel};
  bool of_spheres_{false};
  int deepest_level_{0};  ///< of either tree
  int level_{0};
  NodePairs committed_;
  NodePairs expanding_;
  NodePairs::Place next_;
  std::int64_t next_block_{0};
};

}  // namespace impetus::inline collision
