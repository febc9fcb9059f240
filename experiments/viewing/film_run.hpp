// A filmed stimulus, simulated again as far as each of its frames: the picture that the participant
// had before the eyes then, and what collided in it.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "experiments/record/ports.hpp"
#include "experiments/run/collision_truth.hpp"
#include "experiments/run/replay.hpp"
#include "experiments/viewing/film.hpp"

namespace impetus::inline viewing {

/// Two bodies that touch in a step.
struct FilmedContact {
  std::int64_t step{0};
  CollisionReport report;
  std::vector<TouchPoint> touches;
  std::optional<CollisionTruth> truth{};  ///< where the contact begins
};

/// Goes through a stimulus frame by frame.
class FilmRun {
 public:
  /// `stimulus` must outlive this.
  explicit FilmRun(const FilmedStimulus& stimulus) : run_(stimulus.scene, stimulus.steps) {}
  FilmRun(const FilmRun&) = delete;
  FilmRun& operator=(const FilmRun&) = delete;

  /// Simulates what the frame at `time_s` from onset needs; times never go back.
  void advance(double time_s);

  /// The step that it has come to.
  [[nodiscard]] std::int64_t step() const { return run_.scene_run().number(); }
  /// The frame's picture, as the session made it.
  [[nodiscard]] Picture picture(double time_s) const;
  /// Of the steps that the last advance() took.
  [[nodiscard]] const std::vector<FilmedContact>& contacts() const { return contacts_; }
  [[nodiscard]] const StagedScene& scene() const { return run_.scene(); }

 private:
  void keep(const StepReport& report);

  RunningReplay run_;
  std::vector<FilmedContact> contacts_;
};

}  // namespace impetus::inline viewing
