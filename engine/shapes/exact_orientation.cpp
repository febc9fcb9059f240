// SPDX-License-Identifier: MIT
#include "engine/shapes/exact_orientation.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace impetus::inline shapes {
namespace {

/// Above Shewchuk's (7 + 56 ε) ε with ε = 2^-53.
constexpr double kRelativeError = 1e-15;

int sign_of(double value) { return (value > 0.0 ? 1 : 0) - (value < 0.0 ? 1 : 0); }

/// A sum held as parts that do not overlap, smallest first, so that the last has the sum's sign.
class ExactSum {
 public:
  /// Adds sign · x · y · z.
  void add(double sign, double x, double y, double z) {
    const double product = x * y;
    add_product(sign * z, std::fma(x, y, -product));
    add_product(sign * z, product);
  }

  [[nodiscard]] int sign() const { return size_ == 0 ? 0 : sign_of(parts_[size_ - 1]); }

 private:
  void add_product(double x, double y) {
    const double product = x * y;
    add(std::fma(x, y, -product));
    add(product);
  }

  void add(double value) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const double sum = value + parts_[i];
      const double of_part = sum - value;
      const double error = (value - (sum - of_part)) + (parts_[i] - of_part);
      if (error != 0.0) {
        parts_[kept++] = error;
      }
      value = sum;
    }
    if (value != 0.0) {
      parts_[kept++] = value;
    }
    size_ = kept;
  }

  std::array<double, 4 * 24 + 1> parts_{};  // 24 products of at most four parts each
  std::size_t size_{0};
};

void add_determinant(ExactSum& sum, double sign, const Vector3& a, const Vector3& b,
                     const Vector3& c) {
  sum.add(sign, a.x(), b.y(), c.z());
  sum.add(sign, a.y(), b.z(), c.x());
  sum.add(sign, a.z(), b.x(), c.y());
  sum.add(-sign, a.z(), b.y(), c.x());
  sum.add(-sign, a.x(), b.z(), c.y());
  sum.add(-sign, a.y(), b.x(), c.z());
}

}  // namespace

int side_of_plane(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  const Vector3 u = b - a;
  const Vector3 v = c - a;
  const Vector3 w = d - a;
  const double determinant = u.cross(v).dot(w);
  const Vector3 size(std::abs(u.y() * v.z()) + std::abs(u.z() * v.y()),
                     std::abs(u.z() * v.x()) + std::abs(u.x() * v.z()),
                     std::abs(u.x() * v.y()) + std::abs(u.y() * v.x()));
  if (std::abs(determinant) > kRelativeError * size.dot(w.cwiseAbs())) {
    return sign_of(determinant);
  }
  ExactSum sum;
  add_determinant(sum, 1.0, b, c, d);
  add_determinant(sum, -1.0, a, c, d);
  add_determinant(sum, 1.0, a, b, d);
  add_determinant(sum, -1.0, a, b, c);
  return sum.sign();
}

int turn_across(int axis, const Vector3& a, const Vector3& b, const Vector3& c) {
  const int x = (axis + 1) % 3;
  const int y = (axis + 2) % 3;
  const double left = (b[x] - a[x]) * (c[y] - a[y]);
  const double right = (b[y] - a[y]) * (c[x] - a[x]);
  if (std::abs(left - right) > kRelativeError * (std::abs(left) + std::abs(right))) {
    return sign_of(left - right);
  }
  ExactSum sum;
  sum.add(1.0, b[x], c[y], 1.0);
  sum.add(-1.0, b[y], c[x], 1.0);
  sum.add(-1.0, a[x], c[y], 1.0);
  sum.add(1.0, a[y], c[x], 1.0);
  sum.add(1.0, a[x], b[y], 1.0);
  sum.add(-1.0, a[y], b[x], 1.0);
  return sum.sign();
}

}  // namespace impetus::inline shapes
