// SPDX-License-Identifier: MIT
#include "experiments/viewing/replay_simulation.hpp"

#include <utility>

#include "experiments/run/level_collision.hpp"
#include "experiments/run/preview_settings.hpp"

namespace impetus::inline viewing {
namespace {

using Kind = TimelineMark::Kind;

StagedScene with_detail(StagedScene scene, SimulatedDetail detail) {
  if (detail == SimulatedDetail::kFinest) {
    scene.world.set_schedule({});
  }
  return scene;
}

std::vector<StepRecord> with_detail(std::vector<StepRecord> steps, SimulatedDetail detail) {
  if (detail == SimulatedDetail::kFinest) {
    for (StepRecord& step : steps) {
      step.work_granted = kUnlimitedTests;
      step.cut_work = {};
    }
  }
  return steps;
}

void mark_what_was_imposed(const StagedScene& scene, std::vector<TimelineMark>& marks) {
  if (scene.contact_s > 0.0) {
    marks.push_back({Kind::kContact, scene.contact_s, scene.contact_s, "contact"});
  }
  if (scene.realised_hold_s > 0.0) {
    marks.push_back(
        {Kind::kHold, scene.contact_s, scene.contact_s + scene.realised_hold_s, "imposed hold"});
  }
}

void mark_collisions(double time_s, const StepReport& report, std::vector<TimelineMark>& marks) {
  for (const CollisionReport& collision : report.collisions) {
    if (collision.began) {
      const bool fine = collision.stop == StopReason::kFinest;
      marks.push_back({fine ? Kind::kFineCollision : Kind::kCoarseCollision, time_s, time_s, ""});
    }
  }
}

std::vector<StepContact> contacts_of(const StepReport& report) {
  std::vector<StepContact> contacts;
  for (const CollisionReport& collision : report.collisions) {
    for (const TouchPoint& touch : touch_points(report, collision)) {
      contacts.push_back({collision.bodies, touch});
    }
  }
  return contacts;
}

ReplayView view_at_start(const StagedScene& scene) {
  ReplayView view;
  view.viewer = scene.viewer;
  view.turn = scene.turn;
  view.looks = scene.looks;
  view.flashing = scene.flashing;
  view.enclosure = scene.world.settings().enclosure;
  view.appearance = scene.appearance;
  view.step_hz = scene.step_hz;
  view.duration_s = scene.duration_s;
  view.finest_level = finest_level_of(scene.world);
  for (const BodyModel& body : scene.world.models()) {
    view.trees.push_back(body.tree);
  }
  mark_what_was_imposed(scene, view.marks);
  return view;
}

}  // namespace

ReplaySimulation::ReplaySimulation(StagedScene scene, std::vector<StepRecord> recorded,
                                   SimulatedDetail detail)
    : recorded_(with_detail(std::move(recorded), detail)),
      running_(with_detail(std::move(scene), detail), recorded_),
      latest_(running_.scene().looks.size(), running_.scene().step_hz),
      view_(view_at_start(running_.scene())) {
  for (const StepRecord& step : recorded_) {
    view_.gaze.push_back(step.gaze);
  }
}

double ReplaySimulation::share() const {
  return recorded_.empty()
             ? 1.0
             : static_cast<double>(view_.states.size()) / static_cast<double>(recorded_.size());
}

void ReplaySimulation::advance() {
  const std::int64_t step = running_.next_step();
  const StepReport& report = running_.next();
  view_.states.push_back(running_.scene().world.states());
  view_.contacts.push_back(contacts_of(report));
  latest_.take(step, report);
  view_.details.push_back(latest_.at(step));
  mark_collisions(static_cast<double>(step) / view_.step_hz, report, view_.marks);
}

ReplayView ReplaySimulation::take() {
  view_.agrees = !running_.result().divergence;
  return std::move(view_);
}

ReplayView view_of(StagedScene scene, const std::vector<StepRecord>& recorded) {
  ReplaySimulation simulation(std::move(scene), recorded, SimulatedDetail::kAsRecorded);
  while (!simulation.done()) {
    simulation.advance();
  }
  return simulation.take();
}

bool FinestBeside::go_on() {
  constexpr std::int64_t kPartOfFrame_ns = 10'000'000;
  if (view_) {
    return false;
  }
  if (!running_) {
    running_ = std::make_unique<ReplaySimulation>(scene_, steps_, SimulatedDetail::kFinest);
  }
  const std::int64_t began_ns = clock_.now_ns();
  while (!running_->done() && clock_.now_ns() - began_ns < kPartOfFrame_ns) {
    running_->advance();
  }
  if (!running_->done()) {
    return false;
  }
  view_ = running_->take();
  running_.reset();
  return true;
}

double FinestBeside::share() const { return view_ ? 1.0 : running_ ? running_->share() : 0.0; }

}  // namespace impetus::inline viewing
