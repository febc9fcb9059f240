// One stimulus of a trial: the fixation cross, then the scene, with all that is recorded of it.
//
//   cross | frame 0, frame 1, ...    each frame shows the state for its scheduled time
//
// A stimulus keeps a record of its own, because of two intervals an observer judges one by one; it
// is appended to the trial's at the end.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/gaze/gaze_follower.hpp"
#include "experiments/questions/script.hpp"
#include "experiments/run/live_run.hpp"
#include "experiments/session/stimulus_sounds.hpp"
#include "experiments/session/trial.hpp"

namespace impetus::inline session {

/// Shows a stimulus and records it.
class Stimulus {
 public:
  /// Everything but `shown` must outlive this. `interval` is 1, or 2 for the second of two. Throws
  /// what staging the scene throws.
  Stimulus(const PlannedTrial& shown, std::int64_t interval, const Script& script,
           const SessionProgress& progress, const Ports& ports, GazeFollower& follower);

  /// Shows cross and scene; returns what interrupted it.
  Interruption show();

  /// The pictures' ground alone.
  [[nodiscard]] Picture blank() const { return with_pointer({}, 0.0); }

  /// Keeps the clicks since the last call, where clicks are asked for.
  void take_clicks();

  /// Tells the participant what was shown, and takes the clicks that this is answered with.
  void be_witnessed();

  /// Appends steps, collisions, frames, clicks, gaze and sounds; frames are numbered on.
  void append_to(AttemptRecord& record);

  [[nodiscard]] const StagedScene& scene() const { return live_.scene(); }

  /// Samples of the gaze younger than this are not used.
  [[nodiscard]] double imposed_gaze_latency_s() const;

  /// Of the scene's time so far, the share without a valid sample; none: gaze was not followed, or
  /// nothing was shown.
  [[nodiscard]] std::optional<double> gaze_lost_share() const { return record_.gaze_lost_share; }

  /// Of the enclosure's image, the share that was inside the region, on average.
  [[nodiscard]] std::optional<double> region_covered_share() const {
    return record_.region_covered_share;
  }

 private:
  bool show_fixation();
  bool show_scene();
  /// As far as is known now: a goal may end the scene sooner.
  [[nodiscard]] std::int64_t last_frame_of(const LiveRun& live) const;
  bool show_timed(const Picture& frame, FramePhase phase, double time_s);
  [[nodiscard]] Picture with_pointer(const std::vector<Pose>& poses, double time_s) const;
  void sound(std::int64_t frame);
  void mark(MarkedEvent event);
  void mark_frame(std::int64_t frame, std::int64_t last_frame);
  void take_simulation(std::int64_t last_frame_shown);
  [[nodiscard]] std::int64_t first_frame(std::int64_t step, std::int64_t last_shown) const;

  std::int64_t interval_;
  bool is_asked_;
  std::uint64_t seed_;
  const Script& script_;
  const SessionProgress& progress_;
  const Ports& ports_;
  GazeFollower& follower_;
  LiveRun live_;
  std::int64_t fixation_frames_{0};
  std::size_t marked_collisions_{0};
  AttemptRecord record_;
  std::optional<StimulusSounds> sounds_;  ///< none: nothing is to be heard
  Interruption interruption_{Interruption::kNone};
};

}  // namespace impetus::inline session
