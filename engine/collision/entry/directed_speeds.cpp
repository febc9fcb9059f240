// SPDX-License-Identifier: MIT
#include "engine/collision/entry/directed_speeds.hpp"

#include <cmath>
#include <cstring>

#include "engine/numerics/lanes.hpp"

namespace impetus::inline collision {
namespace {

/// Of two bodies: about where they turn, and how fast.
struct TwoTurns {
  Vector3 centre_a;
  Vector3 centre_b;
  double turn_a;
  double turn_b;
};

/// How fast points of a block's spheres move that turn about `centre`.
template <int kWidth>
IMPETUS_INLINED void find_turning(const SphereLanes& spheres, const Vector3& centre, double turn,
                                  LaneValues& speeds_m) {
  using Numbers = typename Vectors<kWidth>::Numbers;
  if (!(turn > 0.0)) {
    speeds_m.fill(0.0);
    return;
  }
  for (int lane = 0; lane < kLanes; lane += kWidth) {
    Numbers x;
    Numbers y;
    Numbers z;
    Numbers radius;
    read(spheres.x + lane, x);
    read(spheres.y + lane, y);
    read(spheres.z + lane, z);
    read(spheres.radius_m + lane, radius);
    x -= centre.x();
    y -= centre.y();
    z -= centre.z();
    Numbers distance = x * x + (y * y + z * z);
    take_roots<kWidth>(distance);
    const Numbers speed = turn * (distance + radius);
    std::memcpy(&speeds_m[static_cast<std::size_t>(lane)], &speed, sizeof speed);
  }
}

/// The turning of a block's spheres, and which of its pairs could touch.
struct NearPairs {
  const SphereBlock& block;
  const TwoTurns& bodies;
  double time;
  double hair_m;
  double margin_m;
  Vector3 way;  ///< of a against b within the time
  BlockTurning& turning;

  template <int kWidth>
  IMPETUS_INLINED std::uint64_t operator()() const {
    find_turning<kWidth>(block.a, bodies.centre_a, bodies.turn_a, turning.a);
    find_turning<kWidth>(block.b, bodies.centre_b, bodies.turn_b, turning.b);
    return near_pairs<kWidth>();
  }

  /// Of which pairs apart_for() is not true.
  template <int kWidth>
  IMPETUS_INLINED std::uint64_t near_pairs() const {
    using Numbers = typename Vectors<kWidth>::Numbers;
    using Bits = typename Vectors<kWidth>::Bits;
    const Numbers none{};
    const Numbers margin = none + margin_m;
    std::uint64_t all = 0;
    for (int column = 0; column < block.columns; column += kWidth) {
      Numbers bx;
      Numbers by;
      Numbers bz;
      Numbers radius;
      Numbers turning_of_b;
      read(block.b.x + column, bx);
      read(block.b.y + column, by);
      read(block.b.z + column, bz);
      read(block.b.radius_m + column, radius);
      read(&turning.b[static_cast<std::size_t>(column)], turning_of_b);
      const Numbers reach_of_b = radius + margin_m;
      const Numbers left_of_b = radius + (time * turning_of_b + (margin_m - hair_m));
      Bits bits;
      std::memcpy(&bits, kBitOfLane + column, sizeof bits);
      Bits apart = bits ^ bits;
      for (int row = 0; row < block.rows; ++row) {
        const double radius_of_a = block.a.radius_m[row];
        const double left_of_a = radius_of_a + time * turning.a[static_cast<std::size_t>(row)];
        const Numbers dx = block.a.x[row] - bx;
        const Numbers dy = block.a.y[row] - by;
        const Numbers dz = block.a.z[row] - bz;
        const Numbers square = dx * dx + (dy * dy + dz * dz);
        const Numbers away = dx * way.x() + (dy * way.y() + dz * way.z());
        const Numbers rest = square + (away < none ? away : none);
        const Numbers left = rest > none ? rest : none;
        const Numbers reach = radius_of_a + reach_of_b;
        const Numbers sum = left_of_a + left_of_b;
        const Numbers needed = sum > margin ? sum : margin;
        // Both are negative where both signs are: GCC takes two comparisons of lanes apart.
        const Numbers too_near = reach * reach - square;
        const Numbers too_little = (needed * needed) * square - left * left;
        Bits clear;
        Bits enough;
        std::memcpy(&clear, &too_near, sizeof clear);
        std::memcpy(&enough, &too_little, sizeof enough);
        apart |= ((clear & enough) < 0) & bits;
        bits <<= kLanes;
      }
      for (int lane = 0; lane < kWidth; ++lane) {
        all |= static_cast<std::uint64_t>(apart[lane]);
      }
    }
    return block.all() & ~all;
  }
};

}  // namespace

void DirectedSpeeds::enter(const RelativeStretch& stretch) {
  velocity_ = stretch.velocity;
  turn_a_ = stretch.turn_a;
  turn_b_ = stretch.turn_b;
  fastest_m_ = stretch.fastest(reach_a_m_, reach_b_m_);
}

void DirectedSpeeds::place(const Pose& a, const Pose& b, double /*time*/) {
  centre_a_ = a.position;
  centre_b_ = b.position;
  reaches_hold_ = std::isfinite(fastest_m_) && can_be_squared(margin_m(1.0)) &&
                  can_be_squared(margin_m(0.0)) && reach_holds(a, reach_a_m_) &&
                  reach_holds(b, reach_b_m_);
}

std::uint64_t DirectedSpeeds::within(double time, double hair_m, const SphereBlock& block,
                                     BlockTurning& turning, LaneWidth width) const {
  const TwoTurns bodies{centre_a_, centre_b_, turn_a_, turn_b_};
  const std::uint64_t near = in_lanes(
      width, NearPairs{block, bodies, time, hair_m, margin_m(time), time * velocity_, turning});
  return reaches_hold_ ? near : block.all();
}

}  // namespace impetus::inline collision
