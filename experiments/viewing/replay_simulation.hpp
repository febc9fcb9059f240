// A recorded trial on its way to being viewed: simulated again, a step at a time, so that a window
// can tell how far it is.
//
//   as recorded   every step with the work it was granted, compared with its recorded hash
//   finest        the same start, gaze and times, but every pair refined to the finest level of
//                 the trees that the study built: what the participant should have seen
//
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/run/replay.hpp"
#include "experiments/viewing/replay_view.hpp"

namespace impetus::inline viewing {

enum class SimulatedDetail { kAsRecorded, kFinest };

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

}  // namespace impetus::inline viewing
