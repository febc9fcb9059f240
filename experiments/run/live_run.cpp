// SPDX-License-Identifier: MIT
#include "experiments/run/live_run.hpp"

#include <algorithm>
#include <utility>

#include "engine/scheduling/speed_metrics.hpp"
#include "experiments/run/frame_poses.hpp"

namespace impetus::inline run {
namespace {

/// The pair as schedulers measure it when its collision begins: where it is at the end of the step,
/// as fast as it came.
PairBounds pair_bounds(const SceneRun& run, const BodyPair& bodies) {
  const World& world = run.world();
  const auto bound = [&](std::int32_t body) {
    const auto index = static_cast<std::size_t>(body);
    return Sphere{world.states()[index].pose.position,
                  world.models()[index].tree->bounding_radius_m()};
  };
  const auto velocity_of = [&](std::int32_t body) {
    const auto index = static_cast<std::size_t>(body);
    return velocity(world.models()[index], run.before()[index]);
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

StepRecord record_step(std::int64_t step, const GazeInput& gaze, const StepReport& report,
                       bool keeps_digests) {
  StepRecord record{step, report.work_granted, report.work_spent, report.degradations, {}, gaze};
  record.state.hash = report.state.hash;
  if (keeps_digests) {
    record.state.bodies = report.state.bodies;
  }
  record.pops = static_cast<std::int64_t>(report.pops.size());
  record.stopped_short = static_cast<std::int64_t>(report.stopped.size());
  record.not_finite = report.not_finite;
  record.cut_work = report.grants;
  for (const LevelPop& pop : report.pops) {
    record.largest_pop_deg = std::max(record.largest_pop_deg, pop.size_deg);
  }
  return record;
}

CollisionRecord record_collision(const SceneRun& run, const GazeInput& gaze,
                                 const CollisionReport& collision) {
  const Viewer& viewer = run.input().viewer;
  const Vector3& point = collision.contact.touch.point;
  const auto eccentricity_from_deg = [&](const ScreenPoint& place) {
    return visual_angle_deg(viewer, point, on_screen(viewer, place));
  };
  const auto pose = [&](std::int32_t body) {
    return is_wall(body) ? Pose{} : run.world().states()[static_cast<std::size_t>(body)].pose;
  };
  CollisionRecord record;
  record.step = run.number();
  record.time_s = static_cast<double>(record.step) / run.scene().step_hz;
  record.report = collision;
  record.pose_a = pose(collision.bodies.a);
  record.pose_b = pose(collision.bodies.b);
  record.no_spin = run.scene().no_spin;
  record.eccentricity_deg = eccentricity_from_deg({});
  record.distance_m = (point - viewer.eye).norm();
  const PairBounds pair = pair_bounds(run, collision.bodies);
  record.speed_deg_s = mean_speed_deg_s(pair, viewer);
  record.collision_speed_deg_s = CollisionSpeedMetric().measure(pair, viewer, gaze.fixation);
  record.priority = collision.measured;
  if (collision.imposed_spin) {
    record.imposed_spin = run.world().settings().imposed_spin->spin;
  }
  if (gaze.fixation) {
    record.gaze_eccentricity_deg = eccentricity_from_deg(*gaze.fixation);
  }
  if (gaze.region && gaze.region->radius_deg < kWholeView_deg) {
    record.region_eccentricity_deg = eccentricity_from_deg(gaze.region->centre);
  }
  return record;
}

LiveRun::LiveRun(StagedScene scene, std::uint64_t seed, const WorkClock* work_clock)
    : run_(std::move(scene), seed, work_clock) {
  StepReport start;
  start.state = hash_state(run_.world().states());
  steps_.push_back(record_step(0, {}, start));
}

void LiveRun::step() {
  gaze_.region = run_.next_region(gaze_.fixation);
  const StepReport& report = run_.step(gaze_.fixation, gaze_.region);
  for (const CollisionReport& collision : report.collisions) {
    if (collision.began) {
      collisions_.push_back(record_collision(run_, gaze_, collision));
    }
  }
  steps_.push_back(record_step(run_.number(), gaze_, report, keeps_digests_));
}

std::vector<Pose> LiveRun::poses_at(double time_s) {
  const std::int64_t last_needed = last_shown_step(scene(), time_s);
  while (run_.number() < last_needed) {
    step();
  }
  return shown_poses(run_, time_s);
}

}  // namespace impetus::inline run
