// SPDX-License-Identifier: MIT
#include "experiments/store/study_reader.hpp"

#include <SQLiteCpp/Transaction.h>

#include <algorithm>

#include "experiments/record/wall_names.hpp"
#include "experiments/store/rows.hpp"

namespace impetus::inline store {
namespace {

std::optional<std::int32_t> body_of(const std::string& name,
                                    const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) {
    return static_cast<std::int32_t>(found - names.begin());
  }
  return wall_named(name);
}

}  // namespace

std::vector<StoredAttempt> load_attempts(StudyFile& study) {
  SQLite::Statement query(
      study.database(),
      "SELECT attempt.id, trial.id, pseudonym, protocol_id, slot, phase, repetition, "
      "condition, trial.solved, trial.seed, number, outcome = 'completed', "
      "(SELECT count(*) FROM trial AS planned WHERE planned.enrolment_id = enrolment.id), "
      "recording_format, build, screen_width_m, screen_height_m, screen_width_px, "
      "screen_height_px, viewing_distance_m, refresh_hz, rounding_allowed, onset_ns, rating, "
      "arrived_ns FROM attempt JOIN trial ON trial.id = trial_id "
      "JOIN enrolment ON enrolment.id = trial.enrolment_id "
      "JOIN participant ON participant.id = participant_id "
      "JOIN session ON session.id = session_id "
      "LEFT JOIN rating ON rating.attempt_id = attempt.id ORDER BY attempt.id");
  std::vector<StoredAttempt> attempts;
  while (query.executeStep()) {
    StoredAttempt& attempt = attempts.emplace_back();
    StoredTrial& trial = attempt.trial;
    ScreenGeometry& screen = attempt.screen;
    std::string phase;
    NextColumn(query) >> attempt.id >> trial.id >> attempt.participant >> attempt.protocol_id >>
        trial.slot >> phase >> trial.repetition >> trial.condition >> trial.solved >> trial.seed >>
        attempt.number >> attempt.completed >> attempt.trials_planned >> attempt.recording_format >>
        attempt.build >> screen.width_m >> screen.height_m >> screen.width_px >> screen.height_px >>
        screen.viewing_distance_m >> attempt.refresh_hz >> attempt.rounding_allowed >>
        attempt.onset_ns >> attempt.rating >> attempt.answered_ns;
    attempt.trial_id = trial.id;
    trial.phase = phase_named(phase);
  }
  return attempts;
}

ProtocolTexts load_protocol_texts(StudyFile& study, std::int64_t protocol_id) {
  const auto [name, hash, protocol, scene] =
      load_row<std::string, std::string, std::string, std::string>(
          study.database(),
          "SELECT name, hash, protocol_json, scene_json FROM protocol WHERE id = ?", protocol_id);
  return {name, hash, protocol, scene};
}

std::vector<GazeSample> load_gaze(StudyFile& study, std::int64_t attempt_id) {
  std::vector<GazeSample> samples;
  for (const auto& [taken_ns, x_m, y_m, loss, interval] :
       load_rows<std::int64_t, double, double, std::optional<std::string>, std::int64_t>(
           study.database(),
           "SELECT taken_ns, x_m, y_m, loss, interval FROM gaze WHERE attempt_id = ? "
           "ORDER BY sample",
           attempt_id)) {
    GazeSample& sample = samples.emplace_back(GazeSample{taken_ns, {}, GazeLoss::kNone, interval});
    if (!loss) {
      sample.at = ScreenPoint{x_m, y_m};
    } else {
      sample.loss = *loss == "blink"        ? GazeLoss::kBlink
                    : *loss == "off screen" ? GazeLoss::kOffScreen
                                            : GazeLoss::kLost;
    }
  }
  return samples;
}

GazeCorrection load_gaze_correction(StudyFile& study, std::int64_t attempt_id) {
  const auto last = load_as<GazeCorrection, double, double, double, double, double, double>(
      study.database(),
      "SELECT correction_x0_m, correction_xx, correction_xy, correction_y0_m, correction_yx, "
      "correction_yy FROM calibration JOIN attempt ON attempt.session_id = calibration.session_id "
      "WHERE attempt.id = ? AND correction_x0_m IS NOT NULL AND began_ns < onset_ns "
      "ORDER BY calibration.id DESC LIMIT 1",
      attempt_id);
  return last.empty() ? GazeCorrection() : last.front();
}

std::vector<std::int64_t> load_clicks(StudyFile& study, std::int64_t attempt_id,
                                      std::int64_t interval) {
  return load_column<std::int64_t>(
      study.database(),
      "SELECT arrived_ns FROM click WHERE attempt_id = ? AND interval = ? ORDER BY number",
      attempt_id, interval);
}

std::optional<std::int64_t> load_onset(StudyFile& study, std::int64_t attempt_id,
                                       std::int64_t interval) {
  return load_value<std::int64_t>(
      study.database(),
      "SELECT flipped_ns FROM frame WHERE attempt_id = ? AND interval = ? "
      "AND phase = 'stimulus' ORDER BY frame LIMIT 1",
      attempt_id, interval);
}

std::optional<LastFrame> load_last_frame(StudyFile& study, std::int64_t attempt_id,
                                         std::int64_t interval) {
  const auto frames = load_as<LastFrame, std::int64_t, double>(
      study.database(),
      "SELECT flipped_ns, shown_time_s FROM frame WHERE attempt_id = ? AND interval = ? "
      "AND phase = 'stimulus' ORDER BY frame DESC LIMIT 1",
      attempt_id, interval);
  return frames.empty() ? std::nullopt : std::optional(frames.front());
}

std::vector<StoredResponse> load_responses(StudyFile& study, std::int64_t attempt_id) {
  return load_as<StoredResponse, std::string, std::string, std::optional<bool>, std::optional<bool>,
                 bool, std::int64_t, std::string>(
      study.database(),
      "SELECT kind, answer, positive, correct, timed_out, arrived_ns, detail FROM response "
      "WHERE attempt_id = ? ORDER BY number",
      attempt_id);
}

std::vector<LateFrame> load_late_frames(StudyFile& study, std::int64_t attempt_id,
                                        std::int64_t interval) {
  return load_as<LateFrame, double, std::int64_t>(
      study.database(),
      "SELECT shown_time_s, missed_slots FROM frame WHERE attempt_id = ? "
      "AND interval = ? AND phase = 'stimulus' AND missed_slots > 0 ORDER BY frame",
      attempt_id, interval);
}

std::vector<FrameRecord> load_frames(StudyFile& study, std::int64_t attempt_id) {
  SQLite::Statement query(
      study.database(),
      "SELECT frame, phase = 'fixation', shown_time_s, scheduled_ns, submitted_ns, flipped_ns, "
      "missed_slots, interval, patch FROM frame WHERE attempt_id = ? ORDER BY frame");
  query.bind(1, attempt_id);
  std::vector<FrameRecord> frames;
  while (query.executeStep()) {
    FrameRecord& frame = frames.emplace_back();
    Flip& flip = frame.flip;
    bool fixation = false;
    NextColumn(query) >> frame.frame >> fixation >> frame.shown_time_s >> flip.scheduled_ns >>
        flip.submitted_ns >> flip.flipped_ns >> flip.missed_slots >> frame.interval >> frame.patch;
    frame.phase = fixation ? FramePhase::kFixation : FramePhase::kStimulus;
  }
  return frames;
}

std::optional<ScreenCorner> load_patch_corner(StudyFile& study, std::int64_t attempt_id) {
  const auto corner = load_value<std::string>(
      study.database(),
      "SELECT photodiode_patch FROM session JOIN attempt ON attempt.session_id = session.id "
      "WHERE attempt.id = ?",
      attempt_id);
  return corner ? corner_named(*corner) : std::nullopt;
}

std::vector<StoredCollision> load_collisions(StudyFile& study, std::int64_t attempt_id,
                                             const std::vector<std::string>& names,
                                             std::int64_t interval) {
  std::vector<StoredCollision> collisions;
  for (const auto& [id, step, name_a, name_b, first_frame] :
       load_rows<std::int64_t, std::int64_t, std::string, std::string, std::optional<std::int64_t>>(
           study.database(),
           "SELECT id, step, body_a, body_b, first_frame FROM collision WHERE attempt_id = ? "
           "AND interval = ? ORDER BY id",
           attempt_id, interval)) {
    const auto a = body_of(name_a, names);
    const auto b = body_of(name_b, names);
    if (a && b) {
      collisions.push_back({id, step, {*a, *b}, first_frame});
    }
  }
  return collisions;
}

void store_truths(StudyFile& study, const std::vector<MeasuredCollision>& collisions) {
  try {
    SQLite::Transaction transaction(study.database());
    for (const auto& [id, truth] : collisions) {
      execute(study.database(),
              "INSERT OR REPLACE INTO collision_truth (collision_id, gap_m, gap_px, gap_arcmin, "
              "hidden_share) VALUES (?, ?, ?, ?, ?)",
              id, truth.gap_m, truth.gap_px, truth.gap_arcmin, truth.hidden_share);
    }
    transaction.commit();
  } catch (const SQLite::Exception& error) {
    throw StoreError(study.name() + ": the truth could not be saved: " + error.what());
  }
}

}  // namespace impetus::inline store
