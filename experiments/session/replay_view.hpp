// One recorded trial, re-simulated, as the viewer plays it: plain data.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/dynamics/body.hpp"
#include "experiments/session/body_detail.hpp"
#include "experiments/session/record.hpp"
#include "experiments/session/staged_scene.hpp"

namespace impetus {

/// A moment (end_s == begin_s) or a stretch on the timeline, seconds from onset.
struct TimelineMark {
  enum class Kind {
    kContact,          ///< when two bodies are to meet
    kHold,             ///< the imposed freeze after it
    kFineCollision,    ///< a contact that began at the finest level
    kCoarseCollision,  ///< one that began at a coarser level, whatever stopped it there
    kClick,
    kResponse,
    kLateFrame
  };
  Kind kind{Kind::kContact};
  double begin_s{0.0};
  double end_s{0.0};
  std::string label;  ///< "": the kind says it all
};

struct ReplayView {
  std::string title;               ///< "P01 · trial 37 of 87 · main"
  std::vector<std::string> facts;  ///< "delay_ms 100", "rated 2", ...
  Viewer viewer;                   ///< at the onset
  ViewerTurn turn;
  std::vector<DrawnBody> looks;
  std::optional<Enclosure> enclosure;
  double step_hz{240.0};
  double duration_s{0.0};
  std::vector<std::vector<BodyState>> states;  ///< [step][body], step 0 is the start
  std::vector<GazeInput> gaze;  ///< [step], what the step was told; nothing for step 0
  std::vector<TimelineMark> marks;
  bool agrees{true};                             ///< every step's hash as recorded
  std::vector<std::vector<BodyDetail>> details;  ///< [step][body], of collisions
  int finest_level{0};                           ///< of all bodies' trees
};

/// Simulates a trial again through its recorded steps: all of the view but title, facts, and the
/// marks of what the participant did.
ReplayView view_of(StagedScene scene, const std::vector<StepRecord>& recorded);

/// Of an interrupted trial, takes away the time and the marks after its last step.
void end_with_last_step(ReplayView& view);

/// Where the participant looked in a step and what region it had; nothing when the step was told
/// neither, or there is no such step.
GazeInput gaze_of_step(const ReplayView& view, std::int64_t step);

}  // namespace impetus
