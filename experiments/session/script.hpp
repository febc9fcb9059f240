// What a session says and asks, and how its trials run: the struct that a protocol becomes.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/session/design.hpp"
#include "experiments/session/page.hpp"

namespace impetus {

struct Text {
  std::string title;
  std::vector<std::string> paragraphs;
};

struct RatingScale {
  std::string question;
  std::int64_t minimum{1};
  std::int64_t maximum{3};
  std::int64_t best{1};  ///< which end is good: minimum or maximum
  std::string low_anchor;
  std::string high_anchor;
};

/// When practice is understood: something was clicked in a round's trials of the worst level (where
/// clicks are asked for), and its best level was rated better on average.
struct PracticeRule {
  std::string factor;
  LevelValue best;
  LevelValue worst;
};

struct TrialTiming {
  double fixation_ms{500.0};
  double interval_ms{700.0};  ///< blank, between trials; nothing in it is timed
};

/// Clicks during the stimulus, whenever something is seen.
struct ClickTask {
  double merge_within_ms{100.0};  ///< of what happened, for the analysis; clicks are kept raw
};

/// The gaze is followed during the stimulus.
struct GazeTask {
  double extra_latency_ms{0.0};  ///< imposed: samples younger than this are not used yet
};

/// A scene shown before practice and named, without a task. `id` is what `Scenes` knows it by.
struct Demonstration {
  std::string id;
  Text text;
};

struct FreeQuestion {
  std::string id;
  std::string text;
};

struct Script {
  std::string title;
  Text welcome;
  Text consent;
  std::string consent_statement;  ///< what is agreed to, as stored
  std::vector<Field> demographics;
  std::vector<Text> instructions;
  std::vector<Demonstration> demonstrations;
  std::optional<PracticeRule> practice_rule;  ///< none: practice is one round
  Text break_text;
  std::int64_t break_every{0};  ///< main trials; 0: no breaks
  std::vector<FreeQuestion> questions;
  Text thanks;
  RatingScale scale;
  TrialTiming timing;
  std::optional<ClickTask> clicks;
  std::optional<GazeTask> gaze;
};

}  // namespace impetus
