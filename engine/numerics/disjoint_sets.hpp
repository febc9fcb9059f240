// Sets of numbered things, joined two at a time.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace impetus::inline numerics {

/// Each thing is a set of its own at first. A set is named by its least member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t things) { separate(things); }

  /// As new, of so many things.
  void separate(std::size_t things) {
    above_.resize(things);
    std::iota(above_.begin(), above_.end(), std::size_t{0});
  }

  std::size_t name_of(std::size_t member) {
    while (above_[member] != member) {
      above_[member] = above_[above_[member]];
      member = above_[member];
    }
    return member;
  }

  void join(std::size_t a, std::size_t b) {
    a = name_of(a);
    b = name_of(b);
    above_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> above_;
};

}  // namespace impetus::inline numerics
