// One recorded trial, re-simulated, as the viewer plays it: plain data.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/dynamics/body.hpp"
#include "experiments/gaze/gaze_trail.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/record/record.hpp"
#include "experiments/record/staged_scene.hpp"
#include "experiments/run/body_detail.hpp"

namespace impetus::inline viewing {

/// Of a step: a time that was set by step k may come back so much off k.
inline constexpr double kStepRounding = 1e-6;

/// A moment (end_s == begin_s) or a stretch on the timeline, seconds from onset.
struct TimelineMark {
  /// What happened then.
  enum class Kind {
    kContact,          ///< when two bodies are to meet
    kHold,             ///< the imposed freeze after it
    kFineCollision,    ///< a contact that began at the finest level
    kCoarseCollision,  ///< one that began at a coarser level, whatever stopped it there
    kClick,
    kResponse,
    kLateFrame,
    kGazeLost,  ///< a stretch without valid samples
    kParting    ///< when the eye could first tell it from the simulation at the finest level
  };
  Kind kind{Kind::kContact};
  double begin_s{0.0};
  double end_s{0.0};
  std::string label;  ///< "": the kind says it all
};

/// A contact of a step, as the response got it.
struct StepContact {
  BodyPair bodies;
  TouchPoint touch;
};

/// What is shown of a trial, and when.
struct ReplayView {
  std::string title;               ///< "P01 · trial 37 of 87 · main"
  std::vector<std::string> facts;  ///< "delay_ms 100", "rated 2", ...
  Viewer viewer;                   ///< at the onset
  ViewerTurn turn;
  std::vector<DrawnBody> looks;
  Flashing flashing;
  std::optional<Enclosure> enclosure;
  std::shared_ptr<const Appearance> appearance;
  double step_hz{240.0};
  double duration_s{0.0};
  std::vector<std::vector<BodyState>> states;  ///< [step][body], step 0 is the start
  std::vector<GazeInput> gaze;  ///< [step], what the step was told; nothing for step 0
  std::vector<TimelineMark> marks;
  bool agrees{true};                                     ///< every step's hash as recorded
  std::vector<std::vector<BodyDetail>> details;          ///< [step][body], of collisions
  int finest_level{0};                                   ///< of all bodies' trees
  std::vector<std::vector<StepContact>> contacts;        ///< [step]
  std::vector<std::shared_ptr<const VolumeTree>> trees;  ///< [body]
  std::vector<TimedGaze> samples;                        ///< of the gaze, corrected
};

/// Of an interrupted trial, takes away the time and the marks after its last step.
void end_with_last_step(ReplayView& view);

/// Where the participant looked in a step and what region it had; nothing when the step was told
/// neither, or there is no such step.
GazeInput gaze_of_step(const ReplayView& view, std::int64_t step);

/// The last step at or before a time, and no later than there are.
std::int64_t step_at(const ReplayView& view, double time_s);

/// The bodies at a time, poses between steps included. Precondition: there is a state.
std::vector<PosedBody> bodies_at(const ReplayView& view, double time_s);

/// The detail of each body's collisions at a step; none where it is not known.
std::vector<BodyDetail> details_at(const ReplayView& view, std::int64_t step);

/// A contact that is kept in view for kDetailInView_s, since it lasts a step.
struct FadingContact {
  TouchPoint touch;
  double freshness{1.0};  ///< 1 at its step, falling to 0
};

/// Of each pair that touched lately, the contacts of the last step in which it did.
std::vector<FadingContact> contacts_at(const ReplayView& view, std::int64_t step);

/// The first step in which the eye could tell a body's place, or its turn, in one from that in the
/// other, of the same trial; none when they stay together.
std::optional<std::int64_t> parting_step(const ReplayView& recorded, const ReplayView& finest);

}  // namespace impetus::inline viewing
