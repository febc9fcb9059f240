// SPDX-License-Identifier: MIT
#include "engine/figures/figure_motion.hpp"

#include <algorithm>
#include <cmath>

#include "engine/dynamics/motion.hpp"
#include "engine/numerics/at.hpp"

namespace impetus::inline figures {
namespace {

// How a figure moves beyond what it would as one rigid body, and the energy in it.
//
//   momenta  =  those of a rigid body with the figure's whole momentum  +  internal ones
//
// The internal momenta sum to nothing, linear and angular, and the two energies add up: so the
// internal motion can be made slower or faster without touching the figure's momentum or pulling
// at its hinges.

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

/// The kinetic energy of a figure's parts (J).
double kinetic_energy(std::span<const BodyModel> parts, std::span<const BodyState> states) {
  double energy = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    energy += kinetic_energy(parts[i], states[i]);
  }
  return energy;
}

/// Makes the internal motion such that the kinetic energy is `energy_J`, as far as that can be: at
/// least that of the rigid motion. It grows only where `may_grow`, and by a thousandth at the most.
/// A part without inverse mass, if any, is the root, and nothing is rigid motion then.
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

/// Of the beginning impulses, at most; and those that are made whatever work is granted.
constexpr int kMostIterations = 24;
constexpr int kLeastIterations = 2;

/// By how much the child's anchor and axis miss the parent's: in world (metres), and across the
/// axis (radians).
Vector5 mismatch_of(const Hinge& hinge, const Pose& child, const Pose& parent) {
  const Vector3 apart =
      child.transform(hinge.of_child.anchor) - parent.transform(hinge.of_parent.anchor);
  const Vector3 axis = parent.orientation * hinge.of_parent.axis;
  const Vector3 turned = axis.cross(child.orientation * hinge.of_child.axis);
  const Vector3 across = parent.orientation * hinge.of_parent.zero;
  Vector5 mismatch;
  mismatch << apart, across.dot(turned), axis.cross(across).dot(turned);
  return mismatch;
}

double work_of_gravity(std::span<const BodyModel> parts, std::span<const Fall> falls,
                       std::span<const BodyState> before, std::span<const BodyState> after) {
  double work_J = 0.0;
  for (std::size_t i = 0; i < falls.size(); ++i) {
    if (parts[i].inverse_mass > 0.0) {
      const Vector3 way = after[i].pose.position - before[i].pose.position;
      work_J += falls[i].gravity_m_s2.dot(way) / parts[i].inverse_mass;
    }
  }
  return work_J;
}

bool any_supported(std::span<const Fall> falls) {
  return std::any_of(falls.begin(), falls.end(), [](const Fall& fall) { return fall.supported; });
}

/// Whether a part turns so far that where it arrives does not depend smoothly enough on impulses:
/// none is near to being turned in another way (turned_far()), where the iteration would jump.
bool any_turns_far(std::span<const BodyModel> parts, std::span<const BodyState> states,
                   double dt_s) {
  constexpr double kMargin = 2.0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (angular_velocity(parts[i], states[i]).norm() * dt_s > kTurnPart ||
        turns_far(parts[i], states[i], kMargin * dt_s)) {
      return true;
    }
  }
  return false;
}

int motion_parts_of(std::span<const BodyModel> parts, std::span<const BodyState> states,
                    double dt_s) {
  int count = 1;
  while (count < kMostMotionParts && any_turns_far(parts, states, dt_s / count)) {
    count *= 2;
  }
  return count;
}

/// The fall in one of the `count` parts of a step. What rests is held by its contacts alone: what
/// keeps a body where it is would tear at its hinges.
Fall fall_in(int part, int count, Fall fall) {
  fall.resting = false;
  if (fall.comes_last) {
    fall.gravity_m_s2 *= part == count - 1 ? count : 0.0;
  }
  return fall;
}

}  // namespace

FigureMotion::FigureMotion(const Figure& figure, const std::vector<BodyModel>& models)
    : solver_(figure, models),
      middle_(figure, models),
      size_m_(top_bound_m(figure, models)),
      impulses_(at(figure.part_count)),
      asked_(figure.hinges.size(), Vector5::Zero()) {}

void FigureMotion::advance(const Figure& figure, const std::vector<BodyModel>& models, double dt_s,
                           Rotation rotation, std::span<const Fall> falls, PhaseWork& work,
                           std::vector<BodyState>& states) {
  const std::size_t first = at(figure.first_part);
  const std::size_t count = at(figure.part_count);
  const Parts parts{figure, std::span(models).subspan(first, count),
                    falls.empty() ? falls : falls.subspan(first, count), rotation,
                    std::span(states).subspan(first, count)};
  int motion_parts = motion_parts_of(parts.models, parts.states, dt_s);
  while (motion_parts > 1 &&
         !work.spend(std::int64_t{figure.part_count} * (motion_parts - 1) * kLeastIterations)) {
    motion_parts /= 2;
  }
  for (int i = 0; i < motion_parts; ++i) {
    falls_.clear();
    for (const Fall& fall : parts.falls) {
      falls_.push_back(fall_in(i, motion_parts, fall));
    }
    advance_part(parts, dt_s / motion_parts, work);
  }
}

void FigureMotion::advance_part(const Parts& parts, double dt_s, PhaseWork& work) {
  start_.assign(parts.states.begin(), parts.states.end());
  const double before_J = kinetic_energy(parts.models, parts.states);
  solver_.look_at(parts.states);
  arrive_together(parts, dt_s, work);
  stop_across_hinges(parts.states);
  bring_to_energy(before_J + work_of_gravity(parts.models, parts.falls, start_, parts.states),
                  /*may_grow=*/!any_supported(parts.falls), parts.models, parts.states);
}

void FigureMotion::arrive_together(const Parts& parts, double dt_s, PhaseWork& work) {
  std::fill(impulses_.begin(), impulses_.end(), PartImpulse{});
  double error = arrive(parts, dt_s);
  double least = error;
  best_ = impulses_;
  for (int iteration = 0; iteration < kMostIterations && error > kHingeTolerance && dt_s > 0.0;
       ++iteration) {
    if (iteration >= kLeastIterations && !work.spend(parts.figure.part_count)) {
      break;
    }
    if (iteration == 0) {
      look_at_middle(parts);
    }
    middle_.find_hinge_impulses(asked_, of_hinges_);
    solver_.add_impulses_of(of_hinges_, impulses_);
    error = arrive(parts, dt_s);
    if (error < least) {
      least = error;
      best_ = impulses_;
    }
  }
  if (error > least) {
    impulses_ = best_;
    arrive(parts, dt_s);
  }
}

double FigureMotion::arrive(const Parts& parts, double dt_s) {
  std::copy(start_.begin(), start_.end(), parts.states.begin());
  solver_.push_parts(impulses_, parts.states);
  AdvancingBodies advancing;
  for (std::size_t i = 0; i < parts.states.size(); ++i) {
    static_cast<void>(advancing.take(parts.models[i], parts.states[i], dt_s, parts.rotation,
                                     falls_.empty() ? Fall{} : falls_[i]));
  }
  advancing.finish();
  return note_errors(parts, dt_s);
}

void FigureMotion::look_at_middle(const Parts& parts) {
  half_way_ = start_;
  for (std::size_t i = 0; i < half_way_.size(); ++i) {
    Pose& pose = half_way_[i].pose;
    const Pose& end = parts.states[i].pose;
    pose.position = 0.5 * (pose.position + end.position);
    pose.orientation =
        Quaternion(Eigen::Vector4d(pose.orientation.coeffs() + end.orientation.coeffs()))
            .normalized();
  }
  middle_.look_at(half_way_);
}

double FigureMotion::note_errors(const Parts& parts, double dt_s) {
  double error = 0.0;
  const Figure& figure = parts.figure;
  for (std::size_t i = 0; i < figure.hinges.size(); ++i) {
    const Hinge& hinge = figure.hinges[i];
    const Vector5 mismatch = mismatch_of(hinge, parts.states[i + 1].pose,
                                         parts.states[at(hinge.parent - figure.first_part)].pose);
    error = std::max({error, mismatch.head<3>().norm() / size_m_, mismatch.tail<2>().norm()});
    asked_[i] = dt_s > 0.0 ? Vector5(mismatch / -dt_s) : Vector5(Vector5::Zero());
  }
  return error;
}

void FigureMotion::stop_across_hinges(std::span<BodyState> parts) {
  solver_.look_at(parts);
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    asked_[i] = -solver_.speed_across(i, parts);
  }
  std::fill(impulses_.begin(), impulses_.end(), PartImpulse{});
  solver_.find_hinge_impulses(asked_, of_hinges_);
  solver_.add_impulses_of(of_hinges_, impulses_);
  solver_.push_parts(impulses_, parts);
}

}  // namespace impetus::inline figures
