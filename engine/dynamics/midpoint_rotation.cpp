// SPDX-License-Identifier: MIT
#include "engine/dynamics/midpoint_rotation.hpp"

#include <cassert>
#include <cstddef>
#include <cstring>

namespace impetus::inline dynamics {
namespace {

using Rows = TurningBodies::Rows;

void write(Rows& rows, int lane, const BodyModel& model, const BodyState& state, double dt_s) {
  for (int i = 0; i < 4; ++i) {
    rows.orientation[i][lane] = state.pose.orientation.coeffs()[i];
  }
  for (int i = 0; i < 3; ++i) {
    rows.momentum[i][lane] = state.angular_momentum[i];
    for (int j = 0; j < 3; ++j) {
      rows.inverse_inertia[3 * i + j][lane] = model.inverse_inertia(i, j);
    }
  }
  rows.dt_s[lane] = dt_s;
}

/// An empty lane holds what another does: numbers at least.
void copy_lane(Rows& rows, int from, int to) {
  for (auto& row : rows.orientation) {
    row[to] = row[from];
  }
  for (auto& row : rows.momentum) {
    row[to] = row[from];
  }
  for (auto& row : rows.inverse_inertia) {
    row[to] = row[from];
  }
  rows.dt_s[to] = rows.dt_s[from];
}

Quaternion orientation_of(const Rows& rows, int lane) {
  return {rows.orientation[3][lane], rows.orientation[0][lane], rows.orientation[1][lane],
          rows.orientation[2][lane]};
}

/// The arithmetic of Eigen's vectors and quaternions, operation by operation, in lanes.
template <int kWidth>
struct Lanes {
  using Numbers = typename Vectors<kWidth>::Numbers;
  using Turn = Numbers[4];  // x, y, z, w

  static IMPETUS_INLINED void normalise(Turn& turn) {
    const Numbers none{};
    const Numbers square =
        (turn[0] * turn[0] + turn[1] * turn[1]) + (turn[2] * turn[2] + turn[3] * turn[3]);
    Numbers size = square;
    take_roots<kWidth>(size);
    for (Numbers& one : turn) {
      one = square > none ? one / size : one;
    }
  }

  static IMPETUS_INLINED void multiply(const Turn& a, const Turn& b, Turn& product) {
    product[0] = a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1];
    product[1] = a[3] * b[1] + a[1] * b[3] + a[2] * b[0] - a[0] * b[2];
    product[2] = a[3] * b[2] + a[2] * b[3] + a[0] * b[1] - a[1] * b[0];
    product[3] = a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2];
  }

  static IMPETUS_INLINED void find_matrix(const Turn& turn, Numbers (&matrix)[9]) {
    const Numbers x = 2.0 * turn[0];
    const Numbers y = 2.0 * turn[1];
    const Numbers z = 2.0 * turn[2];
    const Numbers wx = x * turn[3];
    const Numbers wy = y * turn[3];
    const Numbers wz = z * turn[3];
    const Numbers xx = x * turn[0];
    const Numbers xy = y * turn[0];
    const Numbers xz = z * turn[0];
    const Numbers yy = y * turn[1];
    const Numbers yz = z * turn[1];
    const Numbers zz = z * turn[2];
    matrix[0] = 1.0 - (yy + zz);
    matrix[1] = xy - wz;
    matrix[2] = xz + wy;
    matrix[3] = xy + wz;
    matrix[4] = 1.0 - (xx + zz);
    matrix[5] = yz - wx;
    matrix[6] = xz - wy;
    matrix[7] = yz + wx;
    matrix[8] = 1.0 - (xx + yy);
  }

  /// Of the matrix, or of its transpose, with a vector.
  static IMPETUS_INLINED void multiply(const Numbers (&m)[9], const Numbers (&v)[3],
                                       Numbers (&product)[3]) {
    for (int row = 0; row < 3; ++row) {
      product[row] = m[3 * row] * v[0] + (m[3 * row + 1] * v[1] + m[3 * row + 2] * v[2]);
    }
  }
  static IMPETUS_INLINED void multiply_transposed(const Numbers (&m)[9], const Numbers (&v)[3],
                                                  Numbers (&product)[3]) {
    for (int row = 0; row < 3; ++row) {
      product[row] = m[row] * v[0] + (m[row + 3] * v[1] + m[row + 6] * v[2]);
    }
  }

  /// The bodies of kWidth lanes from `first` on.
  static IMPETUS_INLINED void turn(Rows& rows, int first) {
    constexpr int kIterations = 4;
    Turn start;
    Numbers momentum[3];
    Numbers inverse_inertia[9];
    Numbers dt_s;
    read_rows(rows.orientation, first, start);
    read_rows(rows.momentum, first, momentum);
    read_rows(rows.inverse_inertia, first, inverse_inertia);
    read(rows.dt_s + first, dt_s);
    Turn middle = {start[0], start[1], start[2], start[3]};
    Turn end;
    for (int iteration = 0; iteration <= kIterations; ++iteration) {
      Numbers rotation[9];
      Numbers of_body[3];
      Numbers spin_of_body[3];
      Numbers spin[3];
      find_matrix(middle, rotation);
      multiply_transposed(rotation, momentum, of_body);
      multiply(inverse_inertia, of_body, spin_of_body);
      multiply(rotation, spin_of_body, spin);
      Turn cayley;
      for (int i = 0; i < 3; ++i) {
        cayley[i] = 0.5 * (spin[i] * dt_s);
      }
      cayley[3] = Numbers{} + 1.0;
      normalise(cayley);
      multiply(cayley, start, end);
      normalise(end);
      for (int i = 0; i < 4; ++i) {
        middle[i] = start[i] + end[i];
      }
      normalise(middle);
    }
    for (int i = 0; i < 4; ++i) {
      std::memcpy(&rows.orientation[i][first], &end[i], sizeof end[i]);
    }
  }

 private:
  template <std::size_t kRows>
  static IMPETUS_INLINED void read_rows(const double (&from)[kRows][kLanes], int first,
                                        Numbers (&into)[kRows]) {
    for (std::size_t row = 0; row < kRows; ++row) {
      read(&from[row][first], into[row]);
    }
  }
};

template <int kWidth>
IMPETUS_INLINED void turn_by(Rows& rows, int count) {
  for (int first = 0; first < count; first += kWidth) {
    Lanes<kWidth>::turn(rows, first);
  }
}

}  // namespace

void TurningBodies::put(const BodyModel& model, BodyState& state, double dt_s) {
  assert(!is_full());
  write(rows_, count_, model, state, dt_s);
  states_[static_cast<std::size_t>(count_++)] = &state;
}

void TurningBodies::turn(LaneWidth width) {
  if (count_ == 1) {
    Lanes<1>::turn(rows_, 0);  // lanes to no use take longer
  } else if (count_ > 1) {
    for (int lane = count_; lane < kLanes; ++lane) {
      copy_lane(rows_, 0, lane);
    }
    in_lanes(
        width, [&]<int kWidth>()
                   __attribute__((always_inline)) { turn_by<kWidth>(rows_, count_); });
  }
  for (int lane = 0; lane < count_; ++lane) {
    states_[static_cast<std::size_t>(lane)]->pose.orientation = orientation_of(rows_, lane);
  }
  count_ = 0;
}

}  // namespace impetus::inline dynamics
