// SPDX-License-Identifier: MIT
#include "experiments/session/unattended.hpp"

#include <algorithm>
#include <utility>

#include "experiments/run/live_run.hpp"

namespace impetus::inline session {

void play_to(LiveRun& live, double end_s, const std::function<void(double share)>& progress) {
  constexpr double kMostTold_s = 1.0;  // of simulated time, between words of progress
  constexpr double kMostToldSteps = 250.0;
  // A goal may end the scene with any step.
  const double steps = live.scene().goal ? 1.0 : kMostToldSteps;
  const double tell_s = std::min(kMostTold_s, steps / live.scene().step_hz);
  const auto last_s = [&] { return live.scene().goal ? std::min(end_s, live.ends_s()) : end_s; };
  for (double time_s = 0.0; time_s < last_s();) {
    time_s = std::min(time_s + tell_s, last_s());
    live.poses_at(time_s);
    if (progress) {
      progress(time_s / end_s);
    }
  }
}

namespace {

AttemptRecord run_trial(const PlannedTrial& trial, StagedScene scene, const WorkClock& work_clock,
                        const std::function<void(double share)>& progress) {
  LiveRun live(std::move(scene), trial.seed, &work_clock);
  live.drop_digests();
  play_to(live, live.scene().duration_s, progress);
  AttemptRecord record;
  record.slot = trial.slot;
  record.outcome = AttemptOutcome::kCompleted;
  record.body_names = body_names(live.scene().world);
  record.wall_naming = wall_naming(live.scene().world.settings().enclosure);
  record.intended_hold_s = live.scene().intended_hold_s;
  record.realised_hold_s = live.scene().realised_hold_s;
  record.steps = live.take_steps();
  for (StepRecord& step : record.steps) {
    step.shown_frame = -1;
  }
  record.collisions = live.take_collisions();
  return record;
}

}  // namespace

void run_unattended(const Plan& plan, const SessionHistory& history, const Scenes& scenes,
                    const ScreenGeometry& screen, Recorder& recorder, const WorkClock& work_clock,
                    const std::function<void(double share)>& progress) {
  double done = 0.0;
  for (const PlannedTrial& trial : plan) {
    if (!history.completed_slots.contains(trial.slot)) {
      const auto tell = [&](double share) {
        if (progress) {
          progress((done + share) / static_cast<double>(plan.size()));
        }
      };
      const auto before = history.attempts.find(trial.slot);
      AttemptRecord record = run_trial(trial, scenes.stage(trial, screen), work_clock, tell);
      record.number = (before == history.attempts.end() ? 0 : before->second) + 1;
      recorder.save(std::move(record));
      recorder.await_saved();
    }
    done += 1.0;
  }
  recorder.mark_finished();
  recorder.await_saved();
}

}  // namespace impetus::inline session
