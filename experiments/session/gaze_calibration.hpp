// Calibrates the gaze, validates that, and checks for drift: the same for every source.
//
//   calibrate   nine points ──> correction ──> nine points of a smaller grid ──> good enough?
//                    ^                                                  no │          │ yes
//                    └──────────── up to most_tries ───────────────────────┘          on
//                                  then the experimenter decides
//   drift       one point in the middle ──> worse than its limit: calibrate
//
// The correction is done to every sample used after it; samples are recorded raw. A mouse pointer
// is what the participant sees it to be, so it is never corrected: there the points show whether
// the pointer is kept where it should be. The order of points is drawn with the plan's first seed.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/gaze/gaze_quality.hpp"
#include "experiments/record/page.hpp"
#include "experiments/record/record.hpp"
#include "experiments/session/conversation.hpp"
#include "experiments/session/trial.hpp"

namespace impetus::inline session {

inline constexpr std::size_t kStopChoice = 1;  ///< of calibration_not_passed()

/// Before the points. `by_pointer`: the mouse pointer stands in for the eye.
Page calibration_intro(bool by_pointer, const SessionProgress& progress);

/// Whether a page says in numbers what was measured. Participants need none.
enum class Numbers : bool { kHidden, kShown };

/// What the validation found, as a map and maybe in numbers: go on, or once more.
Page calibration_results(const CalibrationRecord& validation, const ScreenGeometry& screen,
                         Numbers numbers, const SessionProgress& progress);

/// The same after the last try: the experimenter decides, by the numbers.
Page calibration_not_passed(const CalibrationRecord& validation, const ScreenGeometry& screen,
                            const SessionProgress& progress);

/// A drift check was worse than its limit: calibrated anew.
Page gaze_has_drifted(const CalibrationRecord& check, Numbers numbers,
                      const SessionProgress& progress);

/// Too much of the gaze was lost, and the trial is shown again.
Page gaze_was_lost_page(double lost_share, bool by_pointer, const SessionProgress& progress);

/// One run through points of the screen that are to be looked at, and the gaze meanwhile.
///
///   point 1  |---settle---|--count--| point 2 |---settle---|--count--| ...      one display grid
///
/// The first half of each point is for finding it. Samples are given to points by their own stamps,
/// so that it does not matter how late they come.
struct PointRun {
  std::vector<PointSamples> points;   ///< in the order shown; raw samples, of the halves that count
  std::optional<double> sampling_hz;  ///< over the whole run
  std::int64_t began_ns{0};
  Interruption interruption{Interruption::kNone};  ///< other than kNone: the run is not whole
};

/// Shows each of `points` for `point_ms`. `ports` must have a gaze.
PointRun run_points(const std::vector<ScreenPoint>& points, double point_ms,
                    const SessionProgress& progress, const Ports& ports);

/// Nine points, three by three, over `share` of the screen's width and height, row by row.
std::vector<ScreenPoint> nine_points(const ScreenGeometry& screen, double share);

/// The run with every sample corrected.
PointRun corrected(PointRun run, const GazeCorrection& correction);

/// Calibrates, validates and checks for drift within a session.
class GazeCalibration {
 public:
  /// All must outlive this; `ports` must have a gaze and gets the corrections. `seed` is the
  /// plan's.
  GazeCalibration(const CalibrationTask& task, std::uint64_t seed, Ports& ports, Conversation& talk,
                  const SessionStanding& standing)
      : task_(task), seed_(seed), ports_(ports), talk_(talk), standing_(standing) {}

  /// Before the planned trial `before_slot`. Whether the session goes on; `talk` knows why not.
  bool calibrate(std::int64_t before_slot);

  /// The same, where the gaze is far from a point in the middle.
  bool check_drift(std::int64_t before_slot);

 private:
  /// When in the session a calibration was made, and the how manieth it was there.
  struct Occasion {
    std::int64_t before_slot{0};
    std::int64_t number{1};
  };

  /// Runs through the points until that was not interrupted; none when the session ends.
  std::optional<PointRun> run(const std::vector<ScreenPoint>& points);
  bool take_correction(const Occasion& occasion);
  std::optional<CalibrationRecord> validate(const Occasion& occasion);
  bool leave_to_experimenter(const CalibrationRecord& validation);
  [[nodiscard]] Numbers numbers() const {
    return task_.show_accuracy ? Numbers::kShown : Numbers::kHidden;
  }
  [[nodiscard]] std::vector<ScreenPoint> drawn_points(const char* kind, double share,
                                                      const Occasion& occasion) const;
  [[nodiscard]] CalibrationRecord record_of(const PointRun& run, CalibrationKind kind,
                                            const Occasion& occasion, double limit_deg) const;

  const CalibrationTask& task_;
  std::uint64_t seed_;
  Ports& ports_;
  Conversation& talk_;
  const SessionStanding& standing_;
};

}  // namespace impetus::inline session
