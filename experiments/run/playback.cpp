// SPDX-License-Identifier: MIT
#include "experiments/run/playback.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine/dynamics/motion.hpp"
#include "engine/scheduling/speed_metrics.hpp"

namespace impetus::inline run {
namespace {

/// Throws unless a scene with a budget by the clock has one.
std::optional<DeadlineWork> deadline_of(const WorkBudget& budget, const Clock* clock) {
  if (budget.ns_per_step == 0) {
    return std::nullopt;
  }
  if (clock == nullptr) {
    throw std::invalid_argument("playback: a budget in milliseconds needs a clock");
  }
  return DeadlineWork(*clock, budget.ns_per_step);
}

/// The pair as schedulers measure it when its collision begins: where it is at the end of the step,
/// as fast as it came.
PairBounds bounds_of(const World& world, const std::vector<BodyState>& before,
                     const BodyPair& bodies) {
  const auto bound = [&](std::int32_t body) {
    const auto index = static_cast<std::size_t>(body);
    return Sphere{world.states()[index].pose.position,
                  world.models()[index].tree->bounding_radius_m()};
  };
  const auto velocity_of = [&](std::int32_t body) {
    const auto index = static_cast<std::size_t>(body);
    return velocity(world.models()[index], before[index]);
  };
  const std::int32_t b = is_wall(bodies.b) ? bodies.a : bodies.b;
  return {bodies, bound(bodies.a), bound(b), velocity_of(bodies.a), velocity_of(b)};
}

/// The mean projected speed of both bodies; a wall stands still.
double mean_speed_deg_s(const PairBounds& pair, const Viewer& viewer) {
  return is_wall(pair.pair.b) ? 0.5 * angular_speed_deg_s(viewer, pair.a.centre, pair.velocity_a)
                              : mean_seen_speed_deg_s(pair, viewer);
}

}  // namespace

StepRecord record_of(std::int64_t step, const GazeInput& gaze, const StepReport& report,
                     bool keeps_digests) {
  StepRecord record{step, report.work_granted, report.work_spent, report.degradations, {}, gaze};
  record.state.hash = report.state.hash;
  if (keeps_digests) {
    record.state.bodies = report.state.bodies;
  }
  record.pops = static_cast<std::int64_t>(report.pops.size());
  record.stopped_short = static_cast<std::int64_t>(report.stopped.size());
  record.not_finite = report.not_finite;
  for (const LevelPop& pop : report.pops) {
    record.largest_pop_deg = std::max(record.largest_pop_deg, pop.size_deg);
  }
  return record;
}

Playback::Playback(StagedScene scene, std::uint64_t seed, const Clock* work_clock)
    : scene_(std::move(scene)),
      regions_(scene_, seed),
      fixed_(scene_.budget.tests_per_step),
      deadline_(deadline_of(scene_.budget, work_clock)),
      before_(scene_.world.states()) {
  StepReport start;
  start.state = hash_state(before_);
  steps_.push_back(impetus::record_of(0, {}, start));
}

void Playback::step_once() {
  before_ = scene_.world.states();
  const std::int64_t step = steps_.back().step + 1;
  gaze_.region = regions_.at(step, gaze_.fixation);
  const double time_s = static_cast<double>(step) / scene_.step_hz;
  const StepInput input{1.0 / scene_.step_hz, scene_.viewer_at_time(time_s), gaze_.fixation,
                        gaze_.region};
  const StepReport& report = scene_.world.step(input, meter_of_step());
  for (const CollisionReport& collision : report.collisions) {
    if (collision.began) {
      collisions_.push_back(record_of(step, collision));
    }
  }
  steps_.push_back(impetus::record_of(step, gaze_, report, keeps_digests_));
}

WorkMeter& Playback::meter_of_step() {
  if (!deadline_) {
    return fixed_;
  }
  deadline_->start_step();
  return *deadline_;
}

CollisionRecord Playback::record_of(std::int64_t step, const CollisionReport& collision) const {
  CollisionRecord record;
  record.step = step;
  record.time_s = static_cast<double>(step) / scene_.step_hz;
  const Vector3& point = collision.contact.touch.point;
  const Viewer viewer = scene_.viewer_at_time(record.time_s);
  const auto from = [&](const ScreenPoint& place) {
    return visual_angle_deg(viewer, point, on_screen(viewer, place));
  };
  record.report = collision;
  record.pose_a = pose_of(collision.bodies.a);
  record.pose_b = pose_of(collision.bodies.b);
  record.no_spin = scene_.no_spin;
  record.eccentricity_deg = from({});
  record.distance_m = (point - viewer.eye).norm();
  const PairBounds pair = bounds_of(scene_.world, before_, collision.bodies);
  record.speed_deg_s = mean_speed_deg_s(pair, viewer);
  record.collision_speed_deg_s = CollisionSpeedMetric().measure(pair, viewer, gaze_.fixation);
  record.priority = collision.measured;
  if (collision.imposed_spin) {
    record.imposed_spin = scene_.world.settings().imposed_spin->spin;
  }
  if (gaze_.fixation) {
    record.gaze_eccentricity_deg = from(*gaze_.fixation);
  }
  if (gaze_.region && gaze_.region->radius_deg < kWholeView_deg) {
    record.region_eccentricity_deg = from(gaze_.region->centre);
  }
  return record;
}

Pose Playback::pose_of(std::int32_t body) const {
  if (is_wall(body)) {
    return {};
  }
  return scene_.world.states()[static_cast<std::size_t>(body)].pose;
}

std::vector<Pose> Playback::poses_at(double time_s) {
  // A frame that falls on a step needs no later one, whatever rounding made of its time.
  constexpr double kOfAStep = 1e-9;
  const double position = time_s * scene_.step_hz;
  const auto last_needed = static_cast<std::int64_t>(std::ceil(position - kOfAStep));
  while (steps_.back().step < last_needed) {
    step_once();
  }
  const double fraction = std::min(1.0, 1.0 - (static_cast<double>(steps_.back().step) - position));
  const std::vector<BodyState>& after = scene_.world.states();
  std::vector<Pose> poses;
  poses.reserve(after.size());
  for (std::size_t body = 0; body < after.size(); ++body) {
    poses.push_back(between(before_[body], after[body], fraction));
  }
  return poses;
}

}  // namespace impetus::inline run
