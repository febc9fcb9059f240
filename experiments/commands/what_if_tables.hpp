// What would have differed in trials, as a table to read, as CSV and as JSON.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/session/wall_names.hpp"
#include "experiments/session/what_if.hpp"
#include "experiments/store/study_reader.hpp"

namespace impetus {

/// One stimulus of one attempt, simulated both ways.
struct ComparedStimulus {
  const StoredAttempt* attempt{nullptr};
  std::int64_t interval{1};
  double step_hz{240.0};
  std::vector<std::string> bodies;  ///< names, by index in the world
  WallNaming walls{WallNaming::kAxes};
  bool has_gaze{false};  ///< a step knew where the participant looked
  WhatIf outcome;
};

/// A line for each, and what they come to together.
std::string what_if_words(const std::vector<ComparedStimulus>& compared);

/// A row for each, after a line of names. Times in seconds, empty where nothing parted.
std::string what_if_csv(const std::vector<ComparedStimulus>& compared);

/// The same, with every collision, and the totals.
nlohmann::json what_if_json(const std::vector<ComparedStimulus>& compared);

}  // namespace impetus
