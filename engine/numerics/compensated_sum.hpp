// Sums that lose nothing to the number of their terms.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace impetus::inline numerics {

/// A running sum of vectors or matrices, number by number, with what rounding took from it kept
/// beside: its error does not grow with the count of terms. (Neumaier 1974)
template <typename Array>
class CompensatedSum {
 public:
  void add(const Array& term) {
    const Array next = sum_ + term;
    for (Eigen::Index i = 0; i < term.size(); ++i) {
      const bool larger = std::fabs(sum_(i)) >= std::fabs(term(i));
      lost_(i) += larger ? (sum_(i) - next(i)) + term(i) : (term(i) - next(i)) + sum_(i);
    }
    sum_ = next;
  }

  [[nodiscard]] Array total() const { return sum_ + lost_; }

  /// As if nothing had been kept.
  [[nodiscard]] Array plain_total() const { return sum_; }

 private:
  Array sum_{Array::Zero()};
  Array lost_{Array::Zero()};
};

}  // namespace impetus::inline numerics
