// A recorded trial on its way to being viewed: simulated again, a step at a time, so that a window
// can tell how far it is.
//
//   as recorded   every step with the work it was granted, compared with its recorded hash
//   finest        the same start, gaze and times, but every pair refined to the finest level of
//                 the trees that the study built: what the participant should have seen
//
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "experiments/record/ports.hpp"
#include "experiments/run/replay.hpp"
#include "experiments/viewing/replay_view.hpp"

namespace impetus::inline viewing {

/// How finely: as much as the participant had, or as finely as can be.
enum class SimulatedDetail { kAsRecorded, kFinest };

/// The simulation of one trial, step by step.
class ReplaySimulation {
 public:
  /// `scene` is the trial's at its start.
  ReplaySimulation(StagedScene scene, std::vector<StepRecord> recorded, SimulatedDetail detail);
  ReplaySimulation(const ReplaySimulation&) = delete;
  ReplaySimulation& operator=(const ReplaySimulation&) = delete;

  [[nodiscard]] bool done() const { return running_.done(); }
  /// Of the steps, from 0 to 1.
  [[nodiscard]] double share() const;
  /// The next step. Precondition: not done.
  void advance();

  /// All of the view but title, facts, and what the participant did; `agrees` is of a simulation
  /// as recorded alone. To be called once, when it is done.
  ReplayView take();

 private:
  std::vector<StepRecord> recorded_;
  RunningReplay running_;
  LatestDetail latest_;
  ReplayView view_;
};

/// All of it at once, as recorded.
ReplayView view_of(StagedScene scene, const std::vector<StepRecord>& recorded);

/// The same trial at the finest level, simulated a little in every frame once it is asked for.
class FinestBeside {
 public:
  /// All must outlive this.
  FinestBeside(const StagedScene& scene, const std::vector<StepRecord>& steps, const Clock& clock)
      : scene_(scene), steps_(steps), clock_(clock) {}

  /// Simulates for a part of a frame. Whether it has just been done.
  bool go_on();

  /// From 0 to 1.
  [[nodiscard]] double share() const;
  /// Null until it is done.
  [[nodiscard]] const ReplayView* view() const { return view_ ? &*view_ : nullptr; }

 private:
  const StagedScene& scene_;
  const std::vector<StepRecord>& steps_;
  const Clock& clock_;
  std::unique_ptr<ReplaySimulation> running_;
  std::optional<ReplayView> view_;
};

}  // namespace impetus::inline viewing
