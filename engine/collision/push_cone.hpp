// The cone of the wrenches that some contacts can exert by pushing alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "engine/numerics/vector.hpp"

namespace impetus::inline collision {

/// A push and its torque over the body's size, which makes them comparable.
using Wrench = Eigen::Matrix<double, 6, 1>;

class PushCone {
 public:
  void clear() { generators_.clear(); }

  /// Adds a generator, of any length but zero.
  void add(const Wrench& wrench) { generators_.push_back(wrench); }

  /// The distance of `wrench` from the nearest Σ λ_i w_i with all λ_i ≥ 0: exact to rounding.
  /// (Lawson and Hanson 1974, ch. 23: non-negative least squares)
  [[nodiscard]] double distance(const Wrench& wrench) const;

 private:
  std::vector<Wrench> generators_;
};

}  // namespace impetus::inline collision
