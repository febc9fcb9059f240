// The live trial: runs a scene as far as the next frame needs, and keeps the record.
//
//   steps    0---1---2---3---4---5---6---7---8     at step_hz, whatever the display
//   frames   0           1           2             poses between the two steps around each
//
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/record/record.hpp"
#include "experiments/run/scene_run.hpp"

namespace impetus::inline run {

/// Runs a trial's scene for a participant and records it.
class LiveRun {
 public:
  /// `seed` is the trial's. `work_clock` times budgets in milliseconds and must outlive this; a
  /// scene without such a budget needs none.
  LiveRun(StagedScene scene, std::uint64_t seed, const WorkClock* work_clock = nullptr);

  /// What the participant looks at from the next step on; its region is left to the scene's rule.
  void look_at(const GazeInput& gaze) { gaze_ = gaze; }

  /// From now on the records of steps are without the digests of bodies; hashes stay.
  void drop_digests() { keeps_digests_ = false; }

  /// The poses at `time_s` from onset. Time must not go back by more than a step.
  std::vector<Pose> poses_at(double time_s);

  [[nodiscard]] const StagedScene& scene() const { return run_.scene(); }
  /// When the stimulus ends, as far as is known now.
  [[nodiscard]] double ends_s() const { return run_.ends_s(); }

  /// So far.
  [[nodiscard]] const std::vector<CollisionRecord>& collisions() const { return collisions_; }

  /// Hands the record over, after which nothing more is to be run.
  std::vector<StepRecord> take_steps() { return std::move(steps_); }
  std::vector<CollisionRecord> take_collisions() { return std::move(collisions_); }

 private:
  void step();

  SceneRun run_;
  GazeInput gaze_;
  std::vector<StepRecord> steps_;
  std::vector<CollisionRecord> collisions_;
  bool keeps_digests_{true};
};

/// The record of one step, from what it was told and what it reported; with the digests of bodies
/// or without.
StepRecord record_step(std::int64_t step, const GazeInput& gaze, const StepReport& report,
                       bool keeps_digests = true);

/// The record of a collision that began in the last step of `run`, which was told `gaze`.
CollisionRecord record_collision(const SceneRun& run, const GazeInput& gaze,
                                 const CollisionReport& collision);

}  // namespace impetus::inline run
