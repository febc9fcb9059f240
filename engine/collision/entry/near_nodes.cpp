// SPDX-License-Identifier: MIT
#include "engine/collision/entry/near_nodes.hpp"

#include <cmath>
#include <cstring>
#include <optional>

#include "engine/numerics/lanes.hpp"
#include "engine/volumes/core_contact.hpp"
#include "engine/volumes/core_distance.hpp"

namespace impetus::inline collision {
namespace {

/// What is asked of a block, and where its spheres' turning is kept.
struct NearBlock {
  const SphereBlock& block;
  double time;
  double hair_m;
  double margin_m;
  Vector3 way;  ///< of a against b within the time
  BlockTurning& turning;
};

/// Bodies, about where they turn and how fast.
struct TurningBodies {
  Vector3 centre_a;
  Vector3 centre_b;
  double turn_a;
  double turn_b;
};

/// A margin of lengths whose fourth powers are ordinary numbers.
bool can_be_squared(double length_m) { return length_m > 1e-60 && length_m < 1e50; }

bool reach_holds(const Pose& pose, double reach_m) {
  constexpr double kFar = 1e5;
  constexpr double kStretch = 1e-11;
  return pose.position.allFinite() && pose.position.cwiseAbs().maxCoeff() <= kFar * reach_m &&
         std::abs(pose.orientation.squaredNorm() - 1.0) <= kStretch;
}

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

/// Of which pairs of a block apart_for() is not true.
template <int kWidth>
IMPETUS_INLINED std::uint64_t near_pairs(const NearBlock& near) {
  using Numbers = typename Vectors<kWidth>::Numbers;
  using Bits = typename Vectors<kWidth>::Bits;
  const SphereBlock& block = near.block;
  const Numbers none{};
  const Numbers margin = none + near.margin_m;
  std::uint64_t all = 0;
  for (int column = 0; column < block.columns; column += kWidth) {
    Numbers bx;
    Numbers by;
    Numbers bz;
    Numbers radius;
    Numbers turning;
    read(block.b.x + column, bx);
    read(block.b.y + column, by);
    read(block.b.z + column, bz);
    read(block.b.radius_m + column, radius);
    read(&near.turning.b[static_cast<std::size_t>(column)], turning);
    const Numbers reach_of_b = radius + near.margin_m;
    const Numbers left_of_b = radius + (near.time * turning + (near.margin_m - near.hair_m));
    Bits bits;
    std::memcpy(&bits, kBitOfLane + column, sizeof bits);
    Bits apart = bits ^ bits;
    for (int row = 0; row < block.rows; ++row) {
      const double radius_of_a = block.a.radius_m[row];
      const double left_of_a =
          radius_of_a + near.time * near.turning.a[static_cast<std::size_t>(row)];
      const Numbers dx = block.a.x[row] - bx;
      const Numbers dy = block.a.y[row] - by;
      const Numbers dz = block.a.z[row] - bz;
      const Numbers square = dx * dx + (dy * dy + dz * dz);
      const Numbers away = dx * near.way.x() + (dy * near.way.y() + dz * near.way.z());
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

template <int kWidth>
IMPETUS_INLINED std::uint64_t near_by(const NearBlock& near, const TurningBodies& bodies) {
  find_turning<kWidth>(near.block.a, bodies.centre_a, bodies.turn_a, near.turning.a);
  find_turning<kWidth>(near.block.b, bodies.centre_b, bodies.turn_b, near.turning.b);
  return near_pairs<kWidth>(near);
}

#ifdef IMPETUS_EIGHT_LANES
IMPETUS_EIGHT_LANES
std::uint64_t near_by_eight(const NearBlock& near, const TurningBodies& bodies) {
  return near_by<8>(near, bodies);
}

IMPETUS_FOUR_LANES
std::uint64_t near_by_four(const NearBlock& near, const TurningBodies& bodies) {
  return near_by<4>(near, bodies);
}
#endif

std::uint64_t near_of_block(const NearBlock& near, const TurningBodies& bodies,
                            [[maybe_unused]] LaneWidth width) {
#ifdef IMPETUS_EIGHT_LANES
  if (width == LaneWidth::kEight) {
    return near_by_eight(near, bodies);
  }
  if (width == LaneWidth::kFour) {
    return near_by_four(near, bodies);
  }
#endif
  return near_by<2>(near, bodies);
}

}  // namespace

NodeGap gap_of_nodes(const Volume& a, const Volume& b) {
  const CoredVolume of_a = cored(a);
  const CoredVolume of_b = cored(b);
  const std::optional<ClosestOfCores> closest = closest_points(of_a.core, of_b.core);
  if (closest) {
    const double distance_m = std::sqrt(closest->squared_m2);
    return {distance_m - of_a.radius_m - of_b.radius_m,
            (closest->on_a - closest->on_b) / distance_m};
  }
  const TouchPoint touching = core_contact(of_a, of_b, Vector3::UnitX());
  return {-touching.depth_m, touching.normal};
}

void NearSpheres::enter(const RelativeStretch& stretch, double reach_a_m, double reach_b_m) {
  velocity_ = stretch.velocity;
  turn_a_ = stretch.turn_a;
  turn_b_ = stretch.turn_b;
  fastest_m_ = stretch.fastest(reach_a_m, reach_b_m);
  reach_a_m_ = reach_a_m;
  reach_b_m_ = reach_b_m;
}

void NearSpheres::place(const Pose& a, const Pose& b) {
  centre_a_ = a.position;
  centre_b_ = b.position;
  reaches_hold_ = std::isfinite(fastest_m_) && can_be_squared(margin_m(1.0)) &&
                  can_be_squared(margin_m(0.0)) && reach_holds(a, reach_a_m_) &&
                  reach_holds(b, reach_b_m_);
}

std::uint64_t NearSpheres::within(double time, double hair_m, const SphereBlock& block,
                                  BlockTurning& turning, [[maybe_unused]] LaneWidth width) const {
  const std::uint64_t near =
      near_of_block({block, time, hair_m, margin_m(time), time * velocity_, turning},
                    {centre_a_, centre_b_, turn_a_, turn_b_}, width);
  return reaches_hold_ ? near : block.all();
}

}  // namespace impetus::inline collision
