// Sets of bodies, joined two at a time.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace impetus::inline dynamics {

/// Each body is a set of its own at first. A set is named by its least body.
class BodySets {
 public:
  explicit BodySets(std::size_t bodies) { separate(bodies); }

  /// As new, of so many bodies.
  void separate(std::size_t bodies) {
    above_.resize(bodies);
    std::iota(above_.begin(), above_.end(), std::size_t{0});
  }

  std::size_t name_of(std::size_t body) {
    while (above_[body] != body) {
      above_[body] = above_[above_[body]];
      body = above_[body];
    }
    return body;
  }

  void join(std::size_t a, std::size_t b) {
    a = name_of(a);
    b = name_of(b);
    above_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> above_;
};

}  // namespace impetus::inline dynamics
