// What is recorded of a session, as plain data. See experiments/store/schema.sql for each column.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/world/world.hpp"
#include "experiments/design/design.hpp"
#include "experiments/record/frame_grid.hpp"
#include "experiments/record/gaze.hpp"
#include "experiments/record/gaze_correction.hpp"
#include "experiments/record/markers.hpp"
#include "experiments/record/sound.hpp"
#include "experiments/record/wall_names.hpp"

namespace impetus::inline record {

/// What a step was told of the participant's gaze.
struct GazeInput {
  Fixation fixation{};
  std::int64_t taken_ns{0};            ///< when the sample behind it was taken; 0 without one
  std::int64_t age_ns{0};              ///< of that sample when the step was computed
  std::optional<GazeRegion> region{};  ///< of high priority
};

/// One step of the world: its input beyond the trial's own, and proof of its outcome. Step 0 is
/// the state at the start.
struct StepRecord {
  std::int64_t step{0};
  std::int64_t work_granted{0};  ///< of refinement
  std::int64_t work_spent{0};
  std::uint32_t degradations{0};
  StateHash state;
  GazeInput gaze{};
  std::int64_t shown_frame{-1};   ///< of the attempt's frames, the first to show it; −1: none
  std::int64_t pops{0};           ///< pairs that touch at a coarser level than in the step before
  std::int64_t stopped_short{0};  ///< pairs that were stopped where they entered each other
  double largest_pop_deg{0.0};    ///< visual angle; of no pop, 0
  std::int64_t interval{1};       ///< of a two-interval trial, its first or second stimulus
  std::vector<NotFiniteBody> not_finite{};  ///< taken out in it; stored as notes of the session
  WorkGrants cut_work{};                    ///< of phases, but refinement, that were refused some
};

/// What replays the step, given to FixedWork.
inline WorkGrants grants_of(const StepRecord& step) {
  WorkGrants grants = step.cut_work;
  grants.of(WorkPhase::kRefinement) = step.work_granted;
  return grants;
}

/// Why a refinement is where it is, as it is kept, by StopReason.
inline constexpr std::array<const char*, 5> kStopReasons{"separated", "finest", "budget",
                                                         "greatest level", "capped"};
[[nodiscard]] constexpr const char* name_of(StopReason reason) {
  return kStopReasons[static_cast<std::size_t>(reason)];
}

/// One pair in contact, at the step in which that began.
struct CollisionRecord {
  std::int64_t step{0};
  CollisionReport report;
  /// Of both bodies at the end of the step (a wall's is the world's origin); not stored, a replay
  /// has them.
  Pose pose_a;
  Pose pose_b;
  bool no_spin{false};                            ///< imposed: neither body can turn
  double eccentricity_deg{0.0};                   ///< of the contact point from the screen's centre
  std::int64_t first_frame_shown{-1};             ///< −1: no frame showed it
  double time_s{0.0};                             ///< of the stimulus
  std::optional<double> gaze_eccentricity_deg{};  ///< of the contact point from the fixation
  std::optional<double> region_eccentricity_deg{};  ///< from the centre of the step's region
  std::int64_t interval{1};
  /// As the viewer sees it when it begins: the contact's distance from the eye; mean projected
  /// speed of both bodies (a wall's is 0), and of one against the other.
  std::optional<double> distance_m{};
  std::optional<double> speed_deg_s{};
  std::optional<double> collision_speed_deg_s{};
  std::optional<double> priority{};  ///< of the scheduler's metric, in its unit
  std::optional<ImposedSpin> imposed_spin{};
};

/// What a frame is of: the cross before the stimulus, or the stimulus.
enum class FramePhase { kFixation, kStimulus };

/// One frame of a timed phase.
struct FrameRecord {
  std::int64_t frame{0};
  FramePhase phase{FramePhase::kStimulus};
  double shown_time_s{0.0};  ///< of the stimulus; 0 in the fixation phase
  Flip flip;
  std::int64_t interval{1};
  std::optional<std::int64_t> patch{};  ///< code of the photodiode patch; none: there was no patch
};

/// One rating, with the scale it was given on: scales run in opposite directions, so never pool
/// ratings without them.
struct RatingRecord {
  std::int64_t rating{0};
  std::int64_t minimum{0};
  std::int64_t maximum{0};
  std::int64_t best{0};
  std::string low_anchor;
  std::string high_anchor;
  std::string device;
  std::int64_t question_shown_ns{0};
  std::int64_t arrived_ns{0};
  std::int64_t arrival_uncertainty_ns{0};
};

/// One click during the stimulus, raw: merging is the analysis's.
struct ClickRecord {
  std::string device;  ///< "mouse", "key" or "simulated"
  std::int64_t arrived_ns{0};
  std::int64_t arrival_uncertainty_ns{0};
  std::int64_t interval{1};
};

/// One answer to a question of a trial other than a rating, or that none came, to any question.
/// Its kinds are in experiments/questions.
struct ResponseRecord {
  std::string kind;
  std::string question;
  std::string answer;                 ///< "" when timed out or left empty
  std::optional<bool> positive{};     ///< counts towards a threshold: seen, or chosen right
  std::optional<bool> correct{};      ///< none: there is no right answer
  std::vector<FactorLevel> detail{};  ///< what else the kind records, by name
  std::string device;
  std::int64_t question_shown_ns{0};
  std::int64_t arrived_ns{0};
  std::int64_t arrival_uncertainty_ns{0};
  bool timed_out{false};
};

/// Whether a showing came to its end, all answers included.
enum class AttemptOutcome { kCompleted, kInterrupted };

/// One showing of a planned trial. An interrupted trial is shown again as the next attempt.
struct AttemptRecord {
  std::int64_t slot{0};
  std::int64_t number{1};
  AttemptOutcome outcome{AttemptOutcome::kInterrupted};
  std::int64_t onset_ns{0};             ///< flip of the first frame of the (first) stimulus
  std::vector<std::string> body_names;  ///< by index in the world
  WallNaming wall_naming{WallNaming::kAxes};
  std::vector<StepRecord> steps;
  std::vector<CollisionRecord> collisions;
  std::vector<FrameRecord> frames;
  std::vector<RatingRecord> ratings;  ///< none when interrupted before, or timed out
  std::vector<ClickRecord> clicks;
  std::string gaze_source;  ///< "" when gaze was not followed
  std::vector<GazeSample> gaze;
  /// Of the enclosure's image, the share inside the region, mean over the steps that had one.
  std::optional<double> region_covered_share{};
  std::optional<double> gaze_latency_p95_ms{};  ///< sample to flip; see gaze/gaze_latency.hpp
  double intended_hold_s{0.0};
  double realised_hold_s{0.0};  ///< differs only when rounding to the display's grid was allowed
  std::int64_t late_untimed_frames{0};  ///< on the question and in the interval
  std::vector<ResponseRecord> responses{};
  std::string interrupted_by{};             ///< "pause", "display closed", "gaze lost"; or ""
  std::optional<double> gaze_lost_share{};  ///< of the stimulus, time without a valid sample
  std::optional<double> imposed_gaze_latency_s{};
  std::vector<MarkerRecord> markers{};
  std::vector<SoundRecord> sounds{};
};

/// A point of a calibration, validation or drift check: where it was shown, what the gaze did.
struct CalibrationPointRecord {
  ScreenPoint shown{};
  Fixation gaze{};  ///< mean of the valid samples, raw in a calibration, corrected in the others
  std::optional<double> accuracy_deg{};
  std::optional<double> precision_rms_deg{};
  std::optional<double> precision_sd_deg{};
  std::int64_t samples{0};
  std::int64_t lost{0};
};

/// What points were shown for: to find the correction, to judge it, or to see whether it drifted.
enum class CalibrationKind { kCalibration, kValidation, kDriftCheck };

/// One run through the points.
struct CalibrationRecord {
  CalibrationKind kind{CalibrationKind::kCalibration};
  std::int64_t number{1};       ///< try, of its kind and occasion
  std::int64_t before_slot{1};  ///< the planned trial that comes next
  std::string gaze_source;
  std::optional<double> accuracy_deg{};  ///< none: nothing valid
  std::optional<double> worst_accuracy_deg{};
  std::optional<double> precision_rms_deg{};
  std::optional<double> precision_sd_deg{};
  double lost_share{0.0};
  std::optional<double> sampling_hz{};
  double accuracy_limit_deg{0.0};
  bool passed{false};
  std::int64_t began_ns{0};
  std::vector<CalibrationPointRecord> points;
  /// Of a calibration: what is done to raw samples from now on; none: what was done before goes on.
  std::optional<GazeCorrection> correction{};
};

/// An answer outside trials. `kind`: "consent", "demographic" or "question".
struct QuestionRecord {
  std::string kind;
  std::string id;
  std::string text;    ///< the words that were asked
  std::string answer;  ///< "" when left empty
};

/// A remark. `kind`: such as "pause", "continue", "quit", "display closed", "break".
struct NoteRecord {
  std::string kind;
  std::string text;
};

}  // namespace impetus::inline record
