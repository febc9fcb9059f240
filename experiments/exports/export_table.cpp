// SPDX-License-Identifier: MIT
#include "experiments/exports/export_table.hpp"

#include <nlohmann/json.hpp>

#include "experiments/exports/row_query.hpp"

namespace impetus::inline exports {
namespace {

const std::string kWho =
    "participant.pseudonym AS participant, participant.simulated AS participant_simulated, "
    "protocol.name AS protocol, ";
const std::string kWhich =
    kWho + "trial.id AS trial_id, trial.slot AS slot, trial.phase AS trial_phase, ";
const std::string kShown =
    kWhich + "attempt.number AS attempt_number, attempt.outcome AS attempt_outcome, ";

const std::string kOfEnrolment =
    " LEFT JOIN participant ON participant.id = enrolment.participant_id"
    " LEFT JOIN protocol ON protocol.id = enrolment.protocol_id";
const std::string kOfTrial =
    " LEFT JOIN enrolment ON enrolment.id = trial.enrolment_id" + kOfEnrolment;
const std::string kOfAttempt = " LEFT JOIN trial ON trial.id = attempt.trial_id" + kOfTrial;
const std::string kOfSession =
    " LEFT JOIN enrolment ON enrolment.id = session.enrolment_id" + kOfEnrolment;

/// Rows that belong to an attempt.
ExportTable of_attempt(const std::string& file, const std::string& base, const std::string& rows,
                       const std::string& order, const std::string& more = "",
                       const std::string& joins = "") {
  const std::string attempt =
      " LEFT JOIN attempt ON attempt.id = " + base + ".attempt_id" + kOfAttempt;
  return {file, base, rows, kShown, more, attempt + joins, order, ""};
}

/// Rows that belong to a session.
ExportTable of_session(const std::string& file, const std::string& base, const std::string& rows) {
  return {file,         base,
          rows,         kWho,
          "",           " LEFT JOIN session ON session.id = " + base + ".session_id" + kOfSession,
          base + ".id", ""};
}

/// Seconds from the flip of the stimulus's first frame; of an interval's, where there are two.
std::string stimulus_time(const std::string& base, const std::string& instant) {
  return ", (" + base + "." + instant + " - CASE WHEN " + base +
         ".interval = 1 THEN nullif(attempt.onset_ns, 0) ELSE (SELECT min(frame.flipped_ns) FROM "
         "frame WHERE "
         "frame.attempt_id = " +
         base + ".attempt_id AND frame.phase = 'stimulus' AND frame.interval = " + base +
         ".interval) END) / 1e9 AS stimulus_time_s";
}

ExportTable trials() {
  const std::string outcome =
      ", coalesce(attempt.outcome, CASE WHEN EXISTS (SELECT 1 FROM attempt AS shown WHERE "
      "shown.trial_id = trial.id) THEN 'not completed' ELSE 'not shown' END) AS outcome, "
      "(SELECT count(*) FROM attempt AS shown WHERE shown.trial_id = trial.id) AS attempts, "
      "attempt.id AS attempt_id, attempt.session_id, attempt.saved_utc, attempt.onset_ns, "
      "attempt.intended_hold_ms, attempt.realised_hold_ms, attempt.timed_frames, "
      "attempt.late_timed_frames, attempt.late_untimed_frames, attempt.sync_overridden, "
      "attempt.gaze_source, attempt.gaze_latency_p95_ms, attempt.gaze_late, "
      "attempt.gaze_lost_share, attempt.imposed_gaze_latency_ms, attempt.region_covered_share";
  const std::string answers =
      ", rating.rating, rating.minimum AS rating_minimum, rating.maximum AS rating_maximum, "
      "rating.best AS rating_best, rating.low_anchor AS rating_low_anchor, "
      "rating.high_anchor AS rating_high_anchor, rating.device AS rating_device, "
      "(rating.arrived_ns - rating.question_shown_ns) / 1e6 AS rating_time_ms, "
      "(SELECT count(*) FROM response AS given WHERE given.attempt_id = attempt.id) AS responses, "
      "response.kind AS response_kind, response.question AS response_question, "
      "response.answer AS response_answer, response.positive AS response_positive, "
      "response.correct AS response_correct, response.device AS response_device, "
      "response.timed_out AS response_timed_out, "
      "(response.arrived_ns - response.question_shown_ns) / 1e6 AS response_time_ms";
  const std::string counts =
      ", CASE WHEN attempt.id IS NULL THEN NULL ELSE (SELECT count(*) FROM click WHERE "
      "click.attempt_id = attempt.id) END AS clicks, CASE WHEN attempt.id IS NULL THEN NULL ELSE "
      "(SELECT count(*) FROM collision WHERE collision.attempt_id = attempt.id) END AS collisions, "
      "EXISTS (SELECT 1 FROM excluded WHERE excluded.participant = participant.pseudonym AND "
      "(excluded.trial IS NULL OR excluded.trial = trial.id)) AS excluded, "
      "(SELECT group_concat(excluded.reason, '; ') FROM excluded WHERE excluded.participant = "
      "participant.pseudonym AND (excluded.trial IS NULL OR excluded.trial = trial.id)) "
      "AS exclusion_reasons";
  return {"trials",
          "trial",
          "One row per planned trial, shown or not, with its completed attempt and the answers",
          kWho,
          outcome + answers + counts,
          kOfTrial +
              " LEFT JOIN attempt ON attempt.trial_id = trial.id AND attempt.outcome = 'completed'"
              " LEFT JOIN rating ON rating.attempt_id = attempt.id"
              " LEFT JOIN response ON response.attempt_id = attempt.id AND response.number = 1",
          "trial.enrolment_id, trial.slot",
          ""};
}

std::vector<ExportTable> tables_of_people() {
  return {
      {"study", "study", "One row: the study file", "", "", "", "study.id", ""},
      {"merged_files", "merged_file", "One row per file that was merged into the study", "", "", "",
       "merged_file.id", ""},
      {"protocols", "protocol",
       "One row per protocol; its file and scene, as they were read, are "
       "protocols/ID-NAME-HASH.protocol.json and .scene.json",
       "", "", "", "protocol.id", "protocol.id, protocol.name, protocol.hash"},
      {"participants", "participant", "One row per participant", "", "", "", "participant.id", ""},
      {"enrolments", "enrolment", "One row per participant and protocol: the plan", kWho, "",
       kOfEnrolment, "enrolment.id", ""},
      {"sessions", "session",
       "One row per sitting: machine, display, screen, sync test, how it began and ended", kWho, "",
       kOfSession, "session.id", ""}};
}

std::vector<ExportTable> tables_of_trials() {
  const std::string truth =
      " LEFT JOIN collision_truth ON collision_truth.collision_id = "
      "collision.id";
  return {
      trials(),
      {"attempts", "attempt", "One row per showing of a trial, completed or not",
       kWho + "trial.slot AS slot, trial.phase AS trial_phase, ", "", kOfAttempt, "attempt.id", ""},
      of_attempt("ratings", "rating", "One row per rating", "rating.attempt_id"),
      of_attempt("responses", "response", "One row per answer to another question of a trial",
                 "response.attempt_id, response.number"),
      of_attempt("collisions", "collision",
                 "One row per collision, with its gap where `impetus replay --truth` measured it",
                 "collision.id",
                 ", collision_truth.gap_m, collision_truth.gap_px, collision_truth.gap_arcmin, "
                 "collision_truth.hidden_share",
                 truth),
      of_attempt("clicks", "click", "One row per click during a stimulus",
                 "click.attempt_id, click.number", stimulus_time("click", "arrived_ns")),
      of_attempt("gaze", "gaze", "One row per sample of the gaze during a stimulus, raw",
                 "gaze.attempt_id, gaze.sample", stimulus_time("gaze", "taken_ns")),
      of_attempt("frames", "frame", "One row per frame that was shown",
                 "frame.attempt_id, frame.frame"),
      of_attempt("steps", "step", "One row per step of the simulation",
                 "step.attempt_id, step.interval, step.step")};
}

std::vector<ExportTable> tables_of_sessions() {
  return {
      of_session("questionnaire", "answer",
                 "One row per question outside trials: consent, demographic and other"),
      of_session("notes", "note", "One row per note that the program made in a session"),
      of_session("calibrations", "calibration",
                 "One row per calibration, validation or drift check of the gaze"),
      {"calibration_points", "calibration_point", "One row per point of a calibration",
       kWho + "session.id AS session_id, ", "",
       " LEFT JOIN calibration ON calibration.id = calibration_point.calibration_id"
       " LEFT JOIN session ON session.id = calibration.session_id" +
           kOfSession,
       "calibration_point.calibration_id, calibration_point.point", ""},
      {"exclusions", "exclusion",
       "One row per decision to leave out a participant or a trial, or to take that back",
       "participant.pseudonym AS participant, ", "",
       " LEFT JOIN participant ON participant.id = exclusion.participant_id", "exclusion.id", ""}};
}

using nlohmann::json;

/// What a text is at a pointer; null when it is no JSON or has nothing there. What a study holds
/// is never trusted to be a protocol.
json value_at(const std::string& text, const std::string& pointer) {
  const json value = json::parse(text, nullptr, false);
  const json::json_pointer place(pointer);
  return !value.is_discarded() && value.contains(place) ? value.at(place) : json();
}

void add_labels(const std::string& protocol, FactorLabels& labels) {
  const json factors = value_at(protocol, "/design/factors");
  for (const json& factor : factors.is_array() ? factors : json::array()) {
    const json::json_pointer name("/name");
    const json::json_pointer label("/label");
    if (factor.contains(name) && factor.at(name).is_string() && factor.contains(label) &&
        factor.at(label).is_string()) {
      const auto found = labels.find(factor.at(name).get<std::string>());
      if (found != labels.end() && found->second.empty()) {
        found->second = factor.at(label).get<std::string>();
      }
    }
  }
}

}  // namespace

const std::vector<ExportTable>& export_tables() {
  static const std::vector<ExportTable> kTables = [] {
    std::vector<ExportTable> all = tables_of_people();
    for (const auto& part : {tables_of_trials(), tables_of_sessions()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return kTables;
}

const std::map<std::string, std::string>& computed_meanings() {
  static const std::map<std::string, std::string> kMeanings{
      {"outcome", "completed, not completed (it was shown), or not shown"},
      {"attempts", "how many times the trial was shown"},
      {"rating_time_ms", "from the flip that showed the question to the rating's arrival"},
      {"responses", "how many there are in responses.csv; the first of them follows"},
      {"response_time_ms", "from the flip that showed the question to the answer's arrival"},
      {"clicks", "how many; empty: not completed"},
      {"collisions", "how many; empty: not completed"},
      {"excluded", "1: left out of the analysis, by the last decision"},
      {"exclusion_reasons", "why it is left out; empty: it is not"},
      {"stimulus_time_s", "from the flip of the stimulus's first frame; empty: no frame recorded"}};
  return kMeanings;
}

std::string export_query(const ExportTable& table, const std::vector<std::string>& factors) {
  std::string levels;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    std::string name;
    for (const char letter : factors[i]) {
      name += letter == '"' ? "\"\"" : std::string(1, letter);
    }
    levels +=
        "(SELECT CASE type WHEN 'true' THEN 'true' WHEN 'false' THEN 'false' ELSE value END "
        "FROM json_each(trial.condition) WHERE key = ?" +
        std::to_string(i + 1) + ") AS \"factor_" + name + "\", ";
  }
  const std::string columns = table.columns.empty() ? table.base + ".*" : table.columns;
  return "SELECT " + table.context + levels + columns + table.more + " FROM " + table.base +
         table.joins + " ORDER BY " + table.order;
}

FactorLabels factor_labels(SQLite::Database& database) {
  FactorLabels labels;
  RowQuery names(database,
                 "SELECT DISTINCT key FROM trial, json_each(trial.condition) WHERE key IS NOT NULL "
                 "AND json_type(trial.condition) = 'object'");
  while (names.step()) {
    labels[names.text(0)] = "";
  }
  RowQuery protocols(database, "SELECT protocol_json FROM protocol ORDER BY id");
  while (protocols.step()) {
    add_labels(protocols.text(0), labels);
  }
  return labels;
}

}  // namespace impetus::inline exports
