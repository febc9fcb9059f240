// A rigid body: what never changes about it, and its state.
//
// The state keeps momenta, not velocities, so that free motion conserves both exactly.
// (Dingliana 2002, eq. 2.1: P is linear, L is angular)
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "engine/shapes/mass_properties.hpp"
#include "engine/trees/volume_tree.hpp"

namespace impetus::inline dynamics {

/// Constant through a trial. An inverse mass of zero means that nothing moves or turns the body,
/// whatever its momenta; an inverse inertia of zero that nothing turns it, an imposed manipulation.
struct BodyModel {
  std::string name;
  std::shared_ptr<const VolumeTree> tree;    ///< in the body's frame, from the centre of mass
  double inverse_mass{0.0};                  ///< 1/kg
  Matrix3 inverse_inertia{Matrix3::Zero()};  ///< 1/(kg m²), body frame
  int material{0};                           ///< a number that restitutions are stated for
  bool passes_through{false};                ///< touches nothing, neither bodies nor walls
};

/// Changes from step to step. The first four fields are what the state hash covers.
struct BodyState {
  Pose pose;
  Vector3 linear_momentum{Vector3::Zero()};   ///< kg m/s
  Vector3 angular_momentum{Vector3::Zero()};  ///< kg m²/s, about the centre of mass, in world

  double held_s{0.0};         ///< time that an imposed hold still keeps it where it is
  double held_fraction{0.0};  ///< share of the last step it was held, for drawing between steps
};

/// World inverse inertia R I⁻¹ Rᵀ.
Matrix3 world_inverse_inertia(const BodyModel& model, const BodyState& state);

Vector3 velocity(const BodyModel& model, const BodyState& state);          ///< m/s
Vector3 angular_velocity(const BodyModel& model, const BodyState& state);  ///< rad/s, in world

/// The angular momentum at which a body so oriented turns at `spin` (rad/s, world); zero when
/// nothing turns it.
Vector3 angular_momentum_at(const BodyModel& model, const Quaternion& orientation,
                            const Vector3& spin);
double kinetic_energy(const BodyModel& model, const BodyState& state);  ///< J

}  // namespace impetus::inline dynamics
