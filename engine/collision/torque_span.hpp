// Of many contacts, the few that can do what all of them can.
//
//   wrench of a contact   (n, (p − p_mean) × n / size)
//   kept                  the deepest; then, again and again, the one whose wrench lies furthest
//                         from the cone Σ λ_i w_i, λ_i ≥ 0, of those kept
//
// Impulses only push, so what contacts can do together is the cone of their wrenches, not their
// linear span: a box on three corners of its face tips over the fourth, although its wrench lies
// in the span of the others. A contact within the cone can neither do more nor approach while
// those that are kept do not, so it is left out. (Farkas 1902)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "engine/numerics/vector.hpp"
#include "engine/volumes/sphere.hpp"

namespace impetus::inline collision {

/// A push and its torque over the body's size, which makes them comparable.
using Wrench = Eigen::Matrix<double, 6, 1>;

/// The distance of `wrench` from the nearest Σ λ_i w_i with all λ_i ≥ 0, the w_i the `generators`
/// of the cone, of any length but zero: exact to rounding. (Lawson and Hanson 1974, ch. 23:
/// non-negative least squares)
double distance_from_cone(const std::vector<Wrench>& generators, const Wrench& wrench);

/// Finds them in memory that it keeps.
class TorqueSpan {
 public:
  /// Leaves at most `most` (1 or more) of `contacts`, in their order; all of them when they are no
  /// more. Torques are measured against pushes by `size_m`, the bodies' size. Ties go to the first.
  void keep_widest(std::vector<TouchPoint>& contacts, int most, double size_m);

 private:
  void find_wrenches(const std::vector<TouchPoint>& contacts, double size_m);
  [[nodiscard]] std::size_t furthest() const;

  std::vector<Wrench> wrenches_;
  std::vector<std::size_t> kept_;
  std::vector<Wrench> cone_;  ///< of those kept
};

}  // namespace impetus::inline collision
