// SPDX-License-Identifier: MIT
#include "engine/dynamics/body.hpp"

namespace impetus::inline dynamics {

Matrix3 world_inverse_inertia(const BodyModel& model, const BodyState& state) {
  const Matrix3 rotation = state.pose.orientation.toRotationMatrix();
  return rotation * model.inverse_inertia * rotation.transpose();
}

Vector3 velocity(const BodyModel& model, const BodyState& state) {
  return model.inverse_mass * state.linear_momentum;
}

Vector3 angular_velocity(const BodyModel& model, const BodyState& state) {
  return world_inverse_inertia(model, state) * state.angular_momentum;
}

Vector3 angular_momentum_at(const BodyModel& model, const Quaternion& orientation,
                            const Vector3& spin) {
  if (model.inverse_inertia.isZero(0.0)) {
    return Vector3::Zero();
  }
  const Vector3 in_body = orientation.conjugate() * spin;
  Matrix3 inertia = model.inverse_inertia.inverse();
  if (!inertia.allFinite()) {
    // What cannot turn about some axis has no momentum about it.
    inertia = model.inverse_inertia.completeOrthogonalDecomposition().pseudoInverse();
  }
  return orientation * Vector3(inertia * in_body);
}

double kinetic_energy(const BodyModel& model, const BodyState& state) {
  return 0.5 * (state.linear_momentum.dot(velocity(model, state)) +
                state.angular_momentum.dot(angular_velocity(model, state)));
}

}  // namespace impetus::inline dynamics
