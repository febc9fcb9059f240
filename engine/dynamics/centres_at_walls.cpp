// SPDX-License-Identifier: MIT
#include "engine/dynamics/centres_at_walls.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline dynamics {
namespace {

/// Of the straight way to `to_m`, how much is within the walls that it began within.
double share_inside(const Enclosure& enclosure, double rounding_m, const Vector3& from_m,
                    const Vector3& to_m) {
  double share = 1.0;
  for (int wall = 0; wall < kWallCount; ++wall) {
    const double before_m = centre_beyond_m(enclosure, wall, from_m);
    const double after_m = centre_beyond_m(enclosure, wall, to_m);
    if (after_m > 0.0 && before_m <= rounding_m) {
      const double room_m = std::max(0.0, -before_m);
      share = std::min(share, room_m / (room_m + after_m));
    }
  }
  return share;
}

/// What a momentum becomes where the body is not moved by `left_m` along gravity: as on its
/// parabola the speed is less by what it would have gained.
Vector3 without_fall(const Vector3& momentum, const Vector3& left_m, const Vector3& gravity_m_s2,
                     double inverse_mass) {
  const double gravity = gravity_m_s2.norm();
  if (!(gravity > 0.0)) {
    return momentum;
  }
  const Vector3 down = gravity_m_s2 / gravity;
  const double speed_m_s = inverse_mass * down.dot(momentum);
  const double square = speed_m_s * speed_m_s - 2.0 * gravity * down.dot(left_m);
  const double there_m_s = std::copysign(std::sqrt(std::max(0.0, square)), speed_m_s);
  return momentum + (there_m_s - speed_m_s) / inverse_mass * down;
}

}  // namespace

double centre_beyond_m(const Enclosure& enclosure, int wall, const Vector3& centre_m) {
  return reach_beyond(enclosure, wall, Sphere{centre_m, 0.0});
}

double wall_rounding_m(const BodyModel& model) {
  constexpr double kRounding = 1e-9;
  return kRounding * model.tree->bounding_radius_m();
}

void keep_centre_inside(const Enclosure& enclosure, const Vector3& gravity_m_s2,
                        const BodyModel& model, const Vector3& from_m, BodyState& state) {
  if (model.passes_through || !(model.inverse_mass > 0.0)) {
    return;
  }
  const double share = share_inside(enclosure, wall_rounding_m(model), from_m, state.pose.position);
  if (share < 1.0) {
    const Vector3 left_m = (1.0 - share) * (state.pose.position - from_m);
    state.pose.position -= left_m;
    state.linear_momentum =
        without_fall(state.linear_momentum, left_m, gravity_m_s2, model.inverse_mass);
  }
}

void turn_back_at_walls(const Enclosure& enclosure, double least_m, double restitution,
                        double resting_m_s, const BodyModel& model, BodyState& state) {
  for (int wall = 0; wall < kWallCount; ++wall) {
    if (!(centre_beyond_m(enclosure, wall, state.pose.position) > least_m)) {
      continue;
    }
    const Vector3 outward = -inward_normal(enclosure, wall);
    const double outward_Ns = outward.dot(state.linear_momentum);
    if (outward_Ns > 0.0) {
      const double given_back = outward_Ns * model.inverse_mass > resting_m_s ? restitution : 0.0;
      state.linear_momentum -= (1.0 + given_back) * outward_Ns * outward;
    }
  }
}

void stop_at_walls(const Enclosure& enclosure, const Vector3& gravity_m_s2, double dt_s,
                   bool brings_back, const BodyModel& model, BodyState& state) {
  for (int wall = 0; wall < kWallCount; ++wall) {
    const double room_m = -centre_beyond_m(enclosure, wall, state.pose.position);
    const Vector3 outward = -inward_normal(enclosure, wall);
    if (brings_back && room_m < 0.0) {
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
