// SPDX-License-Identifier: MIT
#include "engine/figures/as_one_body.hpp"

#include <algorithm>
#include <cmath>

#include "engine/figures/hinge_solver.hpp"

namespace impetus::inline figures {
namespace {

/// Beyond this an energy cannot be had back by faster internal motion: there is too little of it.
constexpr double kMostGrowth = 1.001;

bool is_fixed(std::span<const BodyModel> parts) { return parts.front().inverse_mass == 0.0; }

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

/// Those that a part has in the rigid motion.
PartImpulse rigid_momenta(const RigidMotion& rigid, const BodyModel& part, const BodyState& state) {
  const Vector3 arm = state.pose.position - rigid.centre;
  const Vector3 velocity = rigid.velocity + rigid.spin.cross(arm);
  return {velocity / part.inverse_mass, inertia_in_world(part, state) * rigid.spin};
}

/// Those beyond the rigid motion.
PartImpulse internal_momenta(const RigidMotion& rigid, const BodyModel& part,
                             const BodyState& state) {
  const PartImpulse own = rigid_momenta(rigid, part, state);
  return {state.linear_momentum - own.linear, state.angular_momentum - own.angular};
}

/// What gravity gives to the whole in a step: to its velocity, and to the way of its centre.
struct WholeFall {
  Vector3 velocity{Vector3::Zero()};
  Vector3 way{Vector3::Zero()};
};

WholeFall whole_fall(double dt_s, double mass, std::span<const BodyModel> parts,
                     std::span<const Fall> falls) {
  WholeFall whole;
  for (std::size_t i = 0; i < falls.size(); ++i) {
    const Vector3 velocity = dt_s / (parts[i].inverse_mass * mass) * falls[i].gravity_m_s2;
    whole.velocity += velocity;
    whole.way += falls[i].supported ? Vector3::Zero() : Vector3(0.5 * dt_s * velocity);
  }
  return whole;
}

/// By how much the whole turns in a step.
Quaternion turn_of(const RigidMotion& rigid, double dt_s) {
  BodyModel whole;
  whole.inverse_mass = 1.0 / rigid.mass;
  whole.inverse_inertia = rigid.inverse_inertia;
  BodyState state;
  state.angular_momentum = rigid.angular_momentum;
  advance(whole, state, dt_s, Rotation::kEnergyKept);
  return state.pose.orientation;
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
  double mass = 0.0;
  Vector3 momentum = Vector3::Zero();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    mass += 1.0 / parts[i].inverse_mass;
    momentum += states[i].linear_momentum;
  }
  return 0.5 * momentum.squaredNorm() / mass;
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
      const PartImpulse own = internal_momenta(rigid, parts[i], states[i]);
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
      const PartImpulse own = internal_momenta(rigid, parts[i], states[i]);
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
  const RigidMotion before = rigid_motion_of(parts, states);
  const WholeFall fall = whole_fall(dt_s, before.mass, parts, falls);
  const Quaternion turn = turn_of(before, dt_s);
  RigidMotion after = before;
  after.centre += dt_s * before.velocity + fall.way;
  after.velocity += fall.velocity;
  const Matrix3 turned = turn.toRotationMatrix();
  after.spin = turned * before.inverse_inertia * turned.transpose() * before.angular_momentum;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    BodyState& state = states[i];
    const PartImpulse internal = internal_momenta(before, parts[i], state);
    state.pose.position = after.centre + turn * Vector3(state.pose.position - before.centre);
    state.pose.orientation = (turn * state.pose.orientation).normalized();
    const PartImpulse rigid = rigid_momenta(after, parts[i], state);
    state.linear_momentum = rigid.linear + turn * internal.linear;
    state.angular_momentum = rigid.angular + turn * internal.angular;
  }
}

}  // namespace impetus::inline figures
