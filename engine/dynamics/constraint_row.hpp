// A constraint on the mass-scaled velocities of one body or two, and many of them side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
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

/// a · u, by body.
double dot(const ConstraintRow& row, const std::vector<Vector6>& u);
double dot(const ConstraintRow& x, const ConstraintRow& y);

/// u += times a
void add(std::vector<Vector6>& u, const ConstraintRow& row, double times);

/// Rows four at a time, coordinate by coordinate: a · u − `bound` of all of them at once, with the
/// bits that dot() gives for each. Rows of unlike bodies do not share a block.
class RowColumns {
 public:
  void clear();
  void push_back(const ConstraintRow& row);

  /// Of every row, in their order.
  void find_slacks(const std::vector<Vector6>& u, std::vector<double>& slacks) const;

 private:
  static constexpr std::size_t kLanes = 4;

  struct Block {
    std::int32_t a;
    std::int32_t b;
    std::size_t first_row;
    std::size_t count;
    double of_a[6][kLanes];
    double of_b[6][kLanes];
    double bounds[kLanes];
  };

  std::vector<Block> blocks_;
  std::size_t rows_{0};
};

}  // namespace impetus
