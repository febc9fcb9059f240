// The Cholesky factor L of a Gram matrix that grows and shrinks by a row.
//
// Stored by columns, so that both substitutions run along memory. Every sum is taken in the order
// of its index, whatever the layout.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace impetus::inline dynamics {

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

}  // namespace impetus::inline dynamics
