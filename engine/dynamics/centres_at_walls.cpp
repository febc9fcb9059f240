// SPDX-License-Identifier: MIT
#include "engine/dynamics/centres_at_walls.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline dynamics {
namespace {

/// Of walls that are not square to each other, one after the other: in an edge of 70° a round
/// leaves a tenth.
constexpr int kRounds = 9;

double centre_beyond_m(const Enclosure& enclosure, int wall, const Vector3& centre_m) {
  return reach_beyond(enclosure, wall, Sphere{centre_m, 0.0});
}

/// Puts the centre back to the wall from `beyond_m` behind it. On its parabola it had the energy of
/// now at the wall, too.
void end_way_at_wall(const Vector3& outward, double beyond_m, const Vector3& gravity_m_s2,
                     const BodyModel& model, BodyState& state) {
  state.pose.position -= beyond_m * outward;
  const double speed_m_s = model.inverse_mass * outward.dot(state.linear_momentum);
  if (speed_m_s > 0.0) {
    const double square = speed_m_s * speed_m_s - 2.0 * beyond_m * outward.dot(gravity_m_s2);
    const double at_wall_m_s = std::sqrt(std::max(0.0, square));
    state.linear_momentum += (at_wall_m_s - speed_m_s) / model.inverse_mass * outward;
  }
}

}  // namespace

double wall_rounding_m(const BodyModel& model) {
  constexpr double kRounding = 1e-9;
  return kRounding * model.tree->bounding_radius_m();
}

void keep_centre_inside(const Enclosure& enclosure, const Vector3& gravity_m_s2,
                        const BodyModel& model, const Vector3& from_m, BodyState& state) {
  if (model.passes_through || !(model.inverse_mass > 0.0)) {
    return;
  }
  bool is_inside = false;
  for (int round = 0; round < kRounds && !is_inside; ++round) {
    is_inside = true;
    for (int wall = 0; wall < kWallCount; ++wall) {
      const double beyond_m = centre_beyond_m(enclosure, wall, state.pose.position);
      if (beyond_m > 0.0 && centre_beyond_m(enclosure, wall, from_m) <= wall_rounding_m(model)) {
        end_way_at_wall(-inward_normal(enclosure, wall), beyond_m, gravity_m_s2, model, state);
        is_inside = false;
      }
    }
  }
}

void turn_back_at_walls(const Enclosure& enclosure, double least_m, double restitution,
                        double resting_m_s, const BodyModel& model, BodyState& state) {
  for (int wall = 0; wall < kWallCount; ++wall) {
    const Vector3 outward = -inward_normal(enclosure, wall);
    const double outward_Ns = outward.dot(state.linear_momentum);
    if (outward_Ns > 0.0 && centre_beyond_m(enclosure, wall, state.pose.position) > least_m) {
      const double given_back = outward_Ns * model.inverse_mass > resting_m_s ? restitution : 0.0;
      state.linear_momentum -= (1.0 + given_back) * outward_Ns * outward;
    }
  }
}

void stop_at_walls(const Enclosure& enclosure, const Vector3& gravity_m_s2, double dt_s,
                   const BodyModel& model, BodyState& state) {
  for (int wall = 0; wall < kWallCount; ++wall) {
    const double room_m = -centre_beyond_m(enclosure, wall, state.pose.position);
    const Vector3 outward = -inward_normal(enclosure, wall);
    if (room_m < 0.0) {
      state.pose.position += room_m * outward;
    }
    const double outward_Ns = outward.dot(state.linear_momentum);
    const double fall_m = std::max(0.0, 0.5 * outward.dot(gravity_m_s2) * dt_s * dt_s);
    const double allowed_Ns = std::max(0.0, room_m - fall_m) / (dt_s * model.inverse_mass);
    if (outward_Ns > allowed_Ns) {
      state.linear_momentum -= (outward_Ns - allowed_Ns) * outward;
    }
  }
}

}  // namespace impetus::inline dynamics
