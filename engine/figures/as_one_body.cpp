// SPDX-License-Identifier: MIT
#include "engine/figures/as_one_body.hpp"

#include <algorithm>
#include <cmath>

#include "engine/dynamics/centres_at_walls.hpp"
#include "engine/figures/hinge_solver.hpp"

namespace impetus::inline figures {
namespace {

/// Beyond this an energy cannot be had back by faster internal motion: there is too little of it.
constexpr double kMostGrowth = 1.001;

bool is_fixed(std::span<const BodyModel> parts) { return parts.front().inverse_mass == 0.0; }

double mass_of(std::span<const BodyModel> parts) {
  double mass_kg = 0.0;
  for (const BodyModel& part : parts) {
    mass_kg += 1.0 / part.inverse_mass;
  }
  return mass_kg;
}

/// The velocities that one rigid body in place of the figure would have.
struct RigidMotion {
  double mass{0.0};
  Vector3 centre{Vector3::Zero()};
  Vector3 velocity{Vector3::Zero()};
  Matrix3 inverse_inertia{Matrix3::Zero()};  ///< in world, about the centre
  Vector3 angular_momentum{Vector3::Zero()};
  Vector3 spin{Vector3::Zero()};
};

Matrix3 inertia_in_world(const BodyModel& part, const BodyState& state) {
  const Matrix3 rotation = state.pose.orientation.toRotationMatrix();
  return rotation * part.inverse_inertia.inverse() * rotation.transpose();
}

/// Of a figure that is free to go; one that is fixed does not move as a whole.
RigidMotion rigid_motion_of(std::span<const BodyModel> parts, std::span<const BodyState> states) {
  RigidMotion motion;
  if (is_fixed(parts)) {
    return motion;
  }
  Vector3 momentum = Vector3::Zero();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double own = 1.0 / parts[i].inverse_mass;
    motion.mass += own;
    motion.centre += own * states[i].pose.position;
    momentum += states[i].linear_momentum;
  }
  motion.centre /= motion.mass;
  motion.velocity = momentum / motion.mass;
  Matrix3 inertia = Matrix3::Zero();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Vector3 arm = states[i].pose.position - motion.centre;
    inertia += inertia_in_world(parts[i], states[i]) +
               1.0 / parts[i].inverse_mass *
                   (arm.squaredNorm() * Matrix3::Identity() - arm * arm.transpose());
    motion.angular_momentum += states[i].angular_momentum + arm.cross(states[i].linear_momentum);
  }
  motion.inverse_inertia = inertia.inverse();
  motion.spin = motion.inverse_inertia * motion.angular_momentum;
  return motion;
}

/// Momenta of a part beyond those of the rigid motion.
PartImpulse internal_momentum(const RigidMotion& rigid, const BodyModel& part,
                              const BodyState& state) {
  const Vector3 arm = state.pose.position - rigid.centre;
  const Vector3 velocity = rigid.velocity + rigid.spin.cross(arm);
  return {state.linear_momentum - velocity / part.inverse_mass,
          state.angular_momentum - inertia_in_world(part, state) * rigid.spin};
}

/// The body that the figure is as long as it keeps its posture, in the world's frame.
BodyModel body_of(const RigidMotion& whole) {
  BodyModel body;
  body.inverse_mass = 1.0 / whole.mass;
  body.inverse_inertia = whole.inverse_inertia;
  return body;
}

/// How it falls: by what its parts get together, and held where any of them is.
Fall fall_of_whole(const BodyModel& body, const BodyState& state, double dt_s,
                   std::span<const BodyModel> parts, std::span<const Fall> falls) {
  Vector3 gravity_m_s2 = Vector3::Zero();
  bool any_supported = false;
  for (std::size_t i = 0; i < falls.size(); ++i) {
    gravity_m_s2 += body.inverse_mass / parts[i].inverse_mass * falls[i].gravity_m_s2;
    any_supported = any_supported || falls[i].supported;
  }
  return fall_of(body, state, any_supported, gravity_m_s2, dt_s);
}

/// How far any centre is beyond a wall (metres), but of parts that pass through.
double farthest_beyond_m(const Enclosure& enclosure, int wall, std::span<const BodyModel> parts,
                         std::span<const BodyState> states) {
  double beyond_m = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts[i].passes_through) {
      beyond_m = std::max(beyond_m, centre_beyond_m(enclosure, wall, states[i].pose.position));
    }
  }
  return beyond_m;
}

/// Moves a figure by `way_m`, or by the part of it that its kinetic energy lifts it by.
void move_paid_for(const Vector3& way_m, const Vector3& gravity_m_s2,
                   std::span<const BodyModel> parts, std::span<BodyState> states) {
  const double cost_J = mass_of(parts) * std::max(0.0, -gravity_m_s2.dot(way_m));
  const double kinetic_J = kinetic_energy(parts, states);
  const double paid_J = std::min(cost_J, kinetic_J);
  const double share = cost_J > 0.0 ? paid_J / cost_J : 1.0;
  const double slower = paid_J > 0.0 ? std::sqrt(1.0 - paid_J / kinetic_J) : 1.0;
  for (BodyState& state : states) {
    state.pose.position += share * way_m;
    state.linear_momentum *= slower;
    state.angular_momentum *= slower;
  }
}

}  // namespace

double kinetic_energy(std::span<const BodyModel> parts, std::span<const BodyState> states) {
  double energy = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    energy += kinetic_energy(parts[i], states[i]);
  }
  return energy;
}

double energy_of_centre(std::span<const BodyModel> parts, std::span<const BodyState> states) {
  if (is_fixed(parts)) {
    return 0.0;
  }
  Vector3 momentum = Vector3::Zero();
  for (const BodyState& state : states) {
    momentum += state.linear_momentum;
  }
  return 0.5 * momentum.squaredNorm() / mass_of(parts);
}

void bring_to_energy(double energy_J, bool may_grow, std::span<const BodyModel> parts,
                     std::span<BodyState> states) {
  const double present_J = kinetic_energy(parts, states);
  if (present_J == energy_J || (present_J < energy_J && !may_grow)) {
    return;
  }
  const RigidMotion rigid = rigid_motion_of(parts, states);
  double internal_J = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].inverse_mass > 0.0) {
      BodyState internal = states[i];
      const PartImpulse own = internal_momentum(rigid, parts[i], states[i]);
      internal.linear_momentum = own.linear;
      internal.angular_momentum = own.angular;
      internal_J += kinetic_energy(parts[i], internal);
    }
  }
  const double wanted_J = internal_J + (energy_J - present_J);
  if (!(internal_J > 0.0)) {
    return;
  }
  const double times = std::min(kMostGrowth, std::sqrt(std::max(0.0, wanted_J / internal_J)));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].inverse_mass > 0.0) {
      const PartImpulse own = internal_momentum(rigid, parts[i], states[i]);
      states[i].linear_momentum += (times - 1.0) * own.linear;
      states[i].angular_momentum += (times - 1.0) * own.angular;
    }
  }
}

void move_as_one_body(double dt_s, std::span<const BodyModel> parts, std::span<const Fall> falls,
                      std::span<BodyState> states) {
  if (is_fixed(parts)) {
    return;
  }
  const RigidMotion whole = rigid_motion_of(parts, states);
  const BodyModel body = body_of(whole);
  BodyState moved;
  moved.pose.position = whole.centre;
  moved.linear_momentum = whole.mass * whole.velocity;
  moved.angular_momentum = whole.angular_momentum;
  const Fall fall = fall_of_whole(body, moved, dt_s, parts, falls);
  advance(body, moved, dt_s, Rotation::kEnergyKept, fall);
  const Quaternion& turn = moved.pose.orientation;
  const Vector3 velocity = body.inverse_mass * moved.linear_momentum;
  const Vector3 spin = whole.inverse_inertia * (turn.conjugate() * whole.angular_momentum);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    BodyState& state = states[i];
    const double mass = 1.0 / parts[i].inverse_mass;
    const Vector3 arm = state.pose.position - whole.centre;
    const Matrix3 inertia = inertia_in_world(parts[i], state);
    PartImpulse momentum{mass * spin.cross(arm), inertia * spin};  // turned with the figure
    if (!fall.supported) {
      momentum.linear += state.linear_momentum - mass * (whole.velocity + whole.spin.cross(arm));
      momentum.angular += state.angular_momentum - inertia * whole.spin;
    }
    state.pose.position = moved.pose.position + turn * arm;
    state.pose.orientation = (turn * state.pose.orientation).normalized();
    state.linear_momentum = mass * velocity + turn * momentum.linear;
    state.angular_momentum = turn * momentum.angular;
  }
}

void move_back_inside(const Enclosure& enclosure, const Vector3& gravity_m_s2,
                      std::span<const BodyModel> parts, std::span<BodyState> states) {
  constexpr int kMostRounds = 8;  // from a slanted wall back may be through another
  bool moved = !is_fixed(parts);
  for (int round = 0; moved && round < kMostRounds; ++round) {
    moved = false;
    for (int wall = 0; wall < kWallCount; ++wall) {
      const double beyond_m = farthest_beyond_m(enclosure, wall, parts, states);
      if (beyond_m > 0.0) {
        move_paid_for(beyond_m * inward_normal(enclosure, wall), gravity_m_s2, parts, states);
        moved = true;
      }
    }
  }
}

}  // namespace impetus::inline figures
