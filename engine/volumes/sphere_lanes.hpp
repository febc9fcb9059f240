// Spheres in blocks, a coordinate at a time: what the descent of two sphere-trees does most.
//
//   x       | x0 x1 x2 x3 x4 x5 x6 x7 | ...     an array for each coordinate and one for the radii,
//   y z r   | ...                               readable a block beyond their last element
//
//   block of a (rows) × block of b (columns)  ->  64 bits, bit 8 i + j: do a_i and b_j overlap?
//
// The arithmetic is that of overlap() and touch() of two spheres and of Pose::transform(),
// operation by operation in double precision, so every width of vector gives the same bits as no
// vector at all. The widest that the machine has is chosen at run time.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/numerics/lanes.hpp"
#include "engine/volumes/sphere.hpp"

namespace impetus::inline volumes {

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

/// Pairs of spheres, gathered from anywhere.
class SpherePairs {
 public:
  /// Their coordinates and radii, each a row: x, y, z, radius.
  double a[4][kLanes];
  double b[4][kLanes];

  void put(int lane, const SphereLanes& of_a, std::int32_t index_a, const SphereLanes& of_b,
           std::int32_t index_b) {
    put(a, lane, of_a, index_a);
    put(b, lane, of_b, index_b);
  }

 private:
  static void put(double (&rows)[4][kLanes], int lane, const SphereLanes& spheres,
                  std::int32_t index) {
    rows[0][lane] = spheres.x[index];
    rows[1][lane] = spheres.y[index];
    rows[2][lane] = spheres.z[index];
    rows[3][lane] = spheres.radius_m[index];
  }
};

/// Which of the first `rows` spheres of a overlap or touch which of the first `columns` of b: bit
/// kLanes · row + column, as overlap() of the two says. Precondition: 1 to kLanes rows and columns.
std::uint64_t overlaps_of_block(const SphereLanes& a, int rows, const SphereLanes& b, int columns,
                                LaneWidth width = widest_lanes());

/// The contacts of all pairs, as touch() of two spheres makes them. What is in a lane that was not
/// put must be numbers, and its contact means nothing.
void touches_of_pairs(const SpherePairs& pairs, const Vector3& normal_if_coincident,
                      TouchPoint* touches, LaneWidth width = widest_lanes());

/// The centres of a block's spheres at `pose`, as Pose::transform() places them.
void place_block(const SphereLanes& own, const Pose& pose, const CentreLanes& placed,
                 LaneWidth width = widest_lanes());

}  // namespace impetus::inline volumes
