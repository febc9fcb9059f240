// SPDX-License-Identifier: MIT
#include "experiments/run/scene_run.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "engine/dynamics/motion.hpp"
#include "engine/dynamics/state_hash.hpp"

namespace impetus::inline run {
namespace {

/// Of the process.
std::shared_ptr<Workers>& helpers() {
  static std::shared_ptr<Workers> all;
  return all;
}

}  // namespace

void SceneRun::share_work_with(std::shared_ptr<Workers> workers) { helpers() = std::move(workers); }

SceneRun::SceneRun(StagedScene scene, std::uint64_t seed, const WorkClock* clock)
    : scene_(std::move(scene)),
      regions_(scene_, seed),
      clock_(clock),
      ends_s_(scene_.duration_s),
      before_(scene_.world.states()) {
  set_budget(scene_.budget);
}

void SceneRun::set_budget(const WorkBudget& budget) {
  fixed_ = FixedWork(budget.tests_per_step);
  deadline_.reset();
  needs_clock_ = budget.ns_per_step > 0 && clock_ == nullptr;
  if (budget.ns_per_step > 0 && clock_ != nullptr) {
    deadline_.emplace(*clock_, budget.ns_per_step);
  }
  // A deadline grants a search so little at a time that two who share it find less than one.
  scene_.world.share_work_with(deadline_ ? nullptr : helpers());
}

std::optional<GazeRegion> SceneRun::next_region(const Fixation& fixation) {
  return regions_.at(number_ + 1, fixation);
}

const StepReport& SceneRun::step(const Fixation& fixation,
                                 const std::optional<GazeRegion>& region) {
  if (needs_clock_) {
    throw std::logic_error("a scene with a budget in milliseconds was run without a clock");
  }
  if (!deadline_) {
    return step(fixation, region, fixed_);
  }
  deadline_->start_step();
  return step(fixation, region, *deadline_);
}

const StepReport& SceneRun::step(const Fixation& fixation, const std::optional<GazeRegion>& region,
                                 WorkMeter& meter) {
  impose_motions();
  before_ = scene_.world.states();
  ++number_;
  input_ = {1.0 / scene_.step_hz, viewer_at(number_), fixation, region};
  if (is_still()) {
    stillness_.state = hash_state(before_);
    return stillness_;
  }
  const StepReport& report = scene_.world.step(input_, meter);
  if (scene_.goal) {
    watch_goal(report);
  }
  return report;
}

void SceneRun::impose_motions() {
  for (const ImposedMotion& motion : scene_.imposed_motions) {
    const BodyModel& model = scene_.world.models()[motion.body];
    if (motion.after_step == number_ && model.inverse_mass > 0.0) {
      scene_.world.mutable_states()[motion.body].linear_momentum =
          motion.velocity_m_s / model.inverse_mass;
    }
  }
}

/// Whether the step that was begun ends within the still part.
bool SceneRun::is_still() const {
  constexpr double kOfAStep = 1e-6;
  return static_cast<double>(number_) <= scene_.still_s * scene_.step_hz + kOfAStep;
}

/// A body may be through on the way back from what kept it from it, until the end.
void SceneRun::watch_goal(const StepReport& report) {
  const Goal& goal = *scene_.goal;
  const auto end_soon = [&] {
    const double now_s = static_cast<double>(number_) / scene_.step_hz;
    ends_s_ = std::min(ends_s_, now_s + goal.follow_s);
  };
  const BodyState& body = scene_.world.states()[goal.body];
  if (!is_through_ && goal.is_passed_at(body.pose.position)) {
    is_through_ = true;
    end_soon();
  }
  for (const CollisionReport& collision : report.collisions) {
    if (goal.is_missed_by(collision.bodies, body.linear_momentum)) {
      end_soon();
    }
  }
}

const StepReport& SceneRun::step_whole() {
  FixedWork all(kUnlimitedTests);
  return step({}, {}, all);
}

Viewer SceneRun::viewer_at(std::int64_t number) const {
  return scene_.viewer_at_time(static_cast<double>(number) / scene_.step_hz);
}

std::vector<Pose> SceneRun::poses(double fraction) const {
  const std::vector<BodyState>& after = scene_.world.states();
  std::vector<Pose> poses;
  poses.reserve(after.size());
  for (std::size_t body = 0; body < after.size(); ++body) {
    poses.push_back(between(before_[body], after[body], fraction));
  }
  return poses;
}

std::vector<TouchPoint> touch_points(const StepReport& report, const CollisionReport& collision) {
  if (report.contacts.empty()) {
    return {collision.contact.touch};
  }
  std::vector<TouchPoint> touches;
  const auto first = static_cast<std::size_t>(collision.first_contact);
  const auto count = static_cast<std::size_t>(collision.contact_count);
  for (std::size_t i = first; i < std::min(first + count, report.contacts.size()); ++i) {
    touches.push_back(report.contacts[i].touch);
  }
  return touches;
}

}  // namespace impetus::inline run
