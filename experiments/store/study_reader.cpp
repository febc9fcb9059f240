// SPDX-License-Identifier: MIT
#include "experiments/store/study_reader.hpp"

#include <SQLiteCpp/Statement.h>

#include <utility>

namespace impetus::inline store {

std::vector<StoredAttempt> load_attempts(StudyFile& study) {
  SQLite::Statement query(
      study.database(),
      "SELECT attempt.id, trial.id, pseudonym, protocol_id, slot, phase, repetition, condition, "
      "trial.seed, number, outcome = 'completed', "
      "(SELECT count(*) FROM trial AS planned WHERE planned.enrolment_id = enrolment.id), "
      "recording_format, build, screen_width_m, screen_height_m, screen_width_px, "
      "screen_height_px, viewing_distance_m, refresh_hz, rounding_allowed, onset_ns, rating, "
      "coalesce(arrived_ns, 0), coalesce(trial.solved, '') "
      "FROM attempt JOIN trial ON trial.id = trial_id "
      "JOIN enrolment ON enrolment.id = trial.enrolment_id "
      "JOIN participant ON participant.id = participant_id "
      "JOIN session ON session.id = session_id "
      "LEFT JOIN rating ON rating.attempt_id = attempt.id ORDER BY attempt.id");
  std::vector<StoredAttempt> attempts;
  while (query.executeStep()) {
    int column = 0;
    const auto integer = [&] { return query.getColumn(column++).getInt64(); };
    const auto number = [&] { return query.getColumn(column++).getDouble(); };
    const auto text = [&] { return query.getColumn(column++).getString(); };
    StoredAttempt attempt;
    attempt.id = integer();
    attempt.trial_id = attempt.trial.id = integer();
    attempt.participant = text();
    attempt.protocol_id = integer();
    attempt.trial.slot = integer();
    attempt.trial.phase = text() == "practice" ? TrialPhase::kPractice : TrialPhase::kMain;
    attempt.trial.repetition = integer();
    attempt.trial.condition = text();
    attempt.trial.seed = static_cast<std::uint64_t>(integer());
    attempt.number = integer();
    attempt.completed = integer() != 0;
    attempt.trials_planned = integer();
    attempt.recording_format = static_cast<int>(integer());
    attempt.build = text();
    attempt.screen.width_m = number();
    attempt.screen.height_m = number();
    attempt.screen.width_px = static_cast<int>(integer());
    attempt.screen.height_px = static_cast<int>(integer());
    attempt.screen.viewing_distance_m = number();
    attempt.refresh_hz = number();
    attempt.rounding_allowed = integer() != 0;
    attempt.onset_ns = integer();
    if (!query.getColumn(column).isNull()) {
      attempt.rating = query.getColumn(column).getInt64();
    }
    ++column;
    attempt.answered_ns = integer();
    attempt.trial.solved = text();
    attempts.push_back(std::move(attempt));
  }
  return attempts;
}

ProtocolTexts load_protocol_texts(StudyFile& study, std::int64_t protocol_id) {
  SQLite::Statement query(
      study.database(), "SELECT name, hash, protocol_json, scene_json FROM protocol WHERE id = ?");
  query.bind(1, protocol_id);
  query.executeStep();
  return {query.getColumn(0).getString(), query.getColumn(1).getString(),
          query.getColumn(2).getString(), query.getColumn(3).getString()};
}

std::vector<GazeSample> load_gaze(StudyFile& study, std::int64_t attempt_id) {
  SQLite::Statement query(
      study.database(),
      "SELECT taken_ns, x_m, y_m, loss, interval FROM gaze WHERE attempt_id = ? "
      "ORDER BY sample");
  query.bind(1, attempt_id);
  std::vector<GazeSample> samples;
  while (query.executeStep()) {
    GazeSample sample{
        query.getColumn(0).getInt64(), {}, GazeLoss::kNone, query.getColumn(4).getInt64()};
    if (query.getColumn(3).isNull()) {
      sample.at = ScreenPoint{query.getColumn(1).getDouble(), query.getColumn(2).getDouble()};
    } else {
      const std::string loss = query.getColumn(3).getString();
      sample.loss = loss == "blink"        ? GazeLoss::kBlink
                    : loss == "off screen" ? GazeLoss::kOffScreen
                                           : GazeLoss::kLost;
    }
    samples.push_back(sample);
  }
  return samples;
}

GazeCorrection load_gaze_correction(StudyFile& study, std::int64_t attempt_id) {
  SQLite::Statement query(
      study.database(),
      "SELECT correction_x0_m, correction_xx, correction_xy, correction_y0_m, correction_yx, "
      "correction_yy FROM calibration JOIN attempt ON attempt.session_id = calibration.session_id "
      "WHERE attempt.id = ? AND correction_x0_m IS NOT NULL AND began_ns < onset_ns "
      "ORDER BY calibration.id DESC LIMIT 1");
  query.bind(1, attempt_id);
  if (!query.executeStep()) {
    return {};
  }
  const auto number = [&query](int column) { return query.getColumn(column).getDouble(); };
  return {number(0), number(1), number(2), number(3), number(4), number(5)};
}

std::vector<std::int64_t> load_clicks(StudyFile& study, std::int64_t attempt_id,
                                      std::int64_t interval) {
  SQLite::Statement query(study.database(),
                          "SELECT arrived_ns FROM click WHERE attempt_id = ? AND interval = ? "
                          "ORDER BY number");
  query.bind(1, attempt_id);
  query.bind(2, interval);
  std::vector<std::int64_t> arrived_ns;
  while (query.executeStep()) {
    arrived_ns.push_back(query.getColumn(0).getInt64());
  }
  return arrived_ns;
}

std::optional<std::int64_t> load_onset(StudyFile& study, std::int64_t attempt_id,
                                       std::int64_t interval) {
  SQLite::Statement query(study.database(),
                          "SELECT flipped_ns FROM frame WHERE attempt_id = ? AND interval = ? "
                          "AND phase = 'stimulus' ORDER BY frame LIMIT 1");
  query.bind(1, attempt_id);
  query.bind(2, interval);
  return query.executeStep() ? std::optional(query.getColumn(0).getInt64()) : std::nullopt;
}

std::vector<StoredResponse> load_responses(StudyFile& study, std::int64_t attempt_id) {
  SQLite::Statement query(study.database(),
                          "SELECT kind, coalesce(answer, ''), timed_out, arrived_ns, positive, "
                          "correct FROM response WHERE attempt_id = ? ORDER BY number");
  query.bind(1, attempt_id);
  const auto truth = [&](int column) {
    return query.getColumn(column).isNull() ? std::nullopt
                                            : std::optional(query.getColumn(column).getInt() != 0);
  };
  std::vector<StoredResponse> responses;
  while (query.executeStep()) {
    responses.push_back({query.getColumn(0).getString(), query.getColumn(1).getString(), truth(4),
                         truth(5), query.getColumn(2).getInt() != 0,
                         query.getColumn(3).getInt64()});
  }
  return responses;
}

std::vector<LateFrame> load_late_frames(StudyFile& study, std::int64_t attempt_id,
                                        std::int64_t interval) {
  SQLite::Statement query(study.database(),
                          "SELECT shown_time_s, missed_slots FROM frame WHERE attempt_id = ? "
                          "AND interval = ? AND phase = 'stimulus' AND missed_slots > 0 "
                          "ORDER BY frame");
  query.bind(1, attempt_id);
  query.bind(2, interval);
  std::vector<LateFrame> frames;
  while (query.executeStep()) {
    frames.push_back({query.getColumn(0).getDouble(), query.getColumn(1).getInt64()});
  }
  return frames;
}

}  // namespace impetus::inline store
