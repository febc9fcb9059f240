// SPDX-License-Identifier: MIT
#include "experiments/files/gaze_file.hpp"

#include <csv.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/models/readable_file.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline files {
namespace {

using Line = std::vector<std::string>;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
using Unit = GazeRecording::Unit;

/// A name for times, how long one of its units is, and whether it counts from the onset.
struct TimeName {
  const char* name;
  double unit_s;
  bool from_onset;
};

constexpr TimeName kTimes[] = {{"time_s", 1.0, true},
                               {"stimulus_time_s", 1.0, true},
                               {"time_ms", 1e-3, true},
                               {"time_us", 1e-6, true},
                               {"TIMESTAMP", 1e-3, false},
                               {"gaze_timestamp", 1.0, false},
                               {"Recording timestamp [ms]", 1e-3, false},
                               {"Recording timestamp [μs]", 1e-6, false},
                               {"Recording timestamp [µs]", 1e-6, false}};

/// Names for places, and their unit.
struct PlaceNames {
  const char* x;
  const char* y;
  Unit unit;
};

constexpr PlaceNames kPlaces[] = {{"x_m", "y_m", Unit::kMetres},
                                  {"x_deg", "y_deg", Unit::kDegrees},
                                  {"x_px", "y_px", Unit::kPixels},
                                  {"x_share", "y_share", Unit::kSharesDown},
                                  {"AVERAGE_GAZE_X", "AVERAGE_GAZE_Y", Unit::kPixels},
                                  {"RIGHT_GAZE_X", "RIGHT_GAZE_Y", Unit::kPixels},
                                  {"LEFT_GAZE_X", "LEFT_GAZE_Y", Unit::kPixels},
                                  {"norm_pos_x", "norm_pos_y", Unit::kSharesUp},
                                  {"Gaze point X", "Gaze point Y", Unit::kPixels}};

constexpr const char* kTrials[] = {"trial", "trial_id", "TRIAL_INDEX"};

/// A column that says whether a sample counts, and what it says where it does.
struct ValidityName {
  const char* name;
  bool (*counts)(const std::string& cell);
};

std::optional<double> number(const std::string& cell) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  const bool is_whole = error == std::errc() && end == cell.data() + cell.size();
  return is_whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

constexpr ValidityName kValidities[] = {
    {"valid",
     [](const std::string& cell) { return cell == "1" || cell == "TRUE" || cell == "true"; }},
    {"loss", [](const std::string& cell) { return cell.empty(); }},
    {"confidence", [](const std::string& cell) { return number(cell).value_or(0.0) >= 0.6; }},
    {"Validity left", [](const std::string& cell) { return cell == "Valid" || cell == "0"; }}};

std::string text_of(const std::filesystem::path& file) {
  try {
    return file_bytes(file);
  } catch (const std::runtime_error& error) {
    throw InputError(file.string() + ": " + error.what());
  }
}

/// The lines of a table; libcsv takes them apart.
class Lines {
 public:
  static std::vector<Line> of(const std::string& text) {
    Lines lines;
    csv_parser parser;
    csv_init(&parser, CSV_APPEND_NULL);
    csv_set_delim(&parser, static_cast<unsigned char>(separator_of(text)));
    const std::size_t begin = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
    csv_parse(&parser, text.data() + begin, text.size() - begin, take_cell, take_line, &lines);
    csv_fini(&parser, take_cell, take_line, &lines);
    csv_free(&parser);
    return std::move(lines.all_);
  }

 private:
  /// Of comma, tab and semicolon, the one that the line of names has most of.
  static char separator_of(const std::string& text) {
    const std::string names = text.substr(0, text.find('\n'));
    const auto count = [&](char one) { return std::count(names.begin(), names.end(), one); };
    return std::max({',', '\t', ';'}, [&](char a, char b) { return count(a) < count(b); });
  }
  static void take_cell(void* cell, std::size_t size, void* lines) {
    static_cast<Lines*>(lines)->line_.emplace_back(static_cast<const char*>(cell), size);
  }
  static void take_line(int /*ended_by*/, void* lines) {
    auto* own = static_cast<Lines*>(lines);
    own->all_.push_back(std::move(own->line_));
    own->line_.clear();
  }

  std::vector<Line> all_;
  Line line_;
};

/// What a file's columns are.
class GazeColumns {
 public:
  GazeColumns(const std::string& file, const Line& names) : file_(file), names_(names) {
    find_time();
    find_place();
    for (const char* name : kTrials) {
      trial_ = trial_ ? trial_ : find(name);
    }
    phase_ = find("trial_phase");
    outcome_ = find("attempt_outcome");
    participant_ = find("participant");
    for (const ValidityName& name : kValidities) {
      if (const auto column = find(name.name)) {
        validities_.emplace_back(*column, name.counts);
      }
    }
  }

  [[nodiscard]] Unit unit() const { return place_->unit; }
  [[nodiscard]] bool from_onset() const { return time_->from_onset; }
  [[nodiscard]] bool is_main(const Line& line) const {
    return (!phase_ || cell(line, *phase_) == "main") &&
           (!outcome_ || cell(line, *outcome_) == "completed");
  }
  [[nodiscard]] std::string participant(const Line& line) const {
    return participant_ ? cell(line, *participant_) : "";
  }
  [[nodiscard]] std::string trial(const Line& line) const {
    return trial_ ? cell(line, *trial_) : "";
  }

  /// `number_of_line` is for sentences.
  [[nodiscard]] GazeRecording::Sample sample(const Line& line, std::size_t number_of_line) const {
    const std::optional<double> time = number(cell(line, time_column_));
    if (!time) {
      throw InputError(file_ + ":" + std::to_string(number_of_line) +
                       ": expected a number in the column \"" + time_->name + "\", got \"" +
                       cell(line, time_column_) + "\"");
    }
    const std::optional<double> x = number(cell(line, x_));
    const std::optional<double> y = number(cell(line, y_));
    bool valid = x && y;
    for (const auto& [column, counts] : validities_) {
      valid = valid && counts(cell(line, column));
    }
    return {*time * time_->unit_s, x.value_or(0.0), y.value_or(0.0), valid};
  }

 private:
  static std::string cell(const Line& line, std::size_t column) {
    return column < line.size() ? line[column] : "";
  }
  [[nodiscard]] std::optional<std::size_t> find(const std::string& name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    return found == names_.end() ? std::nullopt
                                 : std::optional(static_cast<std::size_t>(found - names_.begin()));
  }

  void find_time() {
    std::string all;
    for (const TimeName& name : kTimes) {
      all += (all.empty() ? "" : ", ") + std::string(name.name);
      if (const auto column = find(name.name)) {
        if (time_ != nullptr) {
          refuse("one column of times, got " + std::string(time_->name) + " and " + name.name);
        }
        time_ = &name;
        time_column_ = *column;
      }
    }
    if (time_ == nullptr) {
      refuse("a column of times (" + all + ")");
    }
  }

  /// The first of the list: a file may have both eyes, and their mean.
  void find_place() {
    std::string all;
    for (const PlaceNames& names : kPlaces) {
      all += (all.empty() ? "" : ", ") + std::string(names.x);
      const auto x = find(names.x);
      const auto y = find(names.y);
      if (x && !y) {
        refuse("a column " + std::string(names.y) + " beside " + names.x);
      }
      if (x && place_ == nullptr) {
        place_ = &names;
        x_ = *x;
        y_ = *y;
      } else if (x && names.unit != place_->unit) {
        refuse("places in one unit, got " + std::string(place_->x) + " and " + names.x);
      }
    }
    if (place_ == nullptr) {
      refuse("columns of places (" + all + " and y)");
    }
  }

  [[noreturn]] void refuse(const std::string& expected) const {
    throw InputError(file_ + ":1: expected " + expected);
  }

  const std::string& file_;
  const Line& names_;
  const TimeName* time_{nullptr};
  const PlaceNames* place_{nullptr};
  std::size_t time_column_{0};
  std::size_t x_{0};
  std::size_t y_{0};
  std::optional<std::size_t> trial_;
  std::optional<std::size_t> phase_;
  std::optional<std::size_t> outcome_;
  std::optional<std::size_t> participant_;
  std::vector<std::pair<std::size_t, bool (*)(const std::string&)>> validities_;
};

}  // namespace

GazeRecording load_gaze_recording(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::vector<Line> lines = Lines::of(text_of(file));
  if (lines.empty()) {
    throw InputError(name + ": expected a line of names and lines of samples, got an empty file");
  }
  const GazeColumns columns(name, lines[0]);
  GazeRecording recording;
  recording.unit = columns.unit();
  std::string trial;
  double first_s = 0.0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (!columns.is_main(lines[i])) {
      continue;
    }
    if (columns.participant(lines[i]) != columns.participant(lines[1])) {
      throw InputError(name + ":" + std::to_string(i + 1) +
                       ": expected the gaze of one participant, got " +
                       columns.participant(lines[1]) + " and " + columns.participant(lines[i]));
    }
    GazeRecording::Sample sample = columns.sample(lines[i], i + 1);
    if (recording.trials.empty() || columns.trial(lines[i]) != trial) {
      trial = columns.trial(lines[i]);
      recording.trials.emplace_back();
      first_s = columns.from_onset() ? 0.0 : sample.time_s;
    }
    sample.time_s -= first_s;
    std::vector<GazeRecording::Sample>& samples = recording.trials.back();
    if (!samples.empty() && sample.time_s < samples.back().time_s) {
      throw InputError(name + ":" + std::to_string(i + 1) +
                       ": expected times that go on within a trial, got one before the last");
    }
    samples.push_back(sample);
  }
  if (recording.trials.empty()) {
    throw InputError(name + ": expected lines of samples after the names, got none");
  }
  return recording;
}

}  // namespace impetus::inline files
