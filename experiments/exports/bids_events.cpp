// SPDX-License-Identifier: MIT
#include "experiments/exports/bids_events.hpp"

#include <vector>

#include "experiments/exports/row_query.hpp"
#include "experiments/exports/unit_of.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "experiments/tables/csv_line.hpp"
#include "experiments/tables/plain_text.hpp"
#include "experiments/tables/tsv_line.hpp"

namespace impetus::inline exports {
namespace {

using nlohmann::ordered_json;

/// A column of a table, and what its sidecar says of it.
struct Column {
  const char* name;
  const char* meaning;
};

const std::vector<Column>& event_columns() {
  static const std::vector<Column> kColumns{
      {"onset", "Start of the event, from the first instant that the sitting recorded"},
      {"duration",
       "Of a stimulus, what was shown of it; of an answer, how long it took; 0 of a "
       "click, a collision or a calibration's start"},
      {"trial_type", "What happened"},
      {"trial", "Place of the trial in the participant's plan, from 1"},
      {"phase", "practice or main; practice is never pooled"},
      {"attempt", "Number of the trial's showing; more than 1: it was shown again"},
      {"outcome",
       "Of this showing: completed, interrupted or set aside; only completed ones count"},
      {"interval", "Stimulus of a two-interval trial, 1 or 2; else 1"},
      {"repetition", "Of the trial's condition"},
      {"block", "In the order shown"},
      {"catch", "1: a catch trial, outside the design"},
      {"value", "The rating or the answer that was given"},
      {"response_time", "Of an answer, from its question's flip; of a click, from the stimulus's"},
      {"body_a", "Of a collision, the name of one body in the scene"},
      {"body_b", "Of a collision, the name of the other, or of a wall"},
      {"level", "Of a collision, level of detail that was used, 0 the coarsest"},
      {"eccentricity_deg", "Of a collision, its distance from the screen's centre"},
      {"gap_arcmin", "Of a collision, the gap that was visible; n/a: not measured"}};
  return kColumns;
}

constexpr const char* kTrial =
    "shown.slot, shown.phase, shown.number, shown.outcome, %interval, shown.repetition, "
    "shown.block, shown.catch";
constexpr const char* kNoCollision = "NULL, NULL, NULL, NULL, NULL";

std::string trial_columns(const std::string& interval) {
  std::string columns = kTrial;
  return columns.replace(columns.find("%interval"), 9, interval);
}

/// In the order of event_columns(), onset in nanoseconds; then the trial's condition.
std::string event_query() {
  const std::string none = kNoCollision;
  const auto answers = [&](const std::string& table, const std::string& type,
                           const std::string& value) {
    const std::string time = "(" + table + ".arrived_ns - " + table + ".question_shown_ns) / 1e9";
    return "SELECT " + table + ".question_shown_ns, " + time + ", " + type + ", " +
           trial_columns("NULL") + ", " + value + ", " + time + ", " + none +
           ", shown.condition FROM " + table + " JOIN shown ON shown.id = " + table +
           ".attempt_id ";
  };
  const std::string second_onset =
      "(SELECT min(flipped_ns) FROM frame WHERE frame.attempt_id = shown.id AND frame.interval = 2 "
      "AND frame.phase = 'stimulus')";
  return "WITH shown AS (SELECT attempt.id, attempt.number, attempt.outcome, attempt.onset_ns, "
         "trial.slot, trial.phase, trial.repetition, trial.block, trial.catch, trial.condition "
         "FROM attempt JOIN trial ON trial.id = attempt.trial_id "
         "WHERE attempt.session_id = ?1 AND attempt.onset_ns > 0) "
         "SELECT shown.onset_ns AS at_ns, (SELECT max(shown_time_s) FROM frame WHERE "
         "frame.attempt_id = shown.id AND frame.interval = 1) AS duration_s, 'stimulus' AS type, " +
         trial_columns("1") + ", NULL, NULL, " + none +
         ", shown.condition FROM shown "
         "UNION ALL SELECT min(frame.flipped_ns), max(frame.shown_time_s), 'stimulus', " +
         trial_columns("2") + ", NULL, NULL, " + none +
         ", shown.condition FROM shown JOIN frame ON frame.attempt_id = shown.id AND "
         "frame.interval = 2 AND frame.phase = 'stimulus' GROUP BY shown.id UNION ALL " +
         answers("rating", "'rating'", "rating.rating") + "UNION ALL " +
         answers("response", "response.kind", "response.answer") +
         "UNION ALL SELECT click.arrived_ns, 0.0, 'click', " + trial_columns("click.interval") +
         ", NULL, (click.arrived_ns - CASE click.interval WHEN 1 THEN shown.onset_ns ELSE " +
         second_onset + " END) / 1e9, " + none +
         ", shown.condition FROM click JOIN shown ON shown.id = click.attempt_id "
         "UNION ALL SELECT CASE collision.interval WHEN 1 THEN shown.onset_ns ELSE " +
         second_onset + " END + CAST(collision.time_s * 1e9 AS INTEGER), 0.0, 'collision', " +
         trial_columns("collision.interval") +
         ", NULL, NULL, collision.body_a, collision.body_b, collision.level, "
         "collision.eccentricity_deg, collision_truth.gap_arcmin, shown.condition FROM collision "
         "JOIN shown ON shown.id = collision.attempt_id LEFT JOIN collision_truth ON "
         "collision_truth.collision_id = collision.id WHERE collision.time_s IS NOT NULL "
         "UNION ALL SELECT began_ns, 0.0, kind, NULL, NULL, number, NULL, NULL, NULL, NULL, NULL, "
         "accuracy_deg, NULL, " +
         none + ", NULL FROM calibration WHERE session_id = ?1 ORDER BY at_ns, type";
}

std::string cell_of(const RowQuery& query, int column) {
  switch (query.type(column)) {
    case SQLITE_INTEGER:
      return std::to_string(query.integer(column));
    case SQLITE_FLOAT:
      return exact_number(query.number(column));
    case SQLITE_TEXT:
      return tsv_text(query.bytes(column));
    default:
      return "";
  }
}

/// The factor's level in a condition, as text.
std::string level_of(const nlohmann::json& condition, const std::string& factor) {
  if (!condition.is_object() || !condition.contains(factor)) {
    return "";
  }
  const nlohmann::json& level = condition.at(factor);
  return tsv_text(level.is_string() ? level.get<std::string>() : level.dump());
}

std::string event_line(const RowQuery& query, const BidsSession& session,
                       const FactorLabels& factors) {
  const auto count = static_cast<int>(event_columns().size());
  std::vector<std::string> cells{
      exact_number(static_cast<double>(query.integer(0) - session.zero_ns) / 1e9)};
  for (int i = 1; i < count; ++i) {
    cells.push_back(cell_of(query, i));
  }
  const auto condition = nlohmann::json::parse(query.text(count), nullptr, false);
  for (const auto& [factor, label] : factors) {
    cells.push_back(level_of(condition, factor));
  }
  const bool stimulus = query.bytes(2) == "stimulus";
  cells.push_back(stimulus ? session.stimulus : "");
  return tsv_line(cells);
}

std::string dumped(const ordered_json& value) {
  return value.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

ordered_json described(const std::string& name, const std::string& meaning) {
  ordered_json words{{"Description", meaning}};
  const std::string unit =
      name == "onset" || name == "duration" || name == "response_time" ? "s" : unit_of(name);
  if (!unit.empty()) {
    words["Units"] = unit;
  }
  return words;
}

/// Without the task's name, which the file's has: older validators take every key for a column.
std::string event_sidecar(const BidsSession& session, const FactorLabels& factors) {
  ordered_json sidecar = ordered_json::object();
  for (const Column& column : event_columns()) {
    sidecar[column.name] = described(column.name, column.meaning);
  }
  ordered_json& types = sidecar["trial_type"]["Levels"];
  types["stimulus"] = "The simulated collisions were shown";
  for (const ResponseKind& kind : listed_kinds()) {
    types[kind.name] = kind.event;
  }
  types["collision"] = "Two bodies began to touch, or a body a wall";
  types["calibration"] = "A calibration of the gaze began; value is its accuracy in degrees";
  types["validation"] = "A validation of it began; value likewise";
  types["drift check"] = "A check of one point began; value likewise";
  for (const auto& [name, label] : factors) {
    sidecar["factor_" + tsv_text(name)] =
        described(name, "Level of this factor of the trial's condition" +
                            (label.empty() ? "" : ": " + as_utf8(label)));
  }
  sidecar["stim_file"] = {
      {"Description", "The scene, which the trial's factors change; within stimuli/"}};
  sidecar["StimulusPresentation"] = session.presentation;
  return dumped(sidecar);
}

std::string event_heading(const FactorLabels& factors) {
  std::vector<std::string> names;
  for (const Column& column : event_columns()) {
    names.emplace_back(column.name);
  }
  for (const auto& [name, label] : factors) {
    names.push_back("factor_" + tsv_text(name));
  }
  names.emplace_back("stim_file");
  return tsv_line(names);
}

}  // namespace

BidsTable bids_events(SQLite::Database& database, const BidsSession& session,
                      const FactorLabels& factors) {
  BidsTable table{event_heading(factors), event_sidecar(session, factors), 0};
  RowQuery query(database, event_query(), {std::to_string(session.id)});
  while (query.step()) {
    if (!query.is_null(0)) {  // without frames nothing tells when a second stimulus began
      table.tsv += event_line(query, session, factors);
      ++table.rows;
    }
  }
  return table;
}

BidsTable bids_answers(SQLite::Database& database, const BidsSession& session) {
  BidsTable table{tsv_line({"kind", "question", "words", "answer"}), "", 0};
  RowQuery query(database,
                 "SELECT kind, question, words, answer FROM answer WHERE session_id = ?1 "
                 "ORDER BY id",
                 {std::to_string(session.id)});
  while (query.step()) {
    table.tsv +=
        tsv_line({cell_of(query, 0), cell_of(query, 1), cell_of(query, 2), cell_of(query, 3)});
    ++table.rows;
  }
  table.json =
      dumped({{"TaskName", session.task_name},
              {"kind", {{"Description", "Page that asked: consent, demographic, question"}}},
              {"question", {{"Description", "Its id in the protocol"}}},
              {"words", {{"Description", "As they were asked"}}},
              {"answer", {{"Description", "As it was given; n/a: left empty"}}}});
  return table;
}

}  // namespace impetus::inline exports
