// A constraint on the mass-scaled velocities of one body or two.
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

}  // namespace impetus::inline dynamics
