// SPDX-License-Identifier: MIT
#include "experiments/session/gaze_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/numerics/random_stream.hpp"
#include "experiments/questions/session_pages.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline session {
namespace {

std::string degrees_text(const std::optional<double>& value_deg, const Language& language) {
  const std::string text = printed("%.2f°", value_deg.value_or(0.0));
  return value_deg ? language.number(text) : language.text("unknown");
}

/// Short ones: a line that is broken is broken after the points of its numbers, too.
std::vector<std::string> accuracy_words(const CalibrationRecord& record, const Language& language) {
  if (!record.accuracy_deg) {
    return {language.text("gaze_nowhere")};
  }
  return {language.text("gaze_accuracy",
                        {{"distance", degrees_text(record.accuracy_deg, language)},
                         {"limit", degrees_text(record.accuracy_limit_deg, language)}}),
          language.text("gaze_worst",
                        {{"distance", degrees_text(record.worst_accuracy_deg, language)}})};
}

std::int64_t unseen_in(const CalibrationRecord& record) {
  std::int64_t count = 0;
  for (const CalibrationPointRecord& point : record.points) {
    count += point.gaze ? 0 : 1;
  }
  return count;
}

std::vector<std::string> quality_words(const CalibrationRecord& record, const Language& language) {
  const std::string share = language.percent(record.lost_share);
  const std::string source =
      record.gaze_source == "mouse" ? language.text("mouse") : record.gaze_source;
  const std::string rate = std::to_string(std::lround(record.sampling_hz.value_or(0.0)));
  return {language.text("gaze_precision",
                        {{"step", degrees_text(record.precision_rms_deg, language)},
                         {"spread", degrees_text(record.precision_sd_deg, language)}}),
          record.sampling_hz
              ? language.text("gaze_samples_rate",
                              {{"share", share}, {"rate", rate}, {"source", source}})
              : language.text("gaze_samples", {{"share", share}, {"source", source}})};
}

PointMap map_of(const CalibrationRecord& record, const ScreenGeometry& screen) {
  PointMap map;
  map.aspect = screen.width_m / screen.height_m;
  for (const CalibrationPointRecord& point : record.points) {
    const ScreenPoint gaze = point.gaze.value_or(ScreenPoint{});
    map.points.push_back({point.shown.x_m / screen.width_m, point.shown.y_m / screen.height_m,
                          point.gaze.has_value(), gaze.x_m / screen.width_m,
                          gaze.y_m / screen.height_m});
  }
  return map;
}

std::vector<std::string> measured_words(const CalibrationRecord& validation,
                                        const Language& language) {
  std::vector<std::string> all = accuracy_words(validation, language);
  const std::int64_t unseen = unseen_in(validation);
  if (unseen > 0 && validation.accuracy_deg) {
    all.push_back(language.counted_text("gaze_unseen", unseen));
  }
  if (validation.accuracy_deg) {
    for (std::string& words : quality_words(validation, language)) {
      all.push_back(std::move(words));
    }
  }
  return all;
}

Page with_results(const std::string& title, const CalibrationRecord& validation,
                  const ScreenGeometry& screen, Numbers numbers, const SessionProgress& progress) {
  Text text{title, {}};
  if (numbers == Numbers::kShown) {
    text.paragraphs = measured_words(validation, progress.language);
  }
  Page page = text_page(text, progress);
  page.point_map = map_of(validation, screen);
  return page;
}

}  // namespace

Page calibration_intro(bool by_pointer, const SessionProgress& progress) {
  const Language& language = progress.language;
  if (by_pointer) {
    return text_page({language.text("pointing_title"),
                      {language.text("pointing"), language.text("pointing_points")}},
                     progress);
  }
  return text_page(
      {language.text("looking_title"), {language.text("looking"), language.text("looking_points")}},
      progress);
}

Page calibration_results(const CalibrationRecord& validation, const ScreenGeometry& screen,
                         Numbers numbers, const SessionProgress& progress) {
  const Language& language = progress.language;
  if (validation.passed) {
    return with_results(language.text("gaze_went_well"), validation, screen, numbers, progress);
  }
  Page page = with_results(language.text("gaze_once_more"), validation, screen, numbers, progress);
  page.choices = {{language.text("try_again"), "space"}};
  return page;
}

Page calibration_not_passed(const CalibrationRecord& validation, const ScreenGeometry& screen,
                            const SessionProgress& progress) {
  const Language& language = progress.language;
  Page page =
      with_results(language.text("gaze_not_known"), validation, screen, Numbers::kShown, progress);
  page.paragraphs.push_back(language.text("gaze_call_experimenter"));
  page.choices = experimenter_decides({}, progress).choices;
  return page;
}

Page gaze_has_drifted(const CalibrationRecord& check, Numbers numbers,
                      const SessionProgress& progress) {
  const Language& language = progress.language;
  const std::string found =
      numbers == Numbers::kHidden ? language.text("gaze_off_middle")
      : check.accuracy_deg
          ? language.text("gaze_drifted",
                          {{"distance", degrees_text(check.accuracy_deg, language)},
                           {"limit", degrees_text(check.accuracy_limit_deg, language)}})
          : language.text("gaze_not_in_middle");
  return text_page({language.text("gaze_again_title"), {found}}, progress);
}

Page gaze_was_lost_page(double lost_share, bool by_pointer, const SessionProgress& progress) {
  const Language& language = progress.language;
  return text_page({language.text("shown_again"),
                    {language.text("gaze_was_lost", {{"share", language.percent(lost_share)}}),
                     by_pointer ? language.text("keep_pointer") : language.text("keep_looking")}},
                   progress);
}

namespace {

constexpr double kSettlingShare = 0.5;

/// Shows points one after the other and keeps what was sampled.
class Run {
 public:
  Run(double point_ms, const SessionProgress& progress, const Ports& ports)
      : ports_(ports),
        hz_(ports.display.refresh_hz()),
        frames_(std::max<std::int64_t>(1, std::llround(point_ms / 1e3 * hz_))) {
    picture_.viewer = viewer_at(ports.display.geometry(), 0.0);
    picture_.pointer = ports.gaze->is_pointer();
    picture_.progress = progress;
  }

  PointRun through(const std::vector<ScreenPoint>& points) {
    ports_.display.restart_grid();
    static_cast<void>(ports_.gaze->take_samples());  // of before
    for (const ScreenPoint& point : points) {
      run_.points.push_back({point, {}});
      if (!show(point)) {
        return std::move(run_);
      }
    }
    take_samples();
    run_.began_ns = onsets_ns_.front();
    run_.sampling_hz = sampling_hz_of(samples_);
    share_out();
    return std::move(run_);
  }

 private:
  bool show(const ScreenPoint& point) {
    picture_.target = point;
    for (std::int64_t frame = 0; frame < frames_; ++frame) {
      const Flip flip = ports_.display.show(picture_);
      ports_.gaze->shown(picture_, flip);
      if (frame == 0) {
        onsets_ns_.push_back(flip.flipped_ns);
      }
      take_samples();
      run_.interruption = ports_.input.interruption();
      if (run_.interruption != Interruption::kNone) {
        return false;
      }
    }
    return true;
  }

  void take_samples() {
    const std::vector<GazeSample> samples = ports_.gaze->take_samples();
    samples_.insert(samples_.end(), samples.begin(), samples.end());
  }

  /// Each sample to the point that was shown when it was taken, if its eye had had time to settle.
  void share_out() {
    const double point_ns = static_cast<double>(frames_) * 1e9 / hz_;
    const auto settling_ns = static_cast<std::int64_t>(kSettlingShare * point_ns);
    const std::int64_t end_ns = onsets_ns_.back() + static_cast<std::int64_t>(point_ns);
    for (std::size_t i = 0; i < onsets_ns_.size(); ++i) {
      const std::int64_t until_ns = i + 1 < onsets_ns_.size() ? onsets_ns_[i + 1] : end_ns;
      std::copy_if(samples_.begin(), samples_.end(), std::back_inserter(run_.points[i].samples),
                   [&](const GazeSample& sample) {
                     return sample.taken_ns >= onsets_ns_[i] + settling_ns &&
                            sample.taken_ns < until_ns;
                   });
    }
  }

  const Ports& ports_;
  double hz_;
  std::int64_t frames_;  ///< of each point
  Picture picture_;
  PointRun run_;
  std::vector<std::int64_t> onsets_ns_;
  std::vector<GazeSample> samples_;
};

}  // namespace

PointRun run_points(const std::vector<ScreenPoint>& points, double point_ms,
                    const SessionProgress& progress, const Ports& ports) {
  return Run(point_ms, progress, ports).through(points);
}

std::vector<ScreenPoint> nine_points(const ScreenGeometry& screen, double share) {
  std::vector<ScreenPoint> points;
  for (const double y : {0.5, 0.0, -0.5}) {
    for (const double x : {-0.5, 0.0, 0.5}) {
      points.push_back({x * share * screen.width_m, y * share * screen.height_m});
    }
  }
  return points;
}

PointRun corrected(PointRun run, const GazeCorrection& correction) {
  for (PointSamples& point : run.points) {
    for (GazeSample& sample : point.samples) {
      sample.at = correction.corrected(sample.at);
    }
  }
  return run;
}

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
    const Page results = calibration_results(*validation, ports_.display.geometry(), numbers(),
                                             standing_.progress());
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
  return talk_.ask(gaze_has_drifted(check, numbers(), standing_.progress())).has_value() &&
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
