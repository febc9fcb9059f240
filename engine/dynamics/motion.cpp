// SPDX-License-Identifier: MIT
#include "engine/dynamics/motion.hpp"

#include <algorithm>

#include "engine/dynamics/far_turn.hpp"

namespace impetus::inline dynamics {
namespace {

Quaternion sum_normalised(const Quaternion& p, const Quaternion& q) {
  return Quaternion(Eigen::Vector4d(p.coeffs() + q.coeffs())).normalized();
}

/// The rotation by the Cayley map of `turn` (radians about its own direction, to second order).
Quaternion cayley(const Vector3& turn) {
  return Quaternion(1.0, 0.5 * turn.x(), 0.5 * turn.y(), 0.5 * turn.z()).normalized();
}

/// Implicit midpoint: ω = R_mid I⁻¹ R_midᵀ L with R_mid half way between the old and new rotation.
Quaternion rotated(const BodyModel& model, const BodyState& state, double dt_s) {
  constexpr int kIterations = 4;
  const Quaternion start = state.pose.orientation;
  Quaternion middle = start;
  Quaternion end = start;
  for (int iteration = 0; iteration <= kIterations; ++iteration) {
    const Matrix3 rotation = middle.toRotationMatrix();
    const Vector3 spin =
        rotation * (model.inverse_inertia * Vector3(rotation.transpose() * state.angular_momentum));
    end = (cayley(spin * dt_s) * start).normalized();
    middle = sum_normalised(start, end);
  }
  return end;
}

/// The momentum as the body sees it turns against it: Π' = C(−ω dt) Π with ω = I⁻¹ (Π + Π') / 2, in
/// the body's frame. The Cayley map makes Π' − Π a vector across ω, and twice the gain of energy is
/// Π'·I⁻¹Π' − Π·I⁻¹Π = 2 ω·(Π' − Π) = 0.
Quaternion rotated_keeping_energy(const BodyModel& model, const BodyState& state, double dt_s) {
  constexpr int kIterations = 16;
  const Quaternion& start = state.pose.orientation;
  const Vector3 before = start.conjugate() * state.angular_momentum;
  Vector3 after = before;
  Vector3 spin = Vector3::Zero();
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    spin = model.inverse_inertia * Vector3(0.5 * (before + after));
    after = cayley(-dt_s * spin) * before;
  }
  return (start * cayley(dt_s * spin)).normalized();
}

/// The way of a step of `dt_s` seconds, which is `step` without gravity.
Vector3 with_fall(const Vector3& step, double dt_s, const Fall& fall) {
  const Vector3& gravity = fall.gravity_m_s2;
  if (!fall.supported) {
    return step + 0.5 * dt_s * dt_s * gravity;
  }
  const double down = step.dot(gravity);
  return fall.resting && down > 0.0 ? Vector3(step - down / gravity.squaredNorm() * gravity) : step;
}

}  // namespace

Fall fall_of(const BodyModel& model, const BodyState& state, bool touched,
             const Vector3& gravity_m_s2, double dt_s) {
  const double down = velocity(model, state).dot(gravity_m_s2);
  const double gain = dt_s * gravity_m_s2.squaredNorm();
  Fall fall{gravity_m_s2};
  fall.supported = touched && down + 0.5 * gain > 0.0;
  fall.resting = fall.supported && down <= kRestingSteps * gain;
  return fall;
}

double advance(const BodyModel& model, BodyState& state, double dt_s, Rotation rotation,
               const Fall& fall) {
  const double waiting_s = std::min(state.held_s, dt_s);
  const double moving_s = dt_s - waiting_s;
  state.held_s -= waiting_s;
  state.held_fraction = dt_s > 0.0 ? waiting_s / dt_s : 0.0;

  Vector3 step = moving_s * velocity(model, state);
  if (model.inverse_mass > 0.0 && !fall.gravity_m_s2.isZero(0.0)) {
    step = with_fall(step, moving_s, fall);
    state.linear_momentum += moving_s / model.inverse_mass * fall.gravity_m_s2;
  }
  state.pose.position += step;
  // Without inverse inertia (an imposed manipulation) nothing spins, whatever the momentum.
  if (moving_s > 0.0 && !state.angular_momentum.isZero(0.0) && !model.inverse_inertia.isZero(0.0)) {
    state.pose.orientation = turns_far(model, state, moving_s) ? turned_far(model, state, moving_s)
                             : rotation == Rotation::kMidpoint
                                 ? rotated(model, state, moving_s)
                                 : rotated_keeping_energy(model, state, moving_s);
  }
  return step.norm();
}

Pose between(const BodyState& before, const BodyState& after, double fraction) {
  const double still = after.held_fraction;
  const double moved = still < 1.0 ? std::clamp((fraction - still) / (1.0 - still), 0.0, 1.0) : 0.0;
  const Vector3 position =
      before.pose.position + moved * (after.pose.position - before.pose.position);
  return {position, before.pose.orientation.slerp(moved, after.pose.orientation)};
}

}  // namespace impetus::inline dynamics
