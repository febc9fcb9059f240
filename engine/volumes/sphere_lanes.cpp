// SPDX-License-Identifier: MIT
#include "engine/volumes/sphere_lanes.hpp"

#include <cassert>
#include <cstring>

// Vectors are passed by reference alone, and all that touches them is inlined into the function of
// its width: how they would be passed to another is then of no concern.
#define IMPETUS_INLINED inline __attribute__((always_inline))
#if defined(__x86_64__)
#define IMPETUS_FOR(instructions) __attribute__((target(instructions)))
#endif

namespace impetus {
namespace {

template <int kWidth>
struct Vectors;
template <>
struct Vectors<2> {
  using Numbers = double __attribute__((vector_size(16)));
  using Bits = std::int64_t __attribute__((vector_size(16)));
};
template <>
struct Vectors<4> {
  using Numbers = double __attribute__((vector_size(32)));
  using Bits = std::int64_t __attribute__((vector_size(32)));
};
template <>
struct Vectors<8> {
  using Numbers = double __attribute__((vector_size(64)));
  using Bits = std::int64_t __attribute__((vector_size(64)));
};

template <typename Numbers>
IMPETUS_INLINED void read(const double* from, Numbers& into) {
  std::memcpy(&into, from, sizeof into);
}

/// The bits of columns `column` to `column + kWidth`, of all rows.
template <int kWidth>
IMPETUS_INLINED std::uint64_t overlaps_of_columns(const SphereLanes& a, int rows,
                                                  const SphereLanes& b, int column) {
  using Numbers = typename Vectors<kWidth>::Numbers;
  using Bits = typename Vectors<kWidth>::Bits;
  Numbers bx;
  Numbers by;
  Numbers bz;
  Numbers b_radius;
  read(b.x + column, bx);
  read(b.y + column, by);
  read(b.z + column, bz);
  read(b.radius_m + column, b_radius);
  Bits bits;
  for (int lane = 0; lane < kWidth; ++lane) {
    bits[lane] = std::int64_t{1} << (column + lane);
  }
  Bits found = bits ^ bits;
  for (int row = 0; row < rows; ++row) {
    const Numbers dx = a.x[row] - bx;
    const Numbers dy = a.y[row] - by;
    const Numbers dz = a.z[row] - bz;
    const Numbers reach = a.radius_m[row] + b_radius;
    found |= (dx * dx + (dy * dy + dz * dz) <= reach * reach) & bits;
    bits <<= kLanes;
  }
  std::uint64_t all = 0;
  for (int lane = 0; lane < kWidth; ++lane) {
    all |= static_cast<std::uint64_t>(found[lane]);
  }
  return all;
}

template <int kWidth>
IMPETUS_INLINED std::uint64_t overlaps_by(const SphereLanes& a, int rows, const SphereLanes& b,
                                          int columns) {
  constexpr std::uint64_t kFirstColumn = 0x0101010101010101;
  std::uint64_t all = 0;
  for (int column = 0; column < kLanes; column += kWidth) {
    all |= overlaps_of_columns<kWidth>(a, rows, b, column);
  }
  return all & (kFirstColumn * ((std::uint64_t{1} << columns) - 1));
}

/// The rotation of v by (w, q): v + w u + q × u with u = 2 q × v.
template <int kWidth>
IMPETUS_INLINED void place_by(const SphereLanes& own, const Pose& pose, const CentreLanes& placed) {
  using Numbers = typename Vectors<kWidth>::Numbers;
  const double w = pose.orientation.w();
  const double qx = pose.orientation.x();
  const double qy = pose.orientation.y();
  const double qz = pose.orientation.z();
  for (int lane = 0; lane < kLanes; lane += kWidth) {
    Numbers x;
    Numbers y;
    Numbers z;
    read(own.x + lane, x);
    read(own.y + lane, y);
    read(own.z + lane, z);
    Numbers ux = qy * z - qz * y;
    Numbers uy = qz * x - qx * z;
    Numbers uz = qx * y - qy * x;
    ux += ux;
    uy += uy;
    uz += uz;
    const Numbers px = pose.position.x() + ((x + w * ux) + (qy * uz - qz * uy));
    const Numbers py = pose.position.y() + ((y + w * uy) + (qz * ux - qx * uz));
    const Numbers pz = pose.position.z() + ((z + w * uz) + (qx * uy - qy * ux));
    std::memcpy(placed.x + lane, &px, sizeof px);
    std::memcpy(placed.y + lane, &py, sizeof py);
    std::memcpy(placed.z + lane, &pz, sizeof pz);
  }
}

#ifdef IMPETUS_FOR
IMPETUS_FOR("avx512f")
std::uint64_t overlaps_by_eight(const SphereLanes& a, int rows, const SphereLanes& b, int columns) {
  return overlaps_by<8>(a, rows, b, columns);
}

IMPETUS_FOR("avx2")
std::uint64_t overlaps_by_four(const SphereLanes& a, int rows, const SphereLanes& b, int columns) {
  return overlaps_by<4>(a, rows, b, columns);
}

IMPETUS_FOR("avx512f")
void place_by_eight(const SphereLanes& own, const Pose& pose, const CentreLanes& placed) {
  place_by<8>(own, pose, placed);
}

IMPETUS_FOR("avx2")
void place_by_four(const SphereLanes& own, const Pose& pose, const CentreLanes& placed) {
  place_by<4>(own, pose, placed);
}
#endif

}  // namespace

void SphereArrays::add(const Sphere& sphere) {
  const std::size_t readable = ++size_ + kLanes - 1;
  for (std::vector<double>* array : {&x_, &y_, &z_, &radius_m_}) {
    array->resize(readable, 0.0);
  }
  x_[size_ - 1] = sphere.centre.x();
  y_[size_ - 1] = sphere.centre.y();
  z_[size_ - 1] = sphere.centre.z();
  radius_m_[size_ - 1] = sphere.radius_m;
}

LaneWidth widest_lanes() {
#ifdef IMPETUS_FOR
  if (__builtin_cpu_supports("avx512f")) {
    return LaneWidth::kEight;
  }
  if (__builtin_cpu_supports("avx2")) {
    return LaneWidth::kFour;
  }
#endif
  return LaneWidth::kTwo;
}

std::uint64_t overlaps_of_block(const SphereLanes& a, int rows, const SphereLanes& b, int columns,
                                LaneWidth width) {
  assert(rows >= 1 && rows <= kLanes && columns >= 1 && columns <= kLanes);
#ifdef IMPETUS_FOR
  if (width == LaneWidth::kEight) {
    return overlaps_by_eight(a, rows, b, columns);
  }
  if (width == LaneWidth::kFour) {
    return overlaps_by_four(a, rows, b, columns);
  }
#endif
  return overlaps_by<2>(a, rows, b, columns);
}

void place_block(const SphereLanes& own, const Pose& pose, const CentreLanes& placed,
                 LaneWidth width) {
#ifdef IMPETUS_FOR
  if (width == LaneWidth::kEight) {
    return place_by_eight(own, pose, placed);
  }
  if (width == LaneWidth::kFour) {
    return place_by_four(own, pose, placed);
  }
#endif
  place_by<2>(own, pose, placed);
}

}  // namespace impetus
