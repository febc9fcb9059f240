// SPDX-License-Identifier: MIT
#include "engine/figures/figure_motion.hpp"

#include <algorithm>

#include "engine/figures/as_one_body.hpp"
#include "engine/numerics/at.hpp"

namespace impetus::inline figures {
namespace {

/// Of the beginning impulses, at most; and those that are granted with each part of a step.
constexpr int kMostIterations = 24;
constexpr int kLeastIterations = 2;

/// What a figure may be wrong by that has arrived: of its size, or radians, and of its energy.
constexpr double kArrived = 1e-9;

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

/// What a figure that is held may gain in a part of a step, as whatever rests may (motion.hpp).
double given_to_held_J(std::span<const BodyModel> parts, std::span<const Fall> falls, double step_s,
                       double part_s) {
  double force_squares = 0.0;  // over mass
  for (std::size_t i = 0; i < falls.size(); ++i) {
    if (parts[i].inverse_mass > 0.0) {
      force_squares += falls[i].gravity_m_s2.squaredNorm() / parts[i].inverse_mass;
    }
  }
  return any_supported(falls) ? kRestingSteps * step_s * part_s * force_squares : 0.0;
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

/// The fall from one of the `count` parts of a step to another. What rests is held by its contacts
/// alone: what keeps a body where it is would tear at its hinges.
Fall fall_in(int first, int end, int count, Fall fall) {
  fall.resting = false;
  if (fall.comes_last) {
    fall.gravity_m_s2 *= end == count ? static_cast<double>(count) / (end - first) : 0.0;
  }
  return fall;
}

/// What moves across a hinge by less than this share of how fast its sides move, is rounding.
constexpr double kStill = 1e-12;

}  // namespace

FigureMotion::FigureMotion(const Figure& figure, const std::vector<BodyModel>& models)
    : solver_(figure, models),
      middle_(figure, models),
      size_m_(top_bound_m(figure, models)),
      impulses_(at(figure.part_count)),
      asked_(figure.hinges.size(), Vector5::Zero()) {}

bool FigureMotion::advance(const Figure& figure, const std::vector<BodyModel>& models,
                           const FigureStep& step, PhaseWork& work,
                           std::vector<BodyState>& states) {
  const std::size_t first = at(figure.first_part);
  const std::size_t count = at(figure.part_count);
  const Parts parts{figure, std::span(models).subspan(first, count),
                    step.falls.empty() ? step.falls : step.falls.subspan(first, count),
                    std::span(states).subspan(first, count)};
  const int motion_parts = granted_parts(parts, step, work);
  if (motion_parts == 0) {
    go_as_one_body(parts, step.dt_s, parts.falls);
    return false;
  }
  bool arrived = true;
  for (int i = 0; i < motion_parts; ++i) {
    if (!arrived && work.refused() && step.may_go_as_one_body) {
      find_falls(parts, i, motion_parts, motion_parts);
      go_as_one_body(parts, step.dt_s * (motion_parts - i) / motion_parts, falls_);
      return false;
    }
    find_falls(parts, i, i + 1, motion_parts);
    arrived &= advance_part(parts, step.dt_s / motion_parts, step, work);
  }
  return arrived;
}

void FigureMotion::find_falls(const Parts& parts, int first, int end, int count) {
  falls_.clear();
  for (const Fall& fall : parts.falls) {
    falls_.push_back(fall_in(first, end, count, fall));
  }
}

/// In how many parts a step is made: as many as it should, or half as often as it takes; at last in
/// none, where the figure may go as one body.
int FigureMotion::granted_parts(const Parts& parts, const FigureStep& step, PhaseWork& work) const {
  const int in_any_case = step.may_go_as_one_body ? 0 : 1;
  int count = motion_parts_of(parts.models, parts.states, step.dt_s);
  while (count > in_any_case && !work.spend(std::int64_t{parts.figure.part_count} *
                                            (count - in_any_case) * kLeastIterations)) {
    count /= 2;
  }
  return count;
}

bool FigureMotion::advance_part(const Parts& parts, double dt_s, const FigureStep& step,
                                PhaseWork& work) {
  start_.assign(parts.states.begin(), parts.states.end());
  solver_.look_at(parts.states);
  const double error = arrive_together(parts, dt_s, step.rotation, work);
  stop_across_hinges(parts.states);
  const bool energy_holds = bring_energy_back(parts, dt_s, step.dt_s);
  const bool arrived = error <= kArrived && energy_holds;
  if (!arrived && step.may_go_as_one_body) {
    std::copy(start_.begin(), start_.end(), parts.states.begin());
    go_as_one_body(parts, dt_s, falls_);
  }
  return arrived;
}

bool FigureMotion::bring_energy_back(const Parts& parts, double part_s, double step_s) const {
  const double before_J = kinetic_energy(parts.models, start_);
  const double of_gravity_J = work_of_gravity(parts.models, parts.falls, start_, parts.states);
  bring_to_energy(before_J + of_gravity_J, /*may_grow=*/!any_supported(parts.falls), parts.models,
                  parts.states);
  const double of_centre_J =
      energy_of_centre(parts.models, parts.states) - energy_of_centre(parts.models, start_);
  const double most_J = before_J + std::max(of_gravity_J, of_centre_J) +
                        given_to_held_J(parts.models, parts.falls, step_s, part_s);
  const double after_J = kinetic_energy(parts.models, parts.states);
  return after_J <= most_J + kArrived * after_J;
}

void FigureMotion::go_as_one_body(const Parts& parts, double dt_s, std::span<const Fall> falls) {
  move_as_one_body(dt_s, parts.models, falls, parts.states);
  solver_.look_at(parts.states);
  const bool was_slowed_in_parts = !solver_.nothing_moves_across(kStill, parts.states);  // at walls
  if (was_slowed_in_parts) {
    stop_across_hinges(parts.states);
  }
}

double FigureMotion::arrive_together(const Parts& parts, double dt_s, Rotation rotation,
                                     PhaseWork& work) {
  std::fill(impulses_.begin(), impulses_.end(), PartImpulse{});
  double error = arrive(parts, dt_s, rotation);
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
    error = arrive(parts, dt_s, rotation);
    if (error < least) {
      least = error;
      best_ = impulses_;
    }
  }
  if (error > least) {
    impulses_ = best_;
    arrive(parts, dt_s, rotation);
  }
  return least;
}

double FigureMotion::arrive(const Parts& parts, double dt_s, Rotation rotation) {
  std::copy(start_.begin(), start_.end(), parts.states.begin());
  solver_.push_parts(impulses_, parts.states);
  AdvancingBodies advancing;
  for (std::size_t i = 0; i < parts.states.size(); ++i) {
    static_cast<void>(advancing.take(parts.models[i], parts.states[i], dt_s, rotation,
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
