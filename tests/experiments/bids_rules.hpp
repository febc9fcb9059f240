// A BIDS dataset as it lies on the disk, and the rules of version 1.11 that concern an export.
//
// The rules are from the specification (bids-specification.readthedocs.io, 1.11: "Behavioral
// experiments", "Task events", "Physiological recordings", and its schema's rules for eye
// tracking).
//
// SPDX-License-Identifier: MIT
#pragma once

#include <zlib.h>

#include <cmath>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "tests/experiments/whole_study.hpp"

namespace impetus {

using nlohmann::json;
namespace fs = std::filesystem;

inline std::string unzipped(const std::string& file) {
  gzFile stream = gzopen(file.c_str(), "rb");
  std::string text;
  std::array<char, 4096> part{};
  for (int size = 0; (size = gzread(stream, part.data(), part.size())) > 0;) {
    text.append(part.data(), static_cast<std::size_t>(size));
  }
  EXPECT_EQ(gzclose(stream), Z_OK) << file;
  return text;
}

inline std::vector<std::vector<std::string>> cells_of(const std::string& tsv) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : lines_of(tsv)) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, '\t');) {
      rows.back().push_back(cell);
    }
  }
  return rows;
}

/// A table with its heading.
struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;

  explicit Table(const std::string& tsv) : rows(cells_of(tsv)) {
    names = rows.at(0);
    rows.erase(rows.begin());
  }
  [[nodiscard]] std::size_t place(const std::string& name) const {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  }
  [[nodiscard]] const std::string& at(std::size_t row, const std::string& name) const {
    return rows.at(row).at(place(name));
  }
};

/// A dataset, and every breach of a rule that was found in it.
class Dataset {
 public:
  explicit Dataset(const fs::path& folder) : folder_(folder) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file()) {
        files_.insert(entry.path().lexically_relative(folder).string());
      }
    }
  }

  [[nodiscard]] std::vector<std::string> breaches() {
    check_top();
    for (const std::string& file : files_) {
      check_name(file);
      if (file.ends_with(".tsv")) {
        check_table(file);
      } else if (file.ends_with("_physio.tsv.gz")) {
        check_gaze(file);
      } else if (file.ends_with(".json")) {
        require(json::accept(text_of(folder_ / file)), file, "is no JSON");
      }
    }
    return breaches_;
  }

  [[nodiscard]] const std::set<std::string>& files() const { return files_; }
  /// What stands beside a table; an empty object where nothing does.
  [[nodiscard]] json sidecar(const std::string& file) const {
    const fs::path beside = folder_ / (file.substr(0, file.find(".tsv")) + ".json");
    return fs::exists(beside) ? json::parse(text_of(beside)) : json::object();
  }
  [[nodiscard]] Table table(const std::string& file) const {
    return Table(text_of(folder_ / file));
  }
  /// The one file with this ending.
  [[nodiscard]] std::string file(const std::string& ending) const {
    for (const std::string& each : files_) {
      if (each.ends_with(ending)) {
        return each;
      }
    }
    return "no " + ending;
  }
  [[nodiscard]] std::vector<std::vector<std::string>> gaze(const std::string& file) const {
    return cells_of(unzipped(folder_ / file));
  }

 private:
  void require(bool kept, const std::string& file, const std::string& rule) {
    if (!kept) {
      breaches_.push_back(file + ": " + rule);
    }
  }

  void check_top() {
    const json description = json::parse(text_of(folder_ / "dataset_description.json"));
    require(description.value("Name", "") != "", "dataset_description.json", "has no Name");
    require(description.value("BIDSVersion", "").starts_with("1.11"), "dataset_description.json",
            "is of another version");
    require(description.value("DatasetType", "") == "raw", "dataset_description.json", "not raw");
    require(description["GeneratedBy"].is_array() && description["GeneratedBy"][0].contains("Name"),
            "dataset_description.json", "GeneratedBy names nothing");
    require(text_of(folder_ / "README").size() > 150, "README", "says too little");
  }

  /// Behaviour lives in sub-<label>/ses-<label>/beh/, the labels of letters and digits.
  void check_name(const std::string& file) {
    static const std::regex kBehaviour(
        "(sub-[0-9a-zA-Z]+)/(ses-[0-9a-zA-Z]+)/beh/\\1_\\2_task-[0-9a-zA-Z]+_"
        "(events\\.(tsv|json)|beh\\.(tsv|json)|recording-eye1_physio\\.(tsv\\.gz|json))");
    static const std::regex kTop(
        "dataset_description\\.json|README|participants\\.(tsv|json)|\\.bidsignore|stimuli/.+");
    require(std::regex_match(file, kBehaviour) || std::regex_match(file, kTop), file,
            "has no name of BIDS");
    if (file.find(".tsv") != std::string::npos) {
      require(files_.count(file.substr(0, file.find(".tsv")) + ".json") > 0, file,
              "has no sidecar");
    }
  }

  void check_cells(const std::string& file, const std::vector<std::vector<std::string>>& rows,
                   std::size_t columns) {
    for (const auto& row : rows) {
      require(row.size() == columns, file, "a row has other columns");
      require(std::find(row.begin(), row.end(), "") == row.end(), file, "a cell is empty, not n/a");
    }
  }

  void check_table(const std::string& file) {
    const Table table = this->table(file);
    check_cells(file, table.rows, table.names.size());
    const std::set<std::string> unique(table.names.begin(), table.names.end());
    require(unique.size() == table.names.size(), file, "a column stands twice");
    const json words = sidecar(file);
    for (const std::string& name : table.names) {
      require(name == "participant_id" ||
                  (words.contains(name) && !words[name].value("Description", "").empty()),
              file, "column " + name + " is not described");
    }
    if (file.ends_with("_events.tsv")) {
      check_events(file, table);
    } else if (file == "participants.tsv") {
      check_participants(table);
    }
  }

  void check_events(const std::string& file, const Table& table) {
    require(table.names.at(0) == "onset" && table.names.at(1) == "duration", file,
            "onset and duration are not first");
    double latest = 0.0;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      const double onset = std::stod(table.at(row, "onset"));
      require(onset >= latest, file, "onsets fall");
      latest = onset;
      const std::string& duration = table.at(row, "duration");
      require(duration == "n/a" || std::stod(duration) >= 0.0, file, "a duration is negative");
      const std::string& stimulus = table.at(row, "stim_file");
      require(stimulus == "n/a" || files_.count("stimuli/" + stimulus) > 0, file,
              "there is no stimuli/" + stimulus);
      const std::string& type = table.at(row, "trial_type");
      require(sidecar(file)["trial_type"]["Levels"].contains(type), file,
              "the level " + type + " is not described");
      if (row > 20) {
        break;  // each level has been seen; the sidecar is parsed for every row
      }
    }
  }

  void check_participants(const Table& table) {
    require(table.names.at(0) == "participant_id", "participants.tsv",
            "participant_id is not first");
    std::set<std::string> listed;
    for (const auto& row : table.rows) {
      require(listed.insert(row[0]).second, "participants.tsv", row[0] + " stands twice");
    }
    for (const std::string& file : files_) {
      require(!file.starts_with("sub-") || listed.count(file.substr(0, file.find('/'))) > 0, file,
              "its participant is not listed");
    }
  }

  void check_gaze(const std::string& file) {
    const json words = sidecar(file);
    for (const char* field : {"SamplingFrequency", "StartTime"}) {
      require(words[field].is_number(), file, std::string("no number ") + field);
    }
    require(words.value("PhysioType", "") == "eyetrack", file, "is not of type eyetrack");
    const std::set<std::string> eyes{"left", "right", "cyclopean"};
    require(eyes.count(words.value("RecordedEye", "")) > 0, file, "RecordedEye is none");
    require(words.value("SampleCoordinateSystem", "") == "gaze-on-screen", file, "no system");
    const auto columns = words["Columns"].get<std::vector<std::string>>();
    require(columns.size() >= 3 && columns[0] == "timestamp" && columns[1] == "x_coordinate" &&
                columns[2] == "y_coordinate",
            file, "its first columns are others");
    for (const char* column : {"timestamp", "x_coordinate", "y_coordinate"}) {
      require(!words[column].value("Units", "").empty(), file, "a coordinate has no unit");
    }
    const auto rows = gaze(file);
    check_cells(file, rows, columns.size());
    double latest = -1.0;
    for (const auto& row : rows) {
      require(row[0].find_first_not_of("0123456789.e-") == std::string::npos, file,
              "has a heading");
      require(std::stod(row[0]) >= latest, file, "timestamps fall");
      latest = std::stod(row[0]);
    }
    check_screen(file);
  }

  /// Gaze on a screen needs the screen, in the sidecar of the events beside it.
  void check_screen(const std::string& file) {
    const std::string events = file.substr(0, file.find("_recording")) + "_events.tsv";
    require(files_.count(events) > 0, file, "has no events beside it");
    const json screen = sidecar(events)["StimulusPresentation"];
    require(screen["ScreenDistance"].is_number(), events, "ScreenDistance is missing");
    require(screen["ScreenOrigin"] == json::array({"top", "left"}), events, "ScreenOrigin");
    for (const char* field : {"ScreenSize", "ScreenResolution"}) {
      require(screen[field].is_array() && screen[field].size() == 2, events, field);
    }
    require(screen["ScreenSize"][0].get<double>() < 5.0, events, "ScreenSize is not in metres");
  }

  fs::path folder_;
  std::set<std::string> files_;
  std::vector<std::string> breaches_;
};

}  // namespace impetus
