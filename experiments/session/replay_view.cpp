// SPDX-License-Identifier: MIT
#include "experiments/session/replay_view.hpp"

#include <utility>

#include "experiments/session/preview_settings.hpp"
#include "experiments/session/replay.hpp"

namespace impetus {
namespace {

using Kind = TimelineMark::Kind;

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

}  // namespace

ReplayView view_of(StagedScene scene, const std::vector<StepRecord>& recorded) {
  ReplayView view;
  view.viewer = scene.viewer;
  view.turn = scene.turn;
  view.looks = scene.looks;
  view.enclosure = scene.world.settings().enclosure;
  view.step_hz = scene.step_hz;
  view.duration_s = scene.duration_s;
  view.finest_level = finest_level_of(scene.world);
  LatestDetail latest(scene.looks.size(), scene.step_hz);
  mark_what_was_imposed(scene, view.marks);
  for (const StepRecord& step : recorded) {
    view.gaze.push_back(step.gaze);
  }
  const ReplayResult result =
      replay(std::move(scene), recorded,
             [&](std::int64_t step, const World& world, const StepReport& report) {
               view.states.push_back(world.states());
               latest.take(step, report);
               view.details.push_back(latest.at(step));
               mark_collisions(static_cast<double>(step) / view.step_hz, report, view.marks);
             });
  view.agrees = !result.divergence;
  return view;
}

void end_with_last_step(ReplayView& view) {
  const double shown_s = static_cast<double>(view.states.size() - 1) / view.step_hz;
  if (shown_s < view.duration_s) {
    view.duration_s = shown_s;
    std::erase_if(view.marks, [&](const TimelineMark& mark) { return mark.begin_s > shown_s; });
  }
}

GazeInput gaze_of_step(const ReplayView& view, std::int64_t step) {
  const bool known = step >= 0 && step < static_cast<std::int64_t>(view.gaze.size());
  return known ? view.gaze[static_cast<std::size_t>(step)] : GazeInput{};
}

}  // namespace impetus
