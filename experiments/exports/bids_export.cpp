// SPDX-License-Identifier: MIT
#include "experiments/exports/bids_export.hpp"

#include <SQLiteCpp/Database.h>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/exports/bids_session.hpp"
#include "experiments/exports/codebook.hpp"
#include "experiments/exports/embedded_bids_events.hpp"
#include "experiments/exports/embedded_bids_words.hpp"
#include "experiments/exports/export_table.hpp"
#include "experiments/exports/gzip.hpp"
#include "experiments/exports/row_query.hpp"
#include "experiments/exports/whole_output.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "experiments/tables/csv_line.hpp"
#include "experiments/tables/number_text.hpp"
#include "experiments/tables/plain_text.hpp"

namespace impetus::inline exports {
namespace {

using nlohmann::ordered_json;

/// A table of what happened in a sitting and the JSON beside it; no rows: there is nothing to
/// write. What stood in for gaze is said in the JSON: a mouse is no eye.
struct BidsTable {
  std::string tsv;
  std::string json;
  std::int64_t rows{0};
};

/// What the sidecars say, by table: bids_words.json.
const ordered_json& table_words(const char* table) {
  static const ordered_json kWords = ordered_json::parse(kBidsWordsText);
  return kWords.at(table);
}

/// What can happen in a trial, by name: the stimulus, an answer of each kind, and what else there
/// is.
ordered_json event_types() {
  ordered_json types;
  for (const auto& [name, words] : table_words("events")["trial_type"]["Levels"].items()) {
    types[name] = words;
    if (name == "stimulus") {
      for (const ResponseKind& kind : listed_kinds()) {
        types[kind.name] = kind.event;
      }
    }
  }
  return types;
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
  const auto count = static_cast<int>(table_words("events").size());
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

/// Without the task's name, which the file's has: older validators take every key for a column.
std::string event_sidecar(const BidsSession& session, const FactorLabels& factors) {
  ordered_json sidecar = table_words("events");
  sidecar["trial_type"]["Levels"] = event_types();
  for (const auto& [name, label] : factors) {
    ordered_json& words = sidecar["factor_" + tsv_text(name)];
    words["Description"] = "Level of this factor of the trial's condition" +
                           (label.empty() ? "" : ": " + as_utf8(label));
    if (const std::string unit = unit_of(name); !unit.empty()) {
      words["Units"] = unit;
    }
  }
  sidecar["stim_file"] = table_words("stim_file");
  sidecar["StimulusPresentation"] = session.presentation;
  return dumped(sidecar);
}

std::string event_heading(const FactorLabels& factors) {
  std::vector<std::string> names;
  for (const auto& [name, words] : table_words("events").items()) {
    names.push_back(name);
  }
  for (const auto& [name, label] : factors) {
    names.push_back("factor_" + tsv_text(name));
  }
  names.emplace_back("stim_file");
  return tsv_line(names);
}

constexpr const char* kSamples =
    "SELECT gaze.taken_ns, gaze.x_m, gaze.y_m, trial.slot, attempt.number, gaze.loss, attempt.id "
    "FROM gaze JOIN attempt ON attempt.id = gaze.attempt_id JOIN trial ON trial.id = "
    "attempt.trial_id WHERE attempt.session_id = ?1 AND attempt.onset_ns > 0 "
    "ORDER BY gaze.taken_ns, attempt.id, gaze.sample";

/// Samples between which no stimulus ended, and how long they took.
class MeasuredRate {
 public:
  void add(std::int64_t attempt, std::int64_t taken_ns) {
    if (attempt == attempt_ && taken_ns > taken_ns_) {
      ++steps_;
      span_ns_ += taken_ns - taken_ns_;
    }
    attempt_ = attempt;
    taken_ns_ = taken_ns;
  }

  [[nodiscard]] double hz() const {
    return span_ns_ > 0 ? static_cast<double>(steps_) * 1e9 / static_cast<double>(span_ns_) : 0.0;
  }

 private:
  std::int64_t attempt_{-1};
  std::int64_t taken_ns_{0};
  std::int64_t steps_{0};
  std::int64_t span_ns_{0};
};

std::string pixels(const RowQuery& query, int column, double centre_px, double px_per_m) {
  return query.is_null(column) ? "" : exact_number(centre_px + query.number(column) * px_per_m);
}

std::string sample_line(const RowQuery& query, const BidsSession& session) {
  const auto width_px = static_cast<double>(session.screen_width_px);
  const auto height_px = static_cast<double>(session.screen_height_px);
  return tsv_line({exact_number(static_cast<double>(query.integer(0) - session.zero_ns) / 1e9),
                   pixels(query, 1, 0.5 * width_px, width_px / session.screen_width_m),
                   pixels(query, 2, 0.5 * height_px, -height_px / session.screen_height_m),
                   std::to_string(query.integer(3)), std::to_string(query.integer(4)),
                   query.is_null(5) ? "" : tsv_text(query.bytes(5))});
}

/// In words, what the samples are of.
std::string source_words(const std::string& source) {
  if (source == "mouse") {
    return "The mouse pointer stands in for the gaze: no eye was recorded, and these samples "
           "support no claim about where anybody looked.";
  }
  return "Source of the samples, as the program calls it: " + source + ".";
}

void add_calibration(SQLite::Database& database, const BidsSession& session,
                     ordered_json& sidecar) {
  RowQuery query(database,
                 "SELECT count(*), (SELECT accuracy_deg FROM calibration WHERE session_id = ?1 AND "
                 "kind = 'validation' ORDER BY id DESC LIMIT 1), (SELECT worst_accuracy_deg FROM "
                 "calibration WHERE session_id = ?1 AND kind = 'validation' ORDER BY id DESC LIMIT "
                 "1) FROM calibration WHERE session_id = ?1 AND kind = 'calibration'",
                 {std::to_string(session.id)});
  if (query.step()) {
    sidecar["CalibrationCount"] = query.integer(0);
    if (!query.is_null(1) && !query.is_null(2)) {
      sidecar["AverageCalibrationError"] = query.number(1);
      sidecar["MaximalCalibrationError"] = query.number(2);
    }
  }
}

/// `_events.tsv`, by onset (seconds from the sitting's zero). Throws StoreError.
BidsTable bids_events(SQLite::Database& database, const BidsSession& session,
                      const FactorLabels& factors) {
  BidsTable table{event_heading(factors), event_sidecar(session, factors), 0};
  RowQuery query(database, kBidsEventsSql, {std::to_string(session.id)});
  while (query.step()) {
    if (!query.is_null(0)) {  // without frames nothing tells when a second stimulus began
      table.tsv += event_line(query, session, factors);
      ++table.rows;
    }
  }
  return table;
}

/// `_beh.tsv`: what was answered outside trials, which has no onset. Throws StoreError.
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
  ordered_json sidecar = table_words("answers");
  sidecar["TaskName"] = session.task_name;
  table.json = dumped(sidecar);
  return table;
}

/// `_physio.tsv` before it is compressed: no heading, columns timestamp (seconds from the sitting's
/// zero), x_coordinate, y_coordinate (pixels right of and below the screen's top left corner), then
/// trial, attempt and loss. Throws StoreError.
BidsTable bids_gaze(SQLite::Database& database, const BidsSession& session) {
  BidsTable table;
  MeasuredRate rate;
  std::int64_t first_ns = session.zero_ns;
  RowQuery query(database, kSamples, {std::to_string(session.id)});
  while (query.step()) {
    first_ns = table.rows == 0 ? query.integer(0) : first_ns;
    rate.add(query.integer(6), query.integer(0));
    table.tsv += sample_line(query, session);
    ++table.rows;
  }
  ordered_json sidecar = table_words("gaze");
  sidecar["Description"] =
      sidecar["Description"].get<std::string>() + source_words(session.gaze_source);
  sidecar["GazeSource"] = session.gaze_source;
  sidecar["SamplingFrequency"] = rate.hz();
  sidecar["StartTime"] = static_cast<double>(first_ns - session.zero_ns) / 1e9;
  add_calibration(database, session, sidecar);
  table.json = dumped(sidecar);
  return table;
}

constexpr const char* kBidsVersion = "1.11.0";

/// Writes the files of a dataset, and counts.
class BidsWriter {
 public:
  explicit BidsWriter(const std::filesystem::path& folder) : folder_(folder) {}

  void write(const std::string& name, std::string_view bytes) {
    std::filesystem::create_directories((folder_ / name).parent_path());
    write_output_file(folder_ / name, bytes);
    names_.push_back(name);
    ++report_.files;
  }

  void write_json(const std::string& name, const ordered_json& value) {
    write(name, dumped(value));
  }

  void count(std::int64_t rows) { report_.rows += rows; }
  [[nodiscard]] const ExportReport& report() const { return report_; }
  /// Of the files so far.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

 private:
  std::filesystem::path folder_;
  std::vector<std::string> names_;
  ExportReport report_;
};

constexpr const char* kDescriptionName = "dataset_description.json";

/// `files` are all others of the dataset: a later export knows by them what it may replace
/// (earlier_export.hpp).
ordered_json description(const CodebookHead& head, const std::string& names,
                         std::vector<std::string> files) {
  files.emplace_back(kDescriptionName);
  return {{"Name", "A study of collisions: " + names},
          {"BIDSVersion", kBidsVersion},
          {"DatasetType", "raw"},
          {"GeneratedBy",
           {{{"Name", "Impetus"},
             {"Version", head.build},
             {"Description", "Exported from a study file that was made by Impetus " +
                                 head.study_build + (head.anonymised ? ", anonymised" : "")},
             {"Files", files}}}}};
}

std::string readme(const CodebookHead& head, const std::string& names) {
  std::string text =
      "Trials of an experiment on simulated collisions: " + names + ".\n\nExported by " +
      head.build +
      ". Each participant's sittings are sessions. Times are seconds from\nthe first instant that "
      "a sitting recorded. Where gaze was followed, the JSON beside its samples says what\nstood "
      "in for it: samples from a mouse support no claim about where anybody looked. stimuli/ "
      "holds each\nprotocol and its scene; a trial's factors change the scene as the protocol "
      "says.\n\nFrames, steps of the simulation, notes and exclusions have no place in BIDS: "
      "`impetus export --format csv`\nwrites all that a study holds.\n";
  return head.anonymised ? text +
                               "\nAnonymised: codes are new; demographic answers, free text, "
                               "names of machines and dates are left out.\n"
                         : text;
}

std::string protocol_names(SQLite::Database& database) {
  std::string names;
  RowQuery query(database, "SELECT DISTINCT name FROM protocol ORDER BY name");
  while (query.step()) {
    names += (names.empty() ? "" : ", ") + tsv_text(query.bytes(0));
  }
  return names.empty() ? "no protocol" : names;
}

void write_participants(SQLite::Database& database, const BidsNames& names, BidsWriter& writer) {
  std::string table = tsv_line({"participant_id", "code", "simulated"});
  RowQuery query(database, "SELECT id, pseudonym, simulated FROM participant ORDER BY id");
  while (query.step()) {
    table += tsv_line({"sub-" + names.participants.at(query.integer(0)), tsv_text(query.bytes(1)),
                       std::to_string(query.integer(2))});
    writer.count(1);
  }
  writer.write("participants.tsv", table);
  writer.write_json("participants.json", table_words("participants"));
}

void write_stimuli(SQLite::Database& database, const BidsNames& names, BidsWriter& writer) {
  RowQuery query(database, "SELECT id, protocol_json, scene_json FROM protocol ORDER BY id");
  while (query.step()) {
    const std::string& task = names.tasks.at(query.integer(0));
    writer.write("stimuli/" + task + "_protocol.json", query.bytes(1));
    writer.write("stimuli/" + bids_scene_file(task), query.bytes(2));
  }
}

void write_table(const BidsTable& table, const std::string& name, BidsWriter& writer) {
  if (table.rows > 0) {
    writer.write(name + ".tsv", table.tsv);
    writer.write(name + ".json", table.json);
    writer.count(table.rows);
  }
}

void write_session(SQLite::Database& database, const BidsSession& session,
                   const FactorLabels& factors, BidsWriter& writer) {
  const std::string stem = session.folder + session.stem;
  write_table(bids_answers(database, session), stem + "_beh", writer);
  if (!session.has_clock) {
    return;
  }
  write_table(bids_events(database, session, factors), stem + "_events", writer);
  const BidsTable gaze = bids_gaze(database, session);
  if (gaze.rows > 0) {
    writer.write(stem + "_recording-eye1_physio.tsv.gz", gzip(gaze.tsv));
    writer.write(stem + "_recording-eye1_physio.json", gaze.json);
    writer.count(gaze.rows);
  }
}

}  // namespace

ExportReport export_bids(StudyFile& study, const CodebookHead& head,
                         const std::filesystem::path& folder) {
  SQLite::Database& database = study.database();
  const BidsNames names = bids_names(database);
  const FactorLabels factors = factor_labels(database);
  const std::string protocols = protocol_names(database);
  BidsWriter writer(folder);
  writer.write("README", readme(head, protocols));
  write_participants(database, names, writer);
  write_stimuli(database, names, writer);
  for (const BidsSession& session : bids_sessions(database, names)) {
    write_session(database, session, factors, writer);
  }
  writer.write_json(kDescriptionName, description(head, protocols, writer.names()));
  return writer.report();
}

}  // namespace impetus::inline exports
