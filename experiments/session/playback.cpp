// SPDX-License-Identifier: MIT
#include "experiments/session/playback.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "engine/dynamics/motion.hpp"

namespace impetus {
namespace {

/// Angle at the eye between `point` and the screen's centre, the world's origin (degrees). For
/// the record alone: nothing is decided by it.
double eccentricity_deg(const Vector3& point, const Viewer& viewer) {
  const Vector3 to_point = point - viewer.eye;
  const Vector3 to_centre = -viewer.eye;
  return std::atan2(to_point.cross(to_centre).norm(), to_point.dot(to_centre)) * 180.0 /
         std::numbers::pi;
}

}  // namespace

StepRecord record_of(std::int64_t step, StepReport report) {
  return {step, report.work_granted, report.work_spent, report.degradations,
          std::move(report.state)};
}

Playback::Playback(StagedScene scene, WorkMeter& meter)
    : scene_(std::move(scene)), meter_(&meter), before_(scene_.world.states()) {
  steps_.push_back({0, 0, 0, 0, hash_state(before_)});
}

void Playback::step_once() {
  before_ = scene_.world.states();
  const StepInput input{1.0 / scene_.step_hz, scene_.viewer};
  StepReport report = scene_.world.step(input, *meter_);
  const std::int64_t step = steps_.back().step + 1;
  for (const CollisionReport& collision : report.collisions) {
    if (collision.began) {
      const Vector3& point = collision.contact.touch.point;
      collisions_.push_back({step, collision, pose_of(collision.bodies.a),
                             pose_of(collision.bodies.b), scene_.no_spin,
                             eccentricity_deg(point, scene_.viewer), -1});
    }
  }
  steps_.push_back(record_of(step, std::move(report)));
}

Pose Playback::pose_of(std::int32_t body) const {
  if (is_wall(body)) {
    return {};
  }
  return scene_.world.states()[static_cast<std::size_t>(body)].pose;
}

std::vector<Pose> Playback::poses_at(double time_s) {
  const double position = time_s * scene_.step_hz;
  const auto last_needed = static_cast<std::int64_t>(std::ceil(position));
  while (steps_.back().step < last_needed) {
    step_once();
  }
  const double fraction = 1.0 - (static_cast<double>(steps_.back().step) - position);
  const std::vector<BodyState>& after = scene_.world.states();
  std::vector<Pose> poses;
  poses.reserve(after.size());
  for (std::size_t body = 0; body < after.size(); ++body) {
    poses.push_back(between(before_[body], after[body], fraction));
  }
  return poses;
}

}  // namespace impetus
