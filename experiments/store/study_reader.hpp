// What a replay needs of a study: every attempt with the inputs that decided it. And what it adds:
// the truth of recorded collisions, kept apart from the record.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/scheduling/viewer.hpp"
#include "experiments/record/gaze.hpp"
#include "experiments/record/gaze_correction.hpp"
#include "experiments/record/record.hpp"
#include "experiments/run/collision_truth.hpp"
#include "experiments/store/enrolment.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline store {

/// One showing of a trial, under what it was recorded.
struct StoredAttempt {
  std::int64_t id{0};
  std::int64_t trial_id{0};
  std::string participant;
  std::int64_t protocol_id{0};
  StoredTrial trial;
  std::int64_t number{1};
  bool completed{false};
  std::int64_t trials_planned{0};
  int recording_format{0};
  std::string build;
  ScreenGeometry screen;
  double refresh_hz{0.0};
  bool rounding_allowed{false};
  std::int64_t onset_ns{0};
  std::optional<std::int64_t> rating;
  std::int64_t answered_ns{0};
};

/// All attempts in the order they were made.
std::vector<StoredAttempt> load_attempts(StudyFile& study);

/// A protocol's texts as they were stored. `protocol_id` must exist.
ProtocolTexts load_protocol_texts(StudyFile& study, std::int64_t protocol_id);

/// The gaze of an attempt, in order.
std::vector<GazeSample> load_gaze(StudyFile& study, std::int64_t attempt_id);

/// What its session's last calibration before the attempt does to raw samples; nothing where there
/// was none.
GazeCorrection load_gaze_correction(StudyFile& study, std::int64_t attempt_id);

/// When each click of an attempt's interval arrived (nanoseconds), in order.
std::vector<std::int64_t> load_clicks(StudyFile& study, std::int64_t attempt_id,
                                      std::int64_t interval = 1);

/// When the first frame of an interval's stimulus was flipped (nanoseconds); none: it was not.
std::optional<std::int64_t> load_onset(StudyFile& study, std::int64_t attempt_id,
                                       std::int64_t interval);

/// The last frame of an interval's stimulus.
struct LastFrame {
  std::int64_t flipped_ns{0};
  double shown_time_s{0.0};
};
std::optional<LastFrame> load_last_frame(StudyFile& study, std::int64_t attempt_id,
                                         std::int64_t interval);

/// An answer to a question other than a rating; `answer` is "" when left empty.
struct StoredResponse {
  std::string kind;
  std::string answer;
  std::optional<bool> positive;
  std::optional<bool> correct;
  bool timed_out{false};
  std::int64_t arrived_ns{0};
  std::string detail;  ///< what else its kind records: JSON
};

/// The responses of an attempt by their numbers.
std::vector<StoredResponse> load_responses(StudyFile& study, std::int64_t attempt_id);

/// Stimulus time (seconds) and missed slots of the frames of an attempt's interval that were late.
struct LateFrame {
  double shown_time_s{0.0};
  std::int64_t missed_slots{0};
};
std::vector<LateFrame> load_late_frames(StudyFile& study, std::int64_t attempt_id,
                                        std::int64_t interval = 1);

/// The frames of an attempt's timed phases, in the order shown.
std::vector<FrameRecord> load_frames(StudyFile& study, std::int64_t attempt_id);

/// Where its session showed a photodiode patch; none: it showed none.
std::optional<ScreenCorner> load_patch_corner(StudyFile& study, std::int64_t attempt_id);

/// A recorded collision; bodies by their index in the scene, b a wall where it is one.
struct StoredCollision {
  std::int64_t id{0};
  std::int64_t step{0};
  BodyPair bodies;
  std::optional<std::int64_t> first_frame{};  ///< of the stimulus; none: no frame showed it
};

/// What a replay measured of one.
struct MeasuredCollision {
  std::int64_t collision_id{0};
  CollisionTruth truth;
};

/// The collisions of an attempt's interval between bodies of `names` and walls, in order; others
/// are left out.
std::vector<StoredCollision> load_collisions(StudyFile& study, std::int64_t attempt_id,
                                             const std::vector<std::string>& names,
                                             std::int64_t interval = 1);

/// Stores them in one transaction, in place of what was measured before. Throws StoreError.
void store_truths(StudyFile& study, const std::vector<MeasuredCollision>& collisions);

}  // namespace impetus::inline store
