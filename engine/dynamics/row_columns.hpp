// A constraint on the mass-scaled velocities of one body or two.
//
// Constraints of the same two bodies side by side, four at a time, coordinate by coordinate: what
// is asked of all of them is found for four at once.
//
// Every number is the result of the operations that dot() and its like do for one row, in their
// order: sums of six products are two sums of three, each from its end, as Eigen adds them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/numerics/vector.hpp"

namespace impetus::inline dynamics {

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

/// a · u, by body.
inline double dot(const ConstraintRow& row, const std::vector<Vector6>& u) {
  double sum = 0.0;
  for (const RowPart* part : {&row.a, &row.b}) {
    if (part->body >= 0) {
      sum += part->direction.dot(u[static_cast<std::size_t>(part->body)]);
    }
  }
  return sum;
}

inline double dot(const ConstraintRow& x, const ConstraintRow& y) {
  double sum = 0.0;
  for (const RowPart* of_x : {&x.a, &x.b}) {
    for (const RowPart* of_y : {&y.a, &y.b}) {
      if (of_x->body >= 0 && of_x->body == of_y->body) {
        sum += of_x->direction.dot(of_y->direction);
      }
    }
  }
  return sum;
}

/// u += times a
inline void add(std::vector<Vector6>& u, const ConstraintRow& row, double times) {
  for (const RowPart* part : {&row.a, &row.b}) {
    if (part->body >= 0) {
      u[static_cast<std::size_t>(part->body)] += times * part->direction;
    }
  }
}

inline constexpr std::size_t kRowLanes = 4;
using LanesOf3 = double[3][kRowLanes];
using LanesOf6 = double[6][kRowLanes];

/// One to four rows; bodies as in RowPart. Where there is no body, its lanes mean nothing; the
/// lanes beyond `count` hold any numbers.
struct RowBlock {
  std::int32_t a{-1};
  std::int32_t b{-1};
  std::size_t first_row{0};
  std::size_t count{0};
  LanesOf6 of_a;
  LanesOf6 of_b;
};

/// Rows in blocks, in their order.
class RowColumns {
 public:
  void clear();

  /// A block of `count` rows at the end, to be filled.
  RowBlock& add_block(std::int32_t a, std::int32_t b, std::size_t count);

  [[nodiscard]] std::size_t size() const { return place_of_row_.size(); }

  /// Without a bound.
  [[nodiscard]] ConstraintRow row(std::size_t index) const;

  /// Of every row a · u, in their order.
  void find_products(const std::vector<Vector6>& u, std::vector<double>& products) const;

  /// The lengths of the rows of `of`; these become the same rows of unit length, but for those that
  /// have no length.
  void make_unit(const RowColumns& of, std::vector<double>& lengths);

 private:
  std::vector<RowBlock> blocks_;
  std::vector<std::size_t> place_of_row_;  ///< block · kRowLanes + lane
};

}  // namespace impetus::inline dynamics
