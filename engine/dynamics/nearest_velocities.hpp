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

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "engine/dynamics/row_columns.hpp"

namespace impetus::inline dynamics {

/// The Cholesky factor L of a Gram matrix that grows and shrinks by a row. Stored by columns, so
/// that both substitutions run along memory. Every sum is taken in the order of its index, whatever
/// the layout.
class GramFactor {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }

  [[nodiscard]] double at(std::size_t row, std::size_t column) const {
    return entries_[column * stride_ + row];
  }

  /// L⁻¹ right, in place; its first `known` entries are those of the result already.
  void forward(std::vector<double>& right, std::size_t known = 0) const {
    for (std::size_t j = 0; j < size_; ++j) {
      const double* column = &entries_[j * stride_];
      if (j >= known) {
        right[j] /= column[j];
      }
      const double found = right[j];
      for (std::size_t i = j < known ? known : j + 1; i < size_; ++i) {
        right[i] -= column[i] * found;
      }
    }
  }

  /// L⁻ᵀ right, in place.
  void backward(std::vector<double>& right) const {
    for (std::size_t i = size_; i-- > 0;) {
      const double* column = &entries_[i * stride_];
      double sum = right[i];
      for (std::size_t j = i + 1; j < size_; ++j) {
        sum -= column[j] * right[j];
      }
      right[i] = sum / column[i];
    }
  }

  /// `products` are those of the new row with the others, forward-substituted; `rest` is what of
  /// its squared length they leave.
  void append(const std::vector<double>& products, double rest) {
    if (size_ == stride_) {
      grow();
    }
    for (std::size_t j = 0; j < size_; ++j) {
      entries_[j * stride_ + size_] = products[j];
    }
    entries_[size_ * stride_ + size_] = std::sqrt(rest);
    ++size_;
  }

  /// Keeps the first `size` rows.
  void shrink(std::size_t size) { size_ = size; }

 private:
  void grow() {
    const std::size_t wider = stride_ == 0 ? 16 : 2 * stride_;
    std::vector<double> entries(wider * wider);
    for (std::size_t j = 0; j < size_; ++j) {
      for (std::size_t i = j; i < size_; ++i) {
        entries[j * wider + i] = at(i, j);
      }
    }
    entries_.swap(entries);
    stride_ = wider;
  }

  std::vector<double> entries_;
  std::size_t stride_{0};
  std::size_t size_{0};
};

/// Whether the constrained problem was solved, or its passes ran out before.
enum class Projection { kSolved, kGaveUp };

/// Rows of unit length, what their lengths were (none: 0) and their bounds before they were made
/// so.
struct UnitRows {
  const RowColumns& rows;
  const std::vector<double>& lengths;
  const std::vector<double>& bounds;
};

/// Solves one problem after the other in arrays that it keeps.
class NearestVelocitySolver {
 public:
  /// Moves `u`, by body, to the solution of those rows that `which` names, rising: u = u⁻ + Σ λ_i
  /// a_i. A row may be violated by `tolerance` (in the units of `bound`, after the row is made of
  /// unit length). Gives up after a number of steps in proportion to the rows, or where no u
  /// satisfies them; then `u` is as it was and all multipliers are zero.
  Projection solve(const UnitRows& given, const std::vector<std::size_t>& which,
                   std::vector<Vector6>& u, double tolerance);

  /// Of the last problem, by row, ≥ 0; one of no length or not in the problem has none.
  [[nodiscard]] const std::vector<double>& multipliers() const { return multipliers_; }

 private:
  bool solve_active_set(const UnitRows& given, const std::vector<std::size_t>& which,
                        std::vector<Vector6>& u);
  [[nodiscard]] std::size_t most_violated(const std::vector<Vector6>& u);
  bool satisfy(std::size_t row, std::vector<Vector6>& u);
  void multiply_by_active(const ConstraintRow& row);
  [[nodiscard]] std::pair<double, std::size_t> first_to_pull() const;
  void take(const ConstraintRow& row, double step, std::vector<Vector6>& u);
  void polish(std::vector<Vector6>& u);
  void let_go(std::size_t which);

  const RowColumns* rows_{nullptr};  ///< while it solves
  std::vector<double> bounds_;       ///< of unit rows
  std::vector<double> multipliers_;
  std::vector<std::size_t> active_;
  std::vector<ConstraintRow> active_rows_;
  std::vector<unsigned char> is_out_;  ///< active, violated by rounding alone, or no matter
  GramFactor factor_;                  ///< of the active rows
  std::vector<Vector6> given_;
  std::vector<double> products_with_u_;
  std::vector<double> products_;  ///< of the row in question with the active ones
  std::vector<double> forward_;   ///< the same, forward-substituted
  std::vector<double> share_;     ///< of each active row in it
  double tolerance_{0.0};
  double independent_{0.0};
  std::size_t steps_left_{0};
};

}  // namespace impetus::inline dynamics
