// What a session says and asks, and how its trials run: the struct that a protocol becomes.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/design/design.hpp"
#include "experiments/record/page.hpp"

namespace impetus::inline record {

/// A title and what stands under it.
struct Text {
  std::string title;
  std::vector<std::string> paragraphs;
};

/// A rating, after the stimulus.
struct RatingScale {
  std::string question;
  std::int64_t minimum{1};
  std::int64_t maximum{3};
  std::int64_t best{1};  ///< which end is good: minimum or maximum
  std::string low_anchor;
  std::string high_anchor;
  double timeout_ms{0.0};  ///< 0: none
};

/// When practice is understood: something was clicked in a round's trials of the worst level (where
/// clicks are asked for), and its best level was rated better on average.
struct PracticeRule {
  std::string factor;
  LevelValue best;
  LevelValue worst;
};

/// When training is over: of the last `of` practice trials, at least `right` were answered right.
/// Whether an answer was right is said after each. Practice conditions come again and again, in
/// order, for `most_trials` at most; then the experimenter decides.
struct TrainingRule {
  std::int64_t right{0};
  std::int64_t of{0};
  std::int64_t most_trials{0};
};

/// What comes before a stimulus, and between trials.
struct TrialTiming {
  double fixation_ms{500.0};
  double interval_ms{700.0};  ///< blank, between trials; nothing in it is timed
};

/// Clicks during the stimulus, whenever something is seen.
struct ClickTask {
  double merge_within_ms{100.0};  ///< of what happened, for the analysis; clicks are kept raw
};

/// Yes or no, after the stimulus.
struct YesNoQuestion {
  std::string question;
  std::string yes;  ///< the words on the two choices; keys are y and n
  std::string no;
  double timeout_ms{0.0};  ///< 0: none
  /// Yes is right where the factor's level is above this; "": there is no right answer.
  std::string right_factor{};
  double right_above{0.0};
};

/// Two stimuli, of which the participant chooses one: the condition's own and one of the standard,
/// in an order drawn with the trial's seed.
struct TwoIntervalQuestion {
  std::string question;
  std::string first;  ///< the words on the two choices; keys are 1 and 2
  std::string second;
  Condition standard;  ///< levels that the standard has instead of the condition's
  double between_ms{500.0};
  double timeout_ms{0.0};
};

/// Free words after the stimulus.
struct FreeTextQuestion {
  std::string question;
};

/// A calibration of the gaze before practice: 9 points, then a validation; a drift check at breaks.
struct CalibrationTask {
  double accuracy_limit_deg{1.0};  ///< a validation worse than this is repeated
  std::int64_t most_tries{3};      ///< then the experimenter decides
  double drift_limit_deg{2.0};     ///< a drift check worse than this asks for a calibration
  double point_ms{1000.0};         ///< for which a point is shown
};

/// What becomes of a trial in which the gaze was lost for more than a share of the stimulus.
struct GazeLossRule {
  /// What becomes of it: it is kept, kept with a mark, or shown again.
  enum class Policy { kKeep, kMark, kRepeat };
  double most_lost_share{0.5};
  Policy policy{Policy::kMark};
  std::int64_t most_repeats{2};  ///< of a trial; then it is kept, marked
};

/// Whose recorded gaze the regions of kind recorded follow.
struct YokeRule {
  /// A participant's code; "previous": the last one who has finished; "least-followed": of those
  /// who have finished, the first whom the fewest others follow. Never the participant as such.
  std::string participant;
  std::string protocol;  ///< in which they were recorded; "": this one
};

/// The gaze is followed during the stimulus.
struct GazeTask {
  double extra_latency_ms{0.0};  ///< imposed: samples younger than this are not used yet
  std::optional<CalibrationTask> calibration{};
  std::optional<GazeLossRule> loss{};
  std::optional<YokeRule> yoked_to{};
};

/// A scene shown before practice and named, without a task. `id` is what `Scenes` knows it by.
struct Demonstration {
  std::string id;
  Text text;
};

/// A question of the last page, answered in free words.
struct FreeQuestion {
  std::string id;
  std::string text;
};

/// Where a session that was left goes on, and until when it may.
struct ResumeRule {
  /// The next trial, or the start of the block that it is in.
  enum class At { kTrial, kBlock };
  At at{At::kTrial};           ///< the next trial, or the start of its block
  double refuse_after_h{0.0};  ///< since anything was last recorded; 0: never
};

/// All of a session but its plan.
struct Script {
  std::string title;
  Text welcome;
  Text consent;
  std::string consent_statement;  ///< what is agreed to, as shown and stored
  std::vector<Field> demographics;
  std::vector<Text> instructions;
  std::vector<Demonstration> demonstrations;
  std::optional<PracticeRule> practice_rule;    ///< none: practice is one round
  std::optional<TrainingRule> training_rule{};  ///< in its place
  Text break_text;
  std::int64_t break_every{0};  ///< main trials; 0: no breaks
  std::vector<FreeQuestion> questions;
  Text thanks;
  bool part_follows{false};  ///< after the thanks: another protocol of a series
  std::optional<RatingScale> scale{};
  TrialTiming timing;
  std::optional<ClickTask> clicks;
  std::optional<GazeTask> gaze;
  std::optional<YesNoQuestion> yes_no{};
  std::optional<TwoIntervalQuestion> two_interval{};
  std::optional<FreeTextQuestion> free_text{};
  ResumeRule resume{};
};

}  // namespace impetus::inline record
