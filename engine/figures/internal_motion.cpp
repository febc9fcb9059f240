// SPDX-License-Identifier: MIT
#include "engine/figures/internal_motion.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline figures {
namespace {

/// Beyond this an energy cannot be had back by faster internal motion: there is too little of it.
constexpr double kMostGrowth = 1.001;

/// The velocities that one rigid body in place of the figure would have.
struct RigidMotion {
  Vector3 centre{Vector3::Zero()};
  Vector3 velocity{Vector3::Zero()};
  Vector3 spin{Vector3::Zero()};
};

Matrix3 inertia_in_world(const BodyModel& part, const BodyState& state) {
  const Matrix3 rotation = state.pose.orientation.toRotationMatrix();
  return rotation * part.inverse_inertia.inverse() * rotation.transpose();
}

/// Of a figure that is free to go; one whose root is fixed does not move as a whole.
RigidMotion rigid_motion_of(std::span<const BodyModel> parts, std::span<const BodyState> states) {
  RigidMotion motion;
  if (parts.front().inverse_mass == 0.0) {
    return motion;
  }
  double mass = 0.0;
  Vector3 momentum = Vector3::Zero();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double own = 1.0 / parts[i].inverse_mass;
    mass += own;
    motion.centre += own * states[i].pose.position;
    momentum += states[i].linear_momentum;
  }
  motion.centre /= mass;
  motion.velocity = momentum / mass;
  Matrix3 inertia = Matrix3::Zero();
  Vector3 angular = Vector3::Zero();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Vector3 arm = states[i].pose.position - motion.centre;
    inertia += inertia_in_world(parts[i], states[i]) +
               1.0 / parts[i].inverse_mass *
                   (arm.squaredNorm() * Matrix3::Identity() - arm * arm.transpose());
    angular += states[i].angular_momentum + arm.cross(states[i].linear_momentum);
  }
  motion.spin = inertia.inverse() * angular;
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

}  // namespace

double kinetic_energy(std::span<const BodyModel> parts, std::span<const BodyState> states) {
  double energy = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    energy += kinetic_energy(parts[i], states[i]);
  }
  return energy;
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

}  // namespace impetus::inline figures
