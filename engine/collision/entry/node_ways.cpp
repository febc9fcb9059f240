// SPDX-License-Identifier: MIT
#include "engine/collision/entry/node_ways.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "engine/numerics/lanes.hpp"

namespace impetus::inline collision {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

/// How far bodies turn at most while they are looked at (radians). Half as far took as long.
constexpr double kTurnAhead = 0.5;

/// Of the way of a whole step and the bodies' reaches: what rounding can never come to.
constexpr double kMargin = 1e-7;

/// A body's spheres, and how it goes.
struct TurningSpheres {
  const SphereLanes& spheres;
  Vector3 centre;    ///< of mass
  Vector3 velocity;  ///< of it (metres a step)
  Vector3 spin;      ///< radians a step
  double stray;      ///< of a metre from the centre: half of its bend
};

/// The ways of a block's spheres, and which of its pairs could touch.
struct NearPairs {
  const SphereBlock& block;
  const TurningSpheres& a;
  const TurningSpheres& b;
  double time;
  double hair_m;
  double margin_m;
  BlockWays& ways;

  template <int kWidth>
  IMPETUS_INLINED std::uint64_t operator()() const {
    find_ways<kWidth>(a, ways.a);
    find_ways<kWidth>(b, ways.b);
    return near_pairs<kWidth>();
  }

  template <int kWidth>
  IMPETUS_INLINED static void find_ways(const TurningSpheres& body, LaneWays& ways) {
    using Numbers = typename Vectors<kWidth>::Numbers;
    for (int lane = 0; lane < kLanes; lane += kWidth) {
      Numbers x;
      Numbers y;
      Numbers z;
      read(body.spheres.x + lane, x);
      read(body.spheres.y + lane, y);
      read(body.spheres.z + lane, z);
      x -= body.centre.x();
      y -= body.centre.y();
      z -= body.centre.z();
      Numbers stray = x * x + (y * y + z * z);
      take_roots<kWidth>(stray);
      stray *= body.stray;
      const Numbers along_x = body.velocity.x() + (body.spin.y() * z - body.spin.z() * y);
      const Numbers along_y = body.velocity.y() + (body.spin.z() * x - body.spin.x() * z);
      const Numbers along_z = body.velocity.z() + (body.spin.x() * y - body.spin.y() * x);
      const auto place = static_cast<std::size_t>(lane);
      std::memcpy(&ways.x[place], &along_x, sizeof along_x);
      std::memcpy(&ways.y[place], &along_y, sizeof along_y);
      std::memcpy(&ways.z[place], &along_z, sizeof along_z);
      std::memcpy(&ways.stray_m[place], &stray, sizeof stray);
    }
  }

  /// Of which pairs apart_for() is not true.
  template <int kWidth>
  IMPETUS_INLINED std::uint64_t near_pairs() const {
    using Bits = typename Vectors<kWidth>::Bits;
    std::uint64_t all = 0;
    for (int column = 0; column < block.columns; column += kWidth) {
      const Columns<kWidth> columns(block.b, ways.b, column);
      Bits bits;
      std::memcpy(&bits, kBitOfLane + column, sizeof bits);
      Bits apart = bits ^ bits;
      for (int row = 0; row < block.rows; ++row) {
        Bits clear;
        find_clear(row, columns, clear);
        apart |= (clear < 0) & bits;
        bits <<= kLanes;
      }
      for (int lane = 0; lane < kWidth; ++lane) {
        all |= static_cast<std::uint64_t>(apart[lane]);
      }
    }
    return block.all() & ~all;
  }

  /// Spheres of b side by side, and their ways.
  template <int kWidth>
  struct Columns {
    using Numbers = typename Vectors<kWidth>::Numbers;

    IMPETUS_INLINED Columns(const SphereLanes& spheres, const LaneWays& ways, int first) {
      const auto place = static_cast<std::size_t>(first);
      read(spheres.x + first, x);
      read(spheres.y + first, y);
      read(spheres.z + first, z);
      read(spheres.radius_m + first, radius_m);
      read(&ways.x[place], along_x);
      read(&ways.y[place], along_y);
      read(&ways.z[place], along_z);
      read(&ways.stray_m[place], stray_m);
    }

    Numbers x;
    Numbers y;
    Numbers z;
    Numbers radius_m;
    Numbers along_x;
    Numbers along_y;
    Numbers along_z;
    Numbers stray_m;
  };

  /// Makes negative what cannot touch the sphere of a. All is asked by signs: GCC takes comparisons
  /// of lanes apart.
  template <int kWidth>
  IMPETUS_INLINED void find_clear(int row, const Columns<kWidth>& others,
                                  typename Vectors<kWidth>::Bits& clear) const {
    using Numbers = typename Vectors<kWidth>::Numbers;
    using Bits = typename Vectors<kWidth>::Bits;
    const auto place = static_cast<std::size_t>(row);
    const Numbers none{};
    const Numbers margin = none + margin_m;
    const Numbers dx = block.a.x[row] - others.x;
    const Numbers dy = block.a.y[row] - others.y;
    const Numbers dz = block.a.z[row] - others.z;
    const Numbers ux = ways.a.x[place] - others.along_x;
    const Numbers uy = ways.a.y[place] - others.along_y;
    const Numbers uz = ways.a.z[place] - others.along_z;
    const Numbers square = dx * dx + (dy * dy + dz * dz);
    const Numbers away = dx * ux + (dy * uy + dz * uz);
    const Numbers speed2 = ux * ux + (uy * uy + uz * uz);
    const Numbers radii = block.a.radius_m[row] + others.radius_m;
    const Numbers sum =
        radii + ((margin_m - hair_m) + (time * time) * (ways.a.stray_m[place] + others.stray_m));
    const Numbers now = radii + margin;
    const Numbers reach = sum > margin ? sum : margin;
    const Numbers most = now > reach ? now : reach;
    const Numbers reach2 = reach * reach;
    const Numbers still_away = away + time * speed2;
    const Numbers too_near_now = most * most - square;
    const Numbers too_near_then = reach2 - (square + time * (away + still_away));
    const Numbers too_near_between = reach2 * speed2 - (square * speed2 - away * away);
    Bits nearing;
    Bits nearing_then;
    Bits clear_then;
    Bits clear_between;
    std::memcpy(&clear, &too_near_now, sizeof clear);
    std::memcpy(&nearing, &away, sizeof nearing);
    std::memcpy(&nearing_then, &still_away, sizeof nearing_then);
    std::memcpy(&clear_then, &too_near_then, sizeof clear_then);
    std::memcpy(&clear_between, &too_near_between, sizeof clear_between);
    clear &= ~nearing | (nearing_then & clear_then) | clear_between;
  }
};

}  // namespace

void NodeWays::enter(const RelativeStretch& stretch) {
  stretch_ = stretch;
  margin_m_ = kMargin * (stretch.fastest(reach_a_m_, reach_b_m_) + reach_a_m_ + reach_b_m_);
}

void NodeWays::place(const Pose& a, const Pose& b, double time) {
  pose_a_ = a;
  pose_b_ = b;
  spin_a_ = stretch_.turn_a > 0.0 ? turning_at(path_a_, time) : Vector3(Vector3::Zero());
  spin_b_ = stretch_.turn_b > 0.0 ? turning_at(path_b_, time) : Vector3(Vector3::Zero());
  reaches_hold_ =
      can_be_squared(margin_m_) && reach_holds(a, reach_a_m_) && reach_holds(b, reach_b_m_);
}

double NodeWays::horizon(double left) const {
  const double parts = std::ceil(left * std::max(stretch_.turn_a, stretch_.turn_b) / kTurnAhead);
  return parts > 1.0 ? left / parts : left;
}

NodeWay NodeWays::of(const Sphere& a, const Sphere& b) const {
  const Vector3 from_a = a.centre - pose_a_.position;
  const Vector3 from_b = b.centre - pose_b_.position;
  NodeWay way;
  way.velocity = stretch_.velocity + spin_a_.cross(from_a) - spin_b_.cross(from_b);
  way.stray_m = 0.5 * (stretch_.bend_a * from_a.norm() + stretch_.bend_b * from_b.norm());
  way.turning_m = stretch_.turn_a * a.radius_m + stretch_.turn_b * b.radius_m;
  way.radii_m = a.radius_m + b.radius_m;
  return way;
}

NodeWay NodeWays::of(const BlockWays& ways, const SphereBlock& block, int row, int column) {
  const auto i = static_cast<std::size_t>(row);
  const auto j = static_cast<std::size_t>(column);
  return {{ways.a.x[i] - ways.b.x[j], ways.a.y[i] - ways.b.y[j], ways.a.z[i] - ways.b.z[j]},
          ways.a.stray_m[i] + ways.b.stray_m[j],
          0.0,
          block.a.radius_m[row] + block.b.radius_m[column]};
}

double NodeWays::time_of_spheres(double way_m, const NodeGap& now, const NodeWay& way,
                                 double most) {
  const double distance_m = now.gap_m + way.radii_m;
  const double reach_m = std::max(0.0, distance_m - way_m);
  const double straying_m = most * way.stray_m;
  // a t² + 2 b t + c = 0, and its first root that is not negative
  const double a = way.velocity.squaredNorm() - straying_m * straying_m;
  const double b = distance_m * now.normal.dot(way.velocity) - reach_m * straying_m;
  const double c = (distance_m - reach_m) * (distance_m + reach_m);
  if (!(c > 0.0)) {
    return 0.0;
  }
  const double square = b * b - a * c;
  const double sum = square >= 0.0 ? std::sqrt(square) - b : 0.0;
  return sum > 0.0 ? c / sum : kForever;
}

double NodeWays::time_of_nodes(double way_m, const NodeGap& now, const NodeWay& way, double most) {
  const double closing_m =
      std::max(0.0, -now.normal.dot(way.velocity)) + way.turning_m + most * way.stray_m;
  return closing_m > 0.0 ? way_m / closing_m : kForever;
}

std::uint64_t NodeWays::within(double time, double hair_m, const SphereBlock& block,
                               BlockWays& ways, LaneWidth width) const {
  const TurningSpheres a{block.a, pose_a_.position, stretch_.velocity, spin_a_,
                         0.5 * stretch_.bend_a};
  const TurningSpheres b{block.b, pose_b_.position, Vector3::Zero(), spin_b_,
                         0.5 * stretch_.bend_b};
  const std::uint64_t near = in_lanes(width, NearPairs{block, a, b, time, hair_m, margin_m_, ways});
  return reaches_hold_ ? near : block.all();
}

bool NodeWays::apart_for(double time, double hair_m, const Sphere& a, const Sphere& b,
                         const NodeWay& way) const {
  const Vector3 offset = a.centre - b.centre;
  const double square_m2 = offset.squaredNorm();
  const double away = offset.dot(way.velocity);
  const double speed2 = way.velocity.squaredNorm();
  const double radii_m = a.radius_m + b.radius_m;
  const double reach_m =
      std::max(margin_m_, radii_m + ((margin_m_ - hair_m) + time * time * way.stray_m));
  const double most_m = std::max(radii_m + margin_m_, reach_m);
  const double still_away = away + time * speed2;
  const bool clear_then = square_m2 + time * (away + still_away) > reach_m * reach_m;
  const bool clear_between = square_m2 * speed2 - away * away > reach_m * reach_m * speed2;
  return reaches_hold_ && square_m2 > most_m * most_m &&
         (away >= 0.0 || (still_away < 0.0 && clear_then) || clear_between);
}

}  // namespace impetus::inline collision
