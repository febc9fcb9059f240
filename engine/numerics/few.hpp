// A list of few things, in place: at most as many as its type says, and nothing is allocated.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cassert>
#include <cstddef>

namespace impetus::inline numerics {

/// A list of up to `kMost`.
template <typename T, std::size_t kMost>
class Few {
 public:
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] T& operator[](std::size_t index) { return all_[index]; }
  [[nodiscard]] const T& operator[](std::size_t index) const { return all_[index]; }
  [[nodiscard]] const T* begin() const { return all_.data(); }
  [[nodiscard]] const T* end() const { return all_.data() + count_; }

  /// Precondition: there is room.
  void add(const T& one) {
    assert(count_ < kMost);
    all_[count_++] = one;
  }

  /// Those after it move up. Precondition: index < size().
  void remove(std::size_t index) {
    for (--count_; index < count_; ++index) {
      all_[index] = all_[index + 1];
    }
  }

 private:
  std::array<T, kMost> all_;
  std::size_t count_{0};
};

}  // namespace impetus::inline numerics
