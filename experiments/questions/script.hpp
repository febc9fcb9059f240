// What a session says and asks, and how its trials run: the struct that a protocol becomes.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/design/design.hpp"
#include "experiments/gaze/gaze_loss.hpp"
#include "experiments/questions/fixation_time.hpp"
#include "experiments/record/markers.hpp"
#include "experiments/record/page.hpp"

namespace impetus::inline questions {

class Question;  // each kind of response has its own, with what a protocol asks by it
using Questions = std::vector<std::shared_ptr<const Question>>;

/// A title and the paragraphs under it.
struct Text {
  std::string title;
  std::vector<std::string> paragraphs;
};

/// When practice is understood: something was clicked in a round's trials of the worst level (where
/// clicks are asked for), and its best level was rated better on average.
struct PracticeRule {
  std::string factor;
  LevelValue best;
  LevelValue worst;
  std::int64_t rounds{1};  ///< at most; then the experimenter decides
};

/// When training is over: of the last `of` practice trials, at least `right` were answered right.
/// Whether an answer was right is said after each. Practice conditions come again and again, in
/// order, for `most_trials` at most; then the experimenter decides.
struct TrainingRule {
  std::int64_t right{0};
  std::int64_t of{0};
  std::int64_t most_trials{0};
};

/// How long a trial takes besides its stimulus.
struct TrialTiming {
  FixationTime fixation;
  double interval_ms{700.0};        ///< blank, between trials; nothing in it is timed
  double between_adaptors_ms{0.0};  ///< the same before trials of adaptation, without fixation
};

/// A calibration of the gaze before practice: 9 points, then a validation; a drift check at breaks.
struct CalibrationTask {
  double accuracy_limit_deg{1.0};  ///< a validation worse than this is repeated
  std::int64_t most_tries{3};      ///< then the experimenter decides
  double drift_limit_deg{2.0};     ///< a drift check worse than this asks for a calibration
  double point_ms{1000.0};         ///< for which a point is shown
  bool show_accuracy{false};       ///< in numbers, to participants
};

/// Whose recorded gaze the regions of kind recorded follow.
struct YokeRule {
  static constexpr const char* kPrevious = "previous";  ///< the last one who has finished
  /// Of those who have finished, the first whom the fewest others follow. Neither is excluded.
  static constexpr const char* kLeastFollowed = "least-followed";

  std::string participant;  ///< a code or one of these words; never the participant as such
  std::string protocol;     ///< in which they were recorded; "": this one
};

/// The gaze is followed during the stimulus.
struct GazeTask {
  double extra_latency_ms{0.0};  ///< imposed on every scene beside its own (see `Scenes`)
  std::optional<CalibrationTask> calibration{};
  GazeLossRule loss{};
  std::optional<YokeRule> yoked_to{};
};

/// A scene shown before practice and named, without a task. `id` is what `Scenes` knows it by.
struct Demonstration {
  std::string id;
  Text text;
  std::map<std::string, LevelValue> set{};  ///< values of the scene, by JSON Pointer
};

/// A question at the end of the session, answered in free words.
struct FreeQuestion {
  std::string id;
  std::string text;
};

/// A factor whose levels are the keys of a question's answers.
struct KeyFactor {
  std::string question;  ///< its block in the protocol
  std::string factor;
  std::vector<std::string> places;  ///< the keys from left to right
};

/// In which order the questions after the stimulus are asked.
struct QuestionOrder {
  bool is_drawn{false};  ///< for each trial anew, by its seed
  std::vector<std::string>
      questions;  ///< by their blocks in the protocol; none: as kinds are listed
};

/// What becomes of a session in which too many of the timed frames come late, or stimuli run slower
/// than real time.
struct LatenessRule {
  /// Nothing; the experimenter is told at the next break; the session stops there, too, until the
  /// experimenter decides.
  enum class Then { kNothing, kTell, kStop };
  Then then{Then::kTell};
  double most_share{0.01};  ///< of the frames since the last break, and of the time they take
};

/// Where a session that was left goes on, and until when it may.
struct ResumeRule {
  /// At the next trial, or at the start of its block.
  enum class At { kTrial, kBlock };
  At at{At::kTrial};
  double refuse_after_h{0.0};  ///< since anything was last recorded; 0: never
};

/// Everything that a participant is shown and asked, from the welcome to the thanks.
struct Script {
  Language language{};  ///< of all that is not said here
  Text welcome;
  Text consent;
  std::string consent_statement;  ///< what is agreed to, as shown and stored
  std::vector<Field> demographics;
  std::vector<Text> instructions;
  std::vector<Demonstration> demonstrations;
  std::optional<PracticeRule> practice_rule;    ///< none: practice is one round
  std::optional<TrainingRule> training_rule{};  ///< in its place
  Text break_text;
  std::int64_t break_every{0};  ///< main trials; 0: after each block, where there are any
  std::vector<FreeQuestion> questions;
  Text thanks;
  bool part_follows{false};  ///< after the thanks: another protocol of a series
  TrialTiming timing;
  std::optional<GazeTask> gaze;
  Questions asked{};  ///< of each trial, in the order in which they are asked
  QuestionOrder question_order{};
  std::vector<KeyFactor> key_factors{};
  LatenessRule lateness{};
  ResumeRule resume{};
  bool light_pages{false};  ///< else pages and stimuli have one ground
  bool progress_during_stimuli{false};
  std::optional<MarkerCodes> markers{};  ///< for another recorder; none: nothing is marked
};

/// Whether breaks come after each block.
inline bool breaks_after_blocks(const Script& script) {
  return script.break_every == 0 && !script.break_text.title.empty();
}

/// The rule for a lost gaze; none where the gaze is not followed.
inline std::optional<GazeLossRule> gaze_loss_rule(const Script& script) {
  return script.gaze ? std::optional(script.gaze->loss) : std::nullopt;
}

}  // namespace impetus::inline questions
