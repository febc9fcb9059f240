// SPDX-License-Identifier: MIT
#include "engine/dynamics/motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/trees/builders/part_shape.hpp"

namespace impetus::inline dynamics {
namespace {

/// The rotation by the Cayley map of `turn` (radians about its own direction, to second order).
Quaternion cayley(const Vector3& turn) {
  return Quaternion(1.0, 0.5 * turn.x(), 0.5 * turn.y(), 0.5 * turn.z()).normalized();
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

/// Radians that L can turn within the body in a step and the iterations converge well.
constexpr double kFar = 0.5;
/// Share of the energy that it is found to again.
constexpr double kRounding = 1e-15;
/// Geometric mean of the turns about the two axes in a part of the step (radians).
constexpr double kPartOfTurn = 0.2;

/// The axes about which a body turns steadily, and how easily.
struct PrincipalAxes {
  Quaternion axes;  ///< right-handed, from them to the body
  Vector3 inverse;  ///< of the principal moments
};

PrincipalAxes principal_axes_of(const Matrix3& inverse_inertia) {
  Matrix3 columns = eigenvectors_of(inverse_inertia);
  if (columns.determinant() < 0.0) {
    columns.col(2) = -columns.col(2);
  }
  PrincipalAxes found{Quaternion(columns), {}};
  const Matrix3 axes = found.axes.toRotationMatrix();
  found.inverse = (axes.transpose() * inverse_inertia * axes).diagonal();
  return found;
}

/// Principal axes that were asked for, by the bits of the inverse inertia: finding them takes as
/// long as the turn, and bodies of one shape ask for the same ones in every step. What is kept
/// decides nothing.
class KnownAxes {
 public:
  PrincipalAxes of(const Matrix3& inverse_inertia) {
    std::array<std::uint64_t, 9> bits;
    std::memcpy(bits.data(), inverse_inertia.data(), sizeof bits);
    Slot& slot = slots_[slot_of(bits)];
    if (!slot.taken || slot.inertia != bits) {
      const PrincipalAxes found = principal_axes_of(inverse_inertia);
      slot.taken = true;
      slot.inertia = bits;
      std::copy_n(found.axes.coeffs().data(), 4, slot.axes.begin());
      std::copy_n(found.inverse.data(), 3, slot.inverse.begin());
    }
    const auto& [x, y, z, w] = slot.axes;
    return {Quaternion(w, x, y, z), {slot.inverse[0], slot.inverse[1], slot.inverse[2]}};
  }

 private:
  static constexpr std::size_t kSlots = 16;

  /// As plain numbers, which a thread begins with for nothing.
  struct Slot {
    bool taken;
    std::array<std::uint64_t, 9> inertia;
    std::array<double, 4> axes;
    std::array<double, 3> inverse;
  };

  static std::size_t slot_of(const std::array<std::uint64_t, 9>& bits) {
    const std::uint64_t diagonal = bits[0] + 3 * bits[4] + 5 * bits[8];
    return static_cast<std::size_t>((diagonal * 0x9e3779b97f4a7c15) >> 60);
  }

  std::array<Slot, kSlots> slots_;
};

thread_local KnownAxes known_axes;

/// About a unit axis; any finite angle.
Quaternion turn_about(const Vector3& axis, double angle_rad) {
  const double half_deg = std::fmod(0.5 * angle_rad * (180.0 / std::numbers::pi), 360.0);
  const SineCosine half = sine_cosine_deg(half_deg);
  return {half.cosine, half.sine * axis.x(), half.sine * axis.y(), half.sine * axis.z()};
}

/// The body as its principal axes see it.
class FarTurn {
 public:
  FarTurn(const BodyModel& model, const BodyState& state, double dt_s)
      : dt_s_(dt_s), momentum_(state.angular_momentum) {
    const PrincipalAxes own = known_axes.of(model.inverse_inertia);
    own_axes_ = own.axes;
    inverse_ = own.inverse;
    turned_ = state.pose.orientation * own_axes_;
    seen_ = turned_.conjugate() * momentum_;
    choose_axes();
  }

  Quaternion run() {
    const double energy = twice_energy();
    const int parts = part_count();
    const double part_s = dt_s_ / parts;
    for (int part = 0; part < parts; ++part) {
      turn(slow_, 0.5 * part_s);
      turn(fast_, part_s);
      turn(slow_, 0.5 * part_s);
    }
    return_to(energy);
    const double size = momentum_.norm();
    const Quaternion about_momentum =
        turn_about(momentum_ / size, size * inverse_[reference_] * dt_s_);
    return (about_momentum * turned_ * own_axes_.conjugate()).normalized();
  }

 private:
  /// The fast axis is the one whose two others are most alike; the first of equals.
  void choose_axes() {
    double least = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double apart = std::abs(inverse_[(axis + 1) % 3] - inverse_[(axis + 2) % 3]);
      if (least < 0.0 || apart < least) {
        least = apart;
        fast_ = axis;
      }
    }
    slow_ = (fast_ + 1) % 3;
    reference_ = (fast_ + 2) % 3;
  }

  [[nodiscard]] double rate(int axis) const { return inverse_[axis] - inverse_[reference_]; }

  [[nodiscard]] double twice_energy() const { return seen_.dot(inverse_.cwiseProduct(seen_)); }

  [[nodiscard]] int part_count() const {
    const double turn = seen_.norm() * dt_s_;
    const double mean = turn * std::sqrt(std::abs(rate(fast_)) * std::abs(rate(slow_)));
    return static_cast<int>(
        std::clamp(std::ceil(mean / kPartOfTurn), 1.0, static_cast<double>(kMostTurnParts)));
  }

  void turn(int axis, double time_s) {
    const Quaternion by = turn_about(Vector3::Unit(axis), rate(axis) * seen_[axis] * time_s);
    seen_ = by.conjugate() * seen_;
    turned_ = turned_ * by;
  }

  /// Moves the momentum on its sphere to the energy that it had, and the body with it.
  void return_to(double energy) {
    const double size = seen_.norm();
    const Vector3 before = seen_ / size;
    go_steepest(energy, size);
    if (std::abs(twice_energy() - energy) > kRounding * energy) {
      go_towards_extreme(energy, size);
    }
    const Vector3 after = seen_ / size;
    const Vector3 axis = after.cross(before);
    turned_ =
        turned_ * Quaternion(1.0 + after.dot(before), axis.x(), axis.y(), axis.z()).normalized();
  }

  /// Newton's steps along the steepest way: a few, unless a saddle is near.
  void go_steepest(double energy, double size) {
    constexpr int kIterations = 12;
    constexpr double kMostStep = 0.2;  // of the sphere's radius
    for (int iteration = 0; iteration < kIterations; ++iteration) {
      const Vector3 along = seen_ / size;
      const Vector3 gradient = 2.0 * inverse_.cwiseProduct(seen_);
      const Vector3 steepest = gradient - gradient.dot(along) * along;
      const double square = steepest.squaredNorm();
      const double excess = twice_energy() - energy;
      if (!(square > 0.0) || std::abs(excess) <= kRounding * energy) {
        break;
      }
      const double slope = std::sqrt(square);
      const double step = std::clamp(excess / slope, -kMostStep * size, kMostStep * size);
      seen_ = (seen_ - step / slope * steepest).normalized() * size;
    }
  }

  /// Halves the arc to the principal axis of the least energy, or of the most: the energy that is
  /// looked for is always on it.
  void go_towards_extreme(double energy, double size) {
    constexpr int kHalvings = 60;
    const bool falls = twice_energy() > energy;
    int extreme = 0;
    static_cast<void>(falls ? inverse_.minCoeff(&extreme) : inverse_.maxCoeff(&extreme));
    const Vector3 from = seen_ / size;
    const Vector3 to =
        from[extreme] < 0.0 ? Vector3(-Vector3::Unit(extreme)) : Vector3::Unit(extreme);
    double near = 0.0;
    double far = 1.0;
    for (int halving = 0; halving < kHalvings; ++halving) {
      const double middle = 0.5 * (near + far);
      seen_ = ((1.0 - middle) * from + middle * to).normalized() * size;
      double& end = (twice_energy() > energy) == falls ? near : far;
      end = middle;
    }
  }

  double dt_s_;
  Quaternion own_axes_;
  Vector3 momentum_;
  Vector3 inverse_{Vector3::Zero()};  ///< of the principal moments
  Quaternion turned_;                 ///< from the principal axes to the world
  Vector3 seen_{Vector3::Zero()};     ///< the momentum as the principal axes see it
  int fast_{0};
  int slow_{1};
  int reference_{2};
};

/// How long a body moved in a step (seconds), and how far its centre went (metres).
struct Way {
  double moving_s;
  double length_m;
};

/// Everything of a step but the turn.
Way go(const BodyModel& model, BodyState& state, double dt_s, const Fall& fall) {
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
  return {moving_s, step.norm()};
}

/// Without inverse inertia (an imposed manipulation) nothing spins, whatever the momentum.
bool turns_in(double moving_s, const BodyModel& model, const BodyState& state) {
  return moving_s > 0.0 && !state.angular_momentum.isZero(0.0) &&
         !model.inverse_inertia.isZero(0.0);
}

}  // namespace

Fall fall_of(const BodyModel& model, const BodyState& state, bool pushed_up,
             const Vector3& gravity_m_s2, double dt_s) {
  const double down = velocity(model, state).dot(gravity_m_s2);
  const double gain = dt_s * gravity_m_s2.squaredNorm();
  Fall fall{gravity_m_s2};
  fall.supported = pushed_up && down + 0.5 * gain > 0.0;
  fall.resting = fall.supported && down <= kRestingSteps * gain;
  return fall;
}

double AdvancingBodies::take(const BodyModel& model, BodyState& state, double dt_s,
                             Rotation rotation, const Fall& fall) {
  const Way way = go(model, state, dt_s, fall);
  if (!turns_in(way.moving_s, model, state)) {
    return way.length_m;
  }
  if (turns_far(model, state, way.moving_s)) {
    state.pose.orientation = turned_far(model, state, way.moving_s);
  } else if (rotation == Rotation::kEnergyKept) {
    state.pose.orientation = rotated_keeping_energy(model, state, way.moving_s);
  } else {
    turning_.put(model, state, way.moving_s);
    if (turning_.is_full()) {
      turning_.turn();
    }
  }
  return way.length_m;
}

double advance(const BodyModel& model, BodyState& state, double dt_s, Rotation rotation,
               const Fall& fall) {
  AdvancingBodies alone;
  const double way_m = alone.take(model, state, dt_s, rotation, fall);
  alone.finish();
  return way_m;
}

Pose between(const BodyState& before, const BodyState& after, double fraction) {
  const double still = after.held_fraction;
  const double moved = still < 1.0 ? std::clamp((fraction - still) / (1.0 - still), 0.0, 1.0) : 0.0;
  const Vector3 position =
      before.pose.position + moved * (after.pose.position - before.pose.position);
  return {position, before.pose.orientation.slerp(moved, after.pose.orientation)};
}

bool turns_far(const BodyModel& model, const BodyState& state, double dt_s) {
  const Matrix3& inverse = model.inverse_inertia;
  const double products =
      std::max({std::abs(inverse(0, 1)), std::abs(inverse(0, 2)), std::abs(inverse(1, 2))});
  const double apart =
      inverse.diagonal().maxCoeff() - inverse.diagonal().minCoeff() + 2.0 * products;
  return dt_s * apart * state.angular_momentum.norm() > kFar;
}

Quaternion turned_far(const BodyModel& model, const BodyState& state, double dt_s) {
  return FarTurn(model, state, dt_s).run();
}

}  // namespace impetus::inline dynamics
