// The pairs of nodes of two bodies on their ways, and how many of them were tested.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "engine/collision/entry/node_gap.hpp"
#include "engine/collision/entry/time_of_entry.hpp"
#include "engine/collision/sphere_block.hpp"

namespace impetus::inline collision {

/// Two bodies where they are now: goes through pairs of their nodes, and counts the tests, until
/// there may be no more.
class CountedPairs {
 public:
  explicit CountedPairs(const PairOnTheWay& pair)
      : pair_(pair), of_spheres_(pair.a.of_spheres() && pair.b.of_spheres()) {}

  [[nodiscard]] const PairOnTheWay& pair() const { return pair_; }
  [[nodiscard]] bool of_spheres() const { return of_spheres_; }

  [[nodiscard]] std::int64_t tests() const { return tests_; }
  [[nodiscard]] bool refused() const { return refused_; }  ///< by the meter
  [[nodiscard]] bool capped() const { return tests_ >= pair_.most_tests; }

  /// Tests that are made, or skipped because their outcome is known.
  void count(std::int64_t tests) {
    const std::int64_t counted = std::min(tests, pair_.most_tests - tests_);
    if (pair_.work != nullptr && !pair_.work->spend(counted)) {
      pair_.most_tests = tests_;
      refused_ = true;
      return;
    }
    tests_ += counted;
  }

  [[nodiscard]] bool is_last(const NodePair& nodes, int level) const {
    return level >= pair_.greatest_level || (pair_.a.tree().links(nodes.a).child_count == 0 &&
                                             pair_.b.tree().links(nodes.b).child_count == 0);
  }

  template <typename Visit>
  void for_each_pair_below(const NodePair& nodes, const Visit& visit) const {
    const NodeLinks of_a = one_level_deeper(pair_.a.tree(), nodes.a);
    const NodeLinks of_b = one_level_deeper(pair_.b.tree(), nodes.b);
    for (std::int32_t i = 0; i < of_a.child_count; ++i) {
      for (std::int32_t j = 0; j < of_b.child_count; ++j) {
        visit(NodePair{of_a.first_child + i, of_b.first_child + j});
      }
    }
  }

  /// Visits the pairs of a block whose bits are set, in order, and counts the tests of all up to
  /// where the search ends or has `found_enough`.
  template <typename FoundEnough, typename Visit>
  void for_each_set(const SphereBlock& block, std::uint64_t bits, const FoundEnough& found_enough,
                    const Visit& visit) {
    int counted = 0;
    for (; bits != 0 && !found_enough(); bits &= bits - 1) {
      const int bit = std::countr_zero(bits);
      const int row = bit / kLanes;
      const int column = bit % kLanes;
      const int place = row * block.columns + column;
      count(place - counted);
      if (capped()) {
        return;
      }
      count(1);
      counted = place + 1;
      visit(row, column);
    }
    if (!found_enough()) {
      count(block.rows * block.columns - counted);
    }
  }

  void place_roots() {
    pair_.a.world_lanes(0, 1);
    pair_.b.world_lanes(0, 1);
  }

  [[nodiscard]] NodeGap gap_of(const NodePair& nodes) const {
    return of_spheres_ ? gap_of_bounds(pair_.a.world_sphere(nodes.a), pair_.b.world_sphere(nodes.b))
                       : gap_of_nodes(pair_.a.world_volume(nodes.a), pair_.b.world_volume(nodes.b));
  }

 private:
  PairOnTheWay pair_;
  bool of_spheres_;
  std::int64_t tests_{0};
  bool refused_{false};
};

}  // namespace impetus::inline collision
