// Spheres in blocks, a coordinate at a time: what the descent of two sphere-trees does most.
//
//   x       | x0 x1 x2 x3 x4 x5 x6 x7 | ...     an array for each coordinate and one for the radii,
//   y z r   | ...                               readable a block beyond their last element
//
//   block of a (rows) × block of b (columns)  ->  64 bits, bit 8 i + j: do a_i and b_j overlap?
//
// The arithmetic is that of overlap(Sphere, Sphere) and Pose::transform(), operation by operation in
// double precision, so every width of vector gives the same bits as no vector at all. The widest
// that the machine has is chosen at run time.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/volumes/sphere.hpp"

namespace impetus {

/// Spheres of a block, and rows and columns of its bits.
inline constexpr int kLanes = 8;

/// Where a block's spheres begin in each array. kLanes elements can be read from there.
struct SphereLanes {
  const double* x;
  const double* y;
  const double* z;
  const double* radius_m;
};

/// The same of centres to be written.
struct CentreLanes {
  double* x;
  double* y;
  double* z;
};

/// Spheres, each coordinate in an array of its own.
class SphereArrays {
 public:
  void add(const Sphere& sphere);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] Sphere at(std::size_t index) const {
    return {{x_[index], y_[index], z_[index]}, radius_m_[index]};
  }
  /// From sphere `first` on.
  [[nodiscard]] SphereLanes lanes(std::size_t first) const {
    return {&x_[first], &y_[first], &z_[first], &radius_m_[first]};
  }
  [[nodiscard]] std::size_t bytes() const { return 4 * x_.size() * sizeof(double); }

 private:
  std::size_t size_{0};
  std::vector<double> x_;
  std::vector<double> y_;
  std::vector<double> z_;
  std::vector<double> radius_m_;
};

/// How many doubles a vector holds.
enum class LaneWidth { kTwo = 2, kFour = 4, kEight = 8 };

/// The widest that this machine has instructions for.
LaneWidth widest_lanes();

/// Which of the first `rows` spheres of a overlap or touch which of the first `columns` of b: bit
/// kLanes · row + column, as overlap() of the two says. Precondition: 1 to kLanes rows and columns.
std::uint64_t overlaps_of_block(const SphereLanes& a, int rows, const SphereLanes& b, int columns,
                                LaneWidth width = widest_lanes());

/// The centres of a block's spheres at `pose`, as Pose::transform() places them.
void place_block(const SphereLanes& own, const Pose& pose, const CentreLanes& placed,
                 LaneWidth width = widest_lanes());

}  // namespace impetus
