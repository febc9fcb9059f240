// Where a participant looks, as a stream of samples: a mouse, a simulated eye, a recording.
//
//   samples  . . . . x x . . . .      x: lost, with a reason; never a made-up place
//   frames   |       |       |        the newest valid sample decides until the next frame
//
// Raw samples are recorded as they come; the session corrects a copy by its calibration, which is
// the same for every source (session/gaze_calibration.hpp). An eye tracker is one more file
// in experiments/trackers; what any source must do:
//
//   source()        a name of its own, such as "Pupil": it stands beside every sample
//   take_samples()  never waits: a thread of the tracker's fills a queue, this empties it. Stamps
//                   are of the clock that stamps flips (std::chrono::steady_clock), converted from
//                   the device's; places are metres right of and above the screen's centre. What
//                   has no place says why, and is never left out: losses are counted.
//   begins(), shown()  nothing; a recording that is played again goes by them
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/scheduling/viewer.hpp"
#include "experiments/record/frame_grid.hpp"

namespace impetus::inline record {

struct Picture;

/// Why a sample has no place.
enum class GazeLoss { kNone, kBlink, kOffScreen, kLost };

/// So soon after a sample comes the one that marks, as lost, that nothing more was heard of the
/// tracker: sooner than any tracker can tell two samples apart.
inline constexpr std::int64_t kSilentAfter_ns = 1;

/// Where the participant looked at one moment.
struct GazeSample {
  std::int64_t taken_ns{0};  ///< of the session's clock
  Fixation at{};             ///< none: lost
  GazeLoss loss{GazeLoss::kNone};
  std::int64_t interval{1};  ///< of a two-interval trial, during its first or second stimulus
};

/// A source of samples; see the top of this file.
class Gaze {
 public:
  virtual ~Gaze() = default;

  /// "mouse", "simulated eye" or "recording"; it stands beside every sample.
  [[nodiscard]] virtual std::string source() const = 0;

  /// Whether the mouse pointer stands in for the eye, so that it must be seen.
  [[nodiscard]] virtual bool is_pointer() const { return false; }

  /// Tells that the stimulus of a planned trial begins, by its slot: the next flip but a fixation
  /// cross's shows it.
  virtual void begins(std::int64_t slot) { static_cast<void>(slot); }

  /// What was sampled since the last call, in order of time. Called once per frame, just before
  /// the frame's steps.
  virtual std::vector<GazeSample> take_samples() = 0;

  /// Tells what a flip showed; a simulated eye looks at it.
  virtual void shown(const Picture& picture, const Flip& flip) {
    static_cast<void>(picture);
    static_cast<void>(flip);
  }
};

/// The gaze of a recorded trial, step by step: what a yoked region follows.
struct GazePath {
  double viewing_distance_m{0.0};   ///< of the recording's screen
  std::vector<Fixation> fixations;  ///< used in each step, from step 0

  /// The fixation of a step, or of the last one there was.
  [[nodiscard]] Fixation at(std::int64_t step) const {
    if (fixations.empty()) {
      return std::nullopt;
    }
    const auto wanted = static_cast<std::size_t>(step);
    return fixations[wanted < fixations.size() ? wanted : fixations.size() - 1];
  }

  /// The same directions before a screen that is this far away.
  [[nodiscard]] GazePath seen_from(double distance_m) const {
    GazePath path{distance_m, fixations};
    for (Fixation& fixation : path.fixations) {
      if (fixation && distance_m != viewing_distance_m) {
        fixation->x_m *= distance_m / viewing_distance_m;
        fixation->y_m *= distance_m / viewing_distance_m;
      }
    }
    return path;
  }
};

/// By the id of the trial in the study.
using GazePaths = std::map<std::int64_t, GazePath>;

}  // namespace impetus::inline record
