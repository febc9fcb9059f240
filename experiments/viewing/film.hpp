// A film of what was shown, as plain data: its stimuli, the frames that were flipped, and what each
// refresh of the screen had on it.
//
//   flips     0     1           2     3        frame 2 came a refresh late, so frame 1 was shown
//   film      0     1     1     2     3        for two: the film has as many frames as the screen
//                       held                   had refreshes, one as long as the other
//
// Between two intervals of a trial nothing is recorded, for nothing but a blank is shown:
//
//   film      ... 57    -     -     -    58    57 the last frame of interval 1, 58 the first of 2
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/scheduling/viewer.hpp"
#include "experiments/gaze/gaze_trail.hpp"
#include "experiments/record/photodiode_patch.hpp"
#include "experiments/record/record.hpp"
#include "experiments/record/staged_scene.hpp"

namespace impetus::inline viewing {

/// A stimulus that was shown, ready to be simulated again.
struct FilmedStimulus {
  StagedScene scene;  ///< at its start
  std::vector<StepRecord> steps;
  std::vector<TimedGaze> samples{};
};

/// All that was shown between the begin of a trial's timed phases and their end.
struct Film {
  std::vector<FilmedStimulus> stimuli;  ///< one for each interval
  std::vector<FrameRecord> frames;      ///< as they were flipped; at least one
  double refresh_hz{60.0};
  bool was_flipped{true};  ///< false: simulated, and shown by nobody; then flips are as they should
  std::optional<ScreenCorner> patch{};  ///< where a photodiode patch was shown
};

/// What the screen had on it during one refresh.
struct FilmFrame {
  /// A frame in its first refresh; one that stays since the next came late; the blank between two
  /// intervals.
  enum class Kind { kShown, kHeld, kBetween };
  Kind kind{Kind::kShown};
  std::size_t recorded{0};  ///< the frame that was flipped last
};

/// How many refreshes went by from the first flip to the last, that of the last frame included.
double refreshes(const Film& film);

/// What each of them showed.
std::vector<FilmFrame> film_frames(const Film& film);

}  // namespace impetus::inline viewing
