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

#include "experiments/session/calibration_run.hpp"
#include "experiments/session/conversation.hpp"

namespace impetus::inline session {

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
  struct Occasion {
    std::int64_t before_slot{0};
    std::int64_t number{1};
  };

  /// Runs through the points until that was not interrupted; none when the session ends.
  std::optional<PointRun> run(const std::vector<ScreenPoint>& points);
  bool take_correction(const Occasion& occasion);
  std::optional<CalibrationRecord> validate(const Occasion& occasion);
  bool leave_to_experimenter(const CalibrationRecord& validation);
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
