// SPDX-License-Identifier: MIT
#include "experiments/session/gaze_calibration.hpp"

#include "engine/numerics/random_stream.hpp"
#include "experiments/questions/session_pages.hpp"
#include "experiments/session/calibration_pages.hpp"

namespace impetus::inline session {
namespace {

constexpr double kCalibratedShare = 0.8;  ///< of the screen's width and height
constexpr double kValidatedShare = 0.6;

std::vector<FixatedPoint> fixated(const CalibrationRecord& record) {
  std::vector<FixatedPoint> points;
  for (const CalibrationPointRecord& point : record.points) {
    if (point.gaze) {
      points.push_back({point.shown, *point.gaze});
    }
  }
  return points;
}

}  // namespace

bool GazeCalibration::calibrate(std::int64_t before_slot) {
  if (!talk_.ask(calibration_intro(ports_.gaze->is_pointer(), standing_.progress()))) {
    return false;
  }
  for (Occasion occasion{before_slot, 1};; ++occasion.number) {
    if (!take_correction(occasion)) {
      return false;
    }
    const auto validation = validate(occasion);
    if (!validation) {
      return false;
    }
    if (!validation->passed && occasion.number >= task_.most_tries) {
      return leave_to_experimenter(*validation);
    }
    const Page results =
        calibration_results(*validation, ports_.display.geometry(), standing_.progress());
    if (!talk_.ask(results)) {
      return false;
    }
    if (validation->passed) {
      return true;
    }
  }
}

bool GazeCalibration::check_drift(std::int64_t before_slot) {
  const auto found = run({ScreenPoint{}});
  if (!found) {
    return false;
  }
  const CalibrationRecord check =
      record_of(corrected(*found, ports_.gaze_correction), CalibrationKind::kDriftCheck,
                {before_slot, 1}, task_.drift_limit_deg);
  ports_.recorder.save(check);
  if (check.passed) {
    return true;
  }
  return talk_.ask(gaze_has_drifted(check, standing_.progress())).has_value() &&
         calibrate(before_slot);
}

std::optional<PointRun> GazeCalibration::run(const std::vector<ScreenPoint>& points) {
  while (true) {
    PointRun run = run_points(points, task_.point_ms, standing_.progress(), ports_);
    if (run.interruption == Interruption::kNone) {
      return run;
    }
    ports_.recorder.save(NoteRecord{"calibration interrupted",
                                    "at point " + std::to_string(run.points.size()) + " of " +
                                        std::to_string(points.size()) + "; run anew"});
    if (!talk_.handle(run.interruption)) {
      return std::nullopt;
    }
  }
}

bool GazeCalibration::take_correction(const Occasion& occasion) {
  const auto found = run(drawn_points("calibration", kCalibratedShare, occasion));
  if (!found) {
    return false;
  }
  CalibrationRecord record =
      record_of(*found, CalibrationKind::kCalibration, occasion, task_.accuracy_limit_deg);
  record.correction =
      ports_.gaze->is_pointer() ? GazeCorrection{} : fit_gaze_correction(fixated(record));
  record.passed = record.correction && record.accuracy_deg;  // a pointer needs no correction
  if (record.correction) {
    ports_.gaze_correction = *record.correction;
  }
  ports_.recorder.save(std::move(record));
  return true;
}

std::optional<CalibrationRecord> GazeCalibration::validate(const Occasion& occasion) {
  const auto found = run(drawn_points("validation", kValidatedShare, occasion));
  if (!found) {
    return std::nullopt;
  }
  CalibrationRecord record =
      record_of(corrected(*found, ports_.gaze_correction), CalibrationKind::kValidation, occasion,
                task_.accuracy_limit_deg);
  ports_.recorder.save(record);
  return record;
}

bool GazeCalibration::leave_to_experimenter(const CalibrationRecord& validation) {
  ports_.recorder.save(
      NoteRecord{"calibration not passed", "in " + std::to_string(validation.number) + " tries"});
  const auto answer = talk_.ask(
      calibration_not_passed(validation, ports_.display.geometry(), standing_.progress()));
  if (answer && answer->choice == kStopChoice) {
    ports_.recorder.save(NoteRecord{"quit", ""});
    return talk_.end(SessionEnding::kQuit);
  }
  if (answer) {
    ports_.recorder.save(NoteRecord{"poor calibration accepted", ""});
  }
  return answer.has_value();
}

std::vector<ScreenPoint> GazeCalibration::drawn_points(const char* kind, double share,
                                                       const Occasion& occasion) const {
  RandomStream order(seed_, std::string(kind) + "/" + std::to_string(occasion.before_slot) + "/" +
                                std::to_string(occasion.number));
  std::vector<ScreenPoint> points = nine_points(ports_.display.geometry(), share);
  order.shuffle(points);
  return points;
}

CalibrationRecord GazeCalibration::record_of(const PointRun& run, CalibrationKind kind,
                                             const Occasion& occasion, double limit_deg) const {
  CalibrationRecord record =
      measured(viewer_at(ports_.display.geometry(), 0.0), run.points, limit_deg);
  record.kind = kind;
  record.number = occasion.number;
  record.before_slot = occasion.before_slot;
  record.gaze_source = ports_.gaze->source();
  record.sampling_hz = run.sampling_hz;
  record.began_ns = run.began_ns;
  return record;
}

}  // namespace impetus::inline session
