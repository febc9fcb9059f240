// The Cholesky factor of a small symmetric positive definite matrix, in an order of sums of its
// own: the same bits with whatever version of the matrix library.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "engine/numerics/vector.hpp"

namespace impetus::inline figures {

template <int N>
class SmallCholesky {
 public:
  using Matrix = Eigen::Matrix<double, N, N>;
  using Vector = Eigen::Matrix<double, N, 1>;

  /// Precondition: `matrix` is symmetric and positive definite; its lower half is read.
  void factor(const Matrix& matrix) {
    for (int row = 0; row < N; ++row) {
      for (int column = 0; column <= row; ++column) {
        double rest = matrix(row, column);
        for (int k = 0; k < column; ++k) {
          rest -= lower_(row, k) * lower_(column, k);
        }
        if (column < row) {
          lower_(row, column) = rest * inverse_diagonal_(column);
        } else {
          lower_(row, row) = std::sqrt(rest);
          inverse_diagonal_(row) = 1.0 / lower_(row, row);
        }
      }
    }
  }

  /// x of `matrix` x = b.
  [[nodiscard]] Vector solve(Vector b) const {
    for (int row = 0; row < N; ++row) {
      for (int k = 0; k < row; ++k) {
        b(row) -= lower_(row, k) * b(k);
      }
      b(row) *= inverse_diagonal_(row);
    }
    for (int row = N; row-- > 0;) {
      for (int k = row + 1; k < N; ++k) {
        b(row) -= lower_(k, row) * b(k);
      }
      b(row) *= inverse_diagonal_(row);
    }
    return b;
  }

 private:
  Matrix lower_{Matrix::Zero()};
  Vector inverse_diagonal_{Vector::Zero()};
};

}  // namespace impetus::inline figures
