// SPDX-License-Identifier: MIT
#include "engine/collision/entry/near_nodes.hpp"

#include <cmath>
#include <optional>

#include "engine/volumes/core_contact.hpp"
#include "engine/volumes/core_distance.hpp"

namespace impetus::inline collision {
namespace {

bool reach_holds(const Pose& pose, double reach_m) {
  constexpr double kFar = 1e5;
  constexpr double kStretch = 1e-11;
  return pose.position.allFinite() && pose.position.cwiseAbs().maxCoeff() <= kFar * reach_m &&
         std::abs(pose.orientation.squaredNorm() - 1.0) <= kStretch;
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
  speed_m_ = stretch.velocity.norm();
  fastest_m_ = stretch.fastest(reach_a_m, reach_b_m);
  reach_a_m_ = reach_a_m;
  reach_b_m_ = reach_b_m;
}

void NearSpheres::place(const Pose& a, const Pose& b) {
  reaches_hold_ =
      std::isfinite(fastest_m_) && reach_holds(a, reach_a_m_) && reach_holds(b, reach_b_m_);
}

std::uint64_t NearSpheres::within(double time, double hair_m, const SphereBlock& block,
                                  const LaneValues& turning_a, const LaneValues& turning_b) const {
  if (!reaches_hold_) {
    return block.all();
  }
  const double wider_m = std::max(0.0, time * speed_m_ - hair_m) + margin_m(time);
  LaneValues reach_a{};
  LaneValues reach_b{};
  for (int row = 0; row < block.rows; ++row) {
    reach_a[lane(row)] = block.a.radius_m[row] + time * turning_a[lane(row)];
  }
  for (int column = 0; column < block.columns; ++column) {
    reach_b[lane(column)] = block.b.radius_m[column] + (time * turning_b[lane(column)] + wider_m);
  }
  return overlaps_of_block({block.a.x, block.a.y, block.a.z, reach_a.data()}, block.rows,
                           {block.b.x, block.b.y, block.b.z, reach_b.data()}, block.columns);
}

}  // namespace impetus::inline collision
