// SPDX-License-Identifier: MIT
#include "engine/volumes/sphere_lanes.hpp"

#include <cassert>
#include <cstring>

namespace impetus::inline volumes {
namespace {

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
  std::memcpy(&bits, kBitOfLane + column, sizeof bits);
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

template <int kWidth>
IMPETUS_INLINED void touches_by(const SpherePairs& pairs, const Vector3& if_coincident,
                                TouchPoint* touches) {
  using Numbers = typename Vectors<kWidth>::Numbers;
  const Numbers none{};
  for (int first = 0; first < kLanes; first += kWidth) {
    Numbers a[4];
    Numbers b[4];
    for (int row = 0; row < 4; ++row) {
      read(&pairs.a[row][first], a[row]);
      read(&pairs.b[row][first], b[row]);
    }
    const Numbers dx = a[0] - b[0];
    const Numbers dy = a[1] - b[1];
    const Numbers dz = a[2] - b[2];
    Numbers distance = dx * dx + (dy * dy + dz * dz);
    take_roots<kWidth>(distance);
    const Numbers reach = a[3] + b[3];
    const Numbers depth = reach - distance;
    double found[7][kWidth];
    for (int axis = 0; axis < 3; ++axis) {
      const Numbers along = (a[axis] - b[axis]) / distance;
      const Numbers normal = distance > none ? along : none + if_coincident[axis];
      const Numbers between = (b[3] * a[axis] + a[3] * b[axis]) / reach;
      const Numbers point = reach > none ? between : 0.5 * (a[axis] + b[axis]);
      std::memcpy(found[axis], &point, sizeof point);
      std::memcpy(found[3 + axis], &normal, sizeof normal);
    }
    std::memcpy(found[6], &depth, sizeof depth);
    for (int lane = 0; lane < kWidth; ++lane) {
      TouchPoint& touch = touches[first + lane];
      touch.point = {found[0][lane], found[1][lane], found[2][lane]};
      touch.normal = {found[3][lane], found[4][lane], found[5][lane]};
      touch.depth_m = found[6][lane];
    }
  }
}

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

std::uint64_t overlaps_of_block(const SphereLanes& a, int rows, const SphereLanes& b, int columns,
                                LaneWidth width) {
  assert(rows >= 1 && rows <= kLanes && columns >= 1 && columns <= kLanes);
  return in_lanes(
      width, [&]<int kWidth>() __attribute__((always_inline)) {
        return overlaps_by<kWidth>(a, rows, b, columns);
      });
}

void touches_of_pairs(const SpherePairs& pairs, const Vector3& normal_if_coincident,
                      TouchPoint* touches, LaneWidth width) {
  in_lanes(
      width, [&]<int kWidth>() __attribute__((always_inline)) {
        touches_by<kWidth>(pairs, normal_if_coincident, touches);
      });
}

void place_block(const SphereLanes& own, const Pose& pose, const CentreLanes& placed,
                 LaneWidth width) {
  in_lanes(
      width, [&]<int kWidth>()
                 __attribute__((always_inline)) { place_by<kWidth>(own, pose, placed); });
}

}  // namespace impetus::inline volumes
