// SPDX-License-Identifier: MIT
#include "experiments/exports/bids_export.hpp"

#include <nlohmann/json.hpp>

#include "experiments/exports/bids_session.hpp"
#include "experiments/exports/bids_tables.hpp"
#include "experiments/exports/embedded_bids_words.hpp"
#include "experiments/exports/row_query.hpp"
#include "experiments/exports/whole_output.hpp"
#include "experiments/tables/csv_line.hpp"
#include "experiments/tables/gzip.hpp"
#include "experiments/tables/plain_text.hpp"

namespace impetus::inline exports {
namespace {

using nlohmann::ordered_json;

constexpr const char* kBidsVersion = "1.11.0";

/// Writes the files of a dataset, and counts.
class BidsWriter {
 public:
  explicit BidsWriter(const std::filesystem::path& folder) : folder_(folder) {}

  void write(const std::string& name, std::string_view bytes) {
    std::filesystem::create_directories((folder_ / name).parent_path());
    write_output_file(folder_ / name, bytes);
    ++report_.files;
  }

  void write_json(const std::string& name, const ordered_json& value) {
    write(name, value.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
  }

  void count(std::int64_t rows) { report_.rows += rows; }
  [[nodiscard]] const ExportReport& report() const { return report_; }

 private:
  std::filesystem::path folder_;
  ExportReport report_;
};

ordered_json description(const CodebookHead& head, const std::string& names) {
  return {{"Name", "A study of collisions: " + names},
          {"BIDSVersion", kBidsVersion},
          {"DatasetType", "raw"},
          {"GeneratedBy",
           {{{"Name", "Impetus"},
             {"Version", head.build},
             {"Description", "Exported from a study file that was made by Impetus " +
                                 head.study_build + (head.anonymised ? ", anonymised" : "")}}}}};
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
  writer.write_json("participants.json", ordered_json::parse(kBidsWordsText).at("participants"));
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
  writer.write_json("dataset_description.json", description(head, protocols));
  writer.write("README", readme(head, protocols));
  write_participants(database, names, writer);
  write_stimuli(database, names, writer);
  for (const BidsSession& session : bids_sessions(database, names)) {
    write_session(database, session, factors, writer);
  }
  return writer.report();
}

}  // namespace impetus::inline exports
