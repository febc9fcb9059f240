// A staged scene in time: steps the world as far as the next frame needs and keeps the record.
//
//   steps    0---1---2---3---4---5---6---7---8     at step_hz, whatever the display
//   frames   0           1           2             poses between the two steps around each
//
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/session/record.hpp"
#include "experiments/session/staged_scene.hpp"

namespace impetus {

class Playback {
 public:
  /// `meter` must outlive this.
  Playback(StagedScene scene, WorkMeter& meter);

  /// The poses at `time_s` from onset. Time must not go back by more than a step.
  std::vector<Pose> poses_at(double time_s);

  [[nodiscard]] const StagedScene& scene() const { return scene_; }

  /// Hands the record over; the playback is finished.
  std::vector<StepRecord> take_steps() { return std::move(steps_); }
  std::vector<CollisionRecord> take_collisions() { return std::move(collisions_); }

 private:
  void step_once();
  [[nodiscard]] Pose pose_of(std::int32_t body) const;

  StagedScene scene_;
  WorkMeter* meter_;
  std::vector<BodyState> before_;
  std::vector<StepRecord> steps_;
  std::vector<CollisionRecord> collisions_;
};

/// The record of one step, from what the step reported.
StepRecord record_of(std::int64_t step, StepReport report);

}  // namespace impetus
