// SPDX-License-Identifier: MIT
#include "experiments/files/gaze_file.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/files/table_lines.hpp"
#include "experiments/models/readable_file.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline files {
namespace {

constexpr double kDay_s = 86'400.0;
constexpr double kLatestOfClock_s = 1e10;  ///< such as 1.8e9, from 1970 on
constexpr double kFarthest = 1e6;          ///< of what is on no screen, in any unit
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

/// A cell for a sentence: its beginning, without what a terminal would obey.
std::string quoted_cell(const std::string& cell) {
  const std::string beginning = cell.substr(0, 60);
  return nlohmann::json(beginning).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) +
         (beginning == cell ? "" : " ...");
}

std::optional<double> number(std::string_view cell) {
  cell.remove_prefix(cell.starts_with('+') && !cell.starts_with("+-") ? 1 : 0);
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  const bool is_whole = error == std::errc() && end == cell.data() + cell.size();
  return is_whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Whether a cell is one of these words, in whatever case.
bool is_one_of(std::initializer_list<std::string_view> words, std::string cell) {
  std::transform(cell.begin(), cell.end(), cell.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return std::find(words.begin(), words.end(), cell) != words.end();
}

/// Trackers, R, Python and C write so where there is no value.
bool says_nothing(const std::string& cell) {
  return is_one_of({"", ".", "na", "n/a", "nan", "-nan"}, cell);
}

/// A column that says whether a sample counts.
struct ValidityName {
  const char* name;
  const char* expected;
  bool (*counts)(const std::string& cell);
  bool (*does_not)(const std::string& cell);  ///< where neither holds, the file is refused
};

constexpr double kLeastConfidence = 0.6;

constexpr ValidityName kValidities[] = {
    {"valid", "1, 0, true, false or nothing",
     [](const std::string& cell) {
       return is_one_of({"1", "true"}, cell);
     },
     [](const std::string& cell) {
       return is_one_of({"0", "false"}, cell) || says_nothing(cell);
     }},
    {"loss", "blink, off screen, lost or nothing", says_nothing,
     [](const std::string& cell) {
       return is_one_of({"blink", "off screen", "lost"}, cell);
     }},
    {"confidence", "a number from 0 to 1, or nothing",
     [](const std::string& cell) {
       const double confidence = number(cell).value_or(0.0);
       return confidence >= kLeastConfidence && confidence <= 1.0;
     },
     [](const std::string& cell) {
       const double confidence = number(cell).value_or(-1.0);
       return (confidence >= 0.0 && confidence < kLeastConfidence) || says_nothing(cell);
     }},
    {"Validity left", "Valid, Invalid, a whole number from 0 to 4 or nothing",
     [](const std::string& cell) {
       return is_one_of({"valid", "0"}, cell);
     },
     [](const std::string& cell) {
       return is_one_of({"invalid", "1", "2", "3", "4"}, cell) || says_nothing(cell);
     }}};

std::string text_of(const std::filesystem::path& file) {
  try {
    return file_bytes(file);
  } catch (const std::runtime_error& error) {
    throw InputError(file.string() + ": " + error.what());
  }
}

/// What a file's columns are.
class GazeColumns {
 public:
  GazeColumns(const std::string& file, const TableLine& names) : file_(file), names_(names) {
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
        validities_.emplace_back(*column, &name);
      }
    }
  }

  [[nodiscard]] Unit unit() const { return place_->unit; }
  [[nodiscard]] bool from_onset() const { return time_->from_onset; }

  /// A line that does not count may lack all else.
  [[nodiscard]] bool is_main(const TableLine& line) const {
    if (phase_ && !is_one_of({"practice", "adaptation", "main"}, line.cells[*phase_])) {
      refuse_cell(line, *phase_, "practice, adaptation or main");
    }
    if (outcome_ && !is_one_of({"completed", "interrupted", "set aside"}, line.cells[*outcome_])) {
      refuse_cell(line, *outcome_, "completed, interrupted or set aside");
    }
    return (!phase_ || is_one_of({"main"}, line.cells[*phase_])) &&
           (!outcome_ || is_one_of({"completed"}, line.cells[*outcome_]));
  }
  void require_participant_of(const TableLine& first, const TableLine& line) const {
    if (participant_ && line.cells[*participant_] != first.cells[*participant_]) {
      refuse_table_line(file_, line.number,
                        "the gaze of one participant, got " + first.cells[*participant_] + " and " +
                            line.cells[*participant_]);
    }
  }
  [[nodiscard]] std::string trial(const TableLine& line) const {
    return trial_ ? line.cells[*trial_] : "";
  }

  [[nodiscard]] GazeRecording::Sample sample(const TableLine& line) const {
    const double time_s = time(line);
    const std::optional<double> x = place(line, x_);
    const std::optional<double> y = place(line, y_);
    bool valid = x && y;
    for (const auto& [column, validity] : validities_) {
      const bool counts = validity->counts(line.cells[column]);
      if (!counts && !validity->does_not(line.cells[column])) {
        refuse_cell(line, column, validity->expected);
      }
      valid = valid && counts;
    }
    for (const std::size_t column : {x_, y_}) {
      if (valid && std::abs(*place(line, column)) > kFarthest) {
        refuse_cell(line, column, "a place from -1000000 to 1000000");
      }
    }
    return {time_s, x.value_or(0.0), y.value_or(0.0), valid};
  }

  [[noreturn]] void refuse_time(const TableLine& line, const std::string& expected) const {
    refuse_cell(line, time_column_, expected);
  }

 private:
  [[nodiscard]] double time(const TableLine& line) const {
    const std::optional<double> value = number(line.cells[time_column_]);
    if (!value) {
      refuse_time(line, "a number");
    }
    const double time_s = *value * time_->unit_s;
    if (from_onset() && std::abs(time_s) > kDay_s) {
      refuse_time(line, "a time within a day of the stimulus's onset");
    }
    if (std::abs(time_s) > kLatestOfClock_s) {
      refuse_time(line, "a clock's time within 300 years of its zero");
    }
    return time_s;
  }

  /// Nothing where the eye was lost.
  [[nodiscard]] std::optional<double> place(const TableLine& line, std::size_t column) const {
    const std::optional<double> value = number(line.cells[column]);
    if (!value && !says_nothing(line.cells[column])) {
      refuse_cell(line, column, "a number such as -1.5, or nothing where the eye was lost,");
    }
    return value;
  }

  /// Of two columns of one name it would not be said which one counts.
  [[nodiscard]] std::optional<std::size_t> find(const std::string& name) const {
    const auto begin = names_.cells.begin();
    const auto end = names_.cells.end();
    const auto found = std::find(begin, end, name);
    if (found == end) {
      return std::nullopt;
    }
    if (std::find(found + 1, end, name) != end) {
      refuse("one column " + name + ", got " + std::to_string(std::count(begin, end, name)));
    }
    return static_cast<std::size_t>(found - begin);
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
      if (x.has_value() != y.has_value()) {
        refuse("a column " + std::string(x ? names.y : names.x) + " beside " +
               (x ? names.x : names.y));
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
    refuse_table_line(file_, names_.number, expected);
  }
  [[noreturn]] void refuse_cell(const TableLine& line, std::size_t column,
                                const std::string& expected) const {
    refuse_table_line(file_, line.number,
                      expected + " in the column " + quoted_cell(names_.cells[column]) + ", got " +
                          quoted_cell(line.cells[column]));
  }

  const std::string& file_;
  const TableLine& names_;
  const TimeName* time_{nullptr};
  const PlaceNames* place_{nullptr};
  std::size_t time_column_{0};
  std::size_t x_{0};
  std::size_t y_{0};
  std::optional<std::size_t> trial_;
  std::optional<std::size_t> phase_;
  std::optional<std::size_t> outcome_;
  std::optional<std::size_t> participant_;
  std::vector<std::pair<std::size_t, const ValidityName*>> validities_;
};

}  // namespace

GazeRecording load_gaze_recording(const std::filesystem::path& file) {
  const std::string name = file.string();
  const std::vector<TableLine> lines = table_lines(name, text_of(file));
  if (lines.empty()) {
    throw InputError(name + ": expected a line of names and lines of samples, got an empty file");
  }
  const GazeColumns columns(name, lines[0]);
  GazeRecording recording;
  recording.unit = columns.unit();
  std::string trial;
  double first_s = 0.0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const TableLine& line = lines[i];
    if (!columns.is_main(line)) {
      continue;
    }
    columns.require_participant_of(lines[1], line);
    GazeRecording::Sample sample = columns.sample(line);
    if (recording.trials.empty() || columns.trial(line) != trial) {
      trial = columns.trial(line);
      recording.trials.emplace_back();
      first_s = columns.from_onset() ? 0.0 : sample.time_s;
    }
    sample.time_s -= first_s;
    std::vector<GazeRecording::Sample>& samples = recording.trials.back();
    if (!samples.empty() && sample.time_s < samples.back().time_s) {
      refuse_table_line(name, line.number,
                        "times that go on within a trial, got one before the last");
    }
    if (sample.time_s > kDay_s) {
      columns.refuse_time(line, "a time within a day of its trial's first");
    }
    samples.push_back(sample);
  }
  if (recording.trials.empty()) {
    throw InputError(name + ": expected " +
                     (lines.size() == 1 ? "lines of samples after the names, got none"
                                        : "samples of completed main trials, got none but others"));
  }
  return recording;
}

}  // namespace impetus::inline files
