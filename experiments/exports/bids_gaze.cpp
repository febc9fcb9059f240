// SPDX-License-Identifier: MIT
#include "experiments/exports/bids_gaze.hpp"

#include "experiments/exports/row_query.hpp"
#include "experiments/tables/csv_line.hpp"
#include "experiments/tables/tsv_line.hpp"

namespace impetus::inline exports {
namespace {

using nlohmann::ordered_json;

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

ordered_json sidecar_of(const BidsSession& session, double sampling_hz, double start_s) {
  return {{"PhysioType", "eyetrack"},
          {"Description",
           "Samples of the gaze during the stimuli, as they came, before the "
           "correction by calibration. " +
               source_words(session.gaze_source)},
          {"GazeSource", session.gaze_source},
          {"RecordedEye", "cyclopean"},
          {"SampleCoordinateSystem", "gaze-on-screen"},
          {"SamplingFrequency", sampling_hz},
          {"StartTime", start_s},
          {"Columns", {"timestamp", "x_coordinate", "y_coordinate", "trial", "attempt", "loss"}},
          {"timestamp",
           {{"Description",
             "When the sample was taken, from the first instant that the sitting "
             "recorded, as the onsets of its events; between stimuli there is none"},
            {"Units", "s"},
            {"Origin", "zero of the sitting's events"}}},
          {"x_coordinate",
           {{"LongName", "Gaze position (x)"},
            {"Description", "Right of the screen's left edge; n/a: lost"},
            {"Units", "pixel"}}},
          {"y_coordinate",
           {{"LongName", "Gaze position (y)"},
            {"Description", "Below the screen's top edge; n/a: lost"},
            {"Units", "pixel"}}},
          {"trial", {{"Description", "Place of the trial in the participant's plan, from 1"}}},
          {"attempt", {{"Description", "Number of the trial's showing"}}},
          {"loss",
           {{"Description", "Why there is no place; n/a: there is one"},
            {"Levels",
             {{"blink", "The eye was closed"},
              {"off screen", "The gaze was outside of the window"},
              {"lost", "The source knew no place"}}}}}};
}

}  // namespace

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
  ordered_json sidecar =
      sidecar_of(session, rate.hz(), static_cast<double>(first_ns - session.zero_ns) / 1e9);
  add_calibration(database, session, sidecar);
  table.json = sidecar.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
  return table;
}

}  // namespace impetus::inline exports
