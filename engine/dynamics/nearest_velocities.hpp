// The velocities nearest to those given, by kinetic energy, with which no contact closes faster
// than it may.
//
//   minimise ½ |u − u⁻|²  where  a_i · u ≥ b_i      u = M^½ v, so |u|² is twice the energy
//
// A dual active-set method (Goldfarb and Idnani 1983) for an identity Hessian: the constraint most
// violated is made active, one that then pulls is let go; the active rows stay independent, their
// Gram matrix is kept factored. Ties go to the least index, so the result does not depend on
// anything but the rows. The solution is unique; the multipliers, impulses, need not be.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/numerics/vector.hpp"

namespace impetus {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Six mass-scaled coordinates of one body.
struct RowPart {
  std::int32_t body{-1};  ///< none: −1
  Vector6 direction{Vector6::Zero()};
};

/// One constraint a · u ≥ `bound`, on one body or two.
struct ConstraintRow {
  RowPart a;
  RowPart b;
  double bound{0.0};
};

enum class Projection { kSolved, kGaveUp };

struct NearestVelocities {
  Projection outcome{Projection::kSolved};
  std::vector<double> multipliers;  ///< by row, ≥ 0; a row of no length has none
};

/// Moves `u`, by body, to the solution and returns the multipliers: u = u⁻ + Σ λ_i a_i. A row may
/// be violated by `tolerance` (in the units of `bound`, after the row is made of unit length).
/// Gives up after a number of steps in proportion to the rows, or where no u satisfies them; then
/// `u` is as it was and all multipliers are zero.
NearestVelocities project(const std::vector<ConstraintRow>& rows, std::vector<Vector6>& u,
                          double tolerance);

}  // namespace impetus
