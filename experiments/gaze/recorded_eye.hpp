// An eye that looks where another was recorded to look: the gaze of a file, trial by trial.
//
//   onset ──> the samples of the file's trial, each at its time from there; then the gaze is lost
//   a point of a calibration ──> looked at exactly: what was recorded is taken as calibrated
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "experiments/record/ports.hpp"

namespace impetus::inline gaze {

/// Recorded samples, with places in one unit: trial by trial, as the file has them.
struct GazeRecording {
  /// Where a place is counted from, and in what.
  enum class Unit {
    kMetres,      ///< right of and above the screen's centre
    kDegrees,     ///< the same
    kPixels,      ///< of the session's screen, right of and below its upper left corner
    kSharesDown,  ///< of its width and height, from there
    kSharesUp     ///< of them, right of and above its lower left corner
  };

  /// One sample.
  struct Sample {
    double time_s{0.0};  ///< from the stimulus's onset
    double x{0.0};
    double y{0.0};
    bool valid{true};
  };

  Unit unit{Unit::kMetres};
  std::vector<std::vector<Sample>> trials;  ///< none is empty; each in order of time

  /// Where a sample is on a screen; none: nowhere, or beyond its edge.
  [[nodiscard]] Fixation place(const Sample& sample, const ScreenGeometry& screen) const;
};

/// Looks so in main trials, one after the other; where there is one trial alone, in each, and in
/// practice as in the first.
class RecordedEye final : public Gaze {
 public:
  /// `slots` are those of the plan's main trials, in order; there is a trial of the recording for
  /// each, or one for all. `clock` stamps flips, and must outlive this.
  RecordedEye(std::shared_ptr<const GazeRecording> recording, std::vector<std::int64_t> slots,
              const ScreenGeometry& screen, const Clock& clock)
      : recording_(std::move(recording)),
        slots_(std::move(slots)),
        screen_(screen),
        clock_(&clock) {}

  [[nodiscard]] std::string source() const override { return "recording"; }
  void begins(std::int64_t slot) override;
  void shown(const Picture& picture, const Flip& flip) override;
  std::vector<GazeSample> take_samples() override;

 private:
  std::shared_ptr<const GazeRecording> recording_;
  std::vector<std::int64_t> slots_;
  ScreenGeometry screen_;
  const Clock* clock_;
  std::size_t trial_{0};
  std::size_t next_{0};                   ///< sample of the trial
  bool awaits_onset_{false};              ///< a stimulus began, and no flip showed it yet
  std::optional<std::int64_t> onset_ns_;  ///< of the stimulus on show
  Fixation target_;                       ///< of a calibration
};

}  // namespace impetus::inline gaze
