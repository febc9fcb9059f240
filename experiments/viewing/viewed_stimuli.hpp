// What a viewer of replays asks for: the recorded stimuli of a study, one by one, and what a
// picture of one is called as a file.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/trees/tree_settings.hpp"
#include "experiments/gaze/gaze_trail.hpp"
#include "experiments/viewing/replay_view.hpp"

namespace impetus::inline viewing {

/// What a picture is of.
struct PictureOf {
  std::string study;  ///< the file's name without its folder and ending
  std::int64_t trial{0};
  std::int64_t attempt{1};
  std::int64_t interval{1};
  std::int64_t step{0};
};

/// "study-trial37-step412.png", with the attempt and the interval where they are not the first, and
/// with "-2", "-3", ... for as long as `taken` says that there is one.
std::string picture_name(const PictureOf& picture,
                         const std::function<bool(const std::string&)>& taken);

/// One stimulus of one attempt, ready to be simulated again.
struct ViewedStimulus {
  std::string title;               ///< "P01 · trial 37 of 87 · main"
  std::vector<std::string> facts;  ///< "delay_ms 100", "rated 2", ...
  StagedScene scene;               ///< at its start
  std::vector<StepRecord> steps;
  std::vector<TimelineMark> marks;  ///< of what the participant did, and of late frames
  std::vector<TimedGaze> samples;
  PictureOf picture;  ///< but for the step
};

/// A line of the list to choose from.
struct StimulusLine {
  std::int64_t trial{0};  ///< its number in the study, as the views have it
  std::string words;
};

/// Where they come from.
class ViewedStimuli {
 public:
  virtual ~ViewedStimuli() = default;

  /// At least one.
  [[nodiscard]] virtual std::size_t count() const = 0;
  [[nodiscard]] virtual StimulusLine line(std::size_t index) = 0;

  /// May take seconds, to build bodies: `progress` is told, and may throw to abandon it.
  [[nodiscard]] virtual ViewedStimulus load(std::size_t index, const Progress& progress) = 0;
};

}  // namespace impetus::inline viewing
