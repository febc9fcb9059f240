// The trials of a session, one after the other: each until it is completed, with what comes
// between.
//
//   level (adaptive) ─> attempt ─completed─> saved ─> feedback, or a break and a drift check
//                         ▲        └ paused, gaze lost ┘
//
// Every function returns whether the session goes on; when it does not, the sitting's conversation
// knows why.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>

#include "experiments/design/adaptive_levels.hpp"
#include "experiments/design/design.hpp"
#include "experiments/questions/script.hpp"
#include "experiments/session/conversation.hpp"
#include "experiments/session/gaze_calibration.hpp"
#include "experiments/session/lateness.hpp"
#include "experiments/session/session_standing.hpp"
#include "experiments/session/trial.hpp"

namespace impetus::inline session {

/// What the parts of a session share: who sits there, what is asked, how far it is. All must
/// outlive the parts.
struct Sitting {
  const Script& script;
  const Design& design;
  Ports& ports;  ///< with the present correction of the gaze
  SessionStanding& standing;
  Conversation& talk;
  std::optional<GazeCalibration>& calibration;  ///< none: the gaze is not calibrated

  /// Asks until there is an answer; nothing when the session ends.
  [[nodiscard]] std::optional<Answer> ask(const Page& page) const { return talk.ask(page); }
  /// Asks the experimenter whether to go on; false when the session ends, by their choice or not.
  [[nodiscard]] bool ask_whether_to_go_on(const Page& page) const;
  [[nodiscard]] SessionProgress progress() const { return standing.progress(); }
};

/// Of the trials of this session.
struct GazeTroubles {
  std::int64_t slow_trials{0};      ///< with a gaze latency that warns
  std::int64_t late_trials{0};      ///< of these, marked as late
  std::int64_t lost_trials{0};      ///< kept though too much of the gaze was lost
  std::int64_t repeated_trials{0};  ///< attempts shown again for that
};

/// Shows the waiting trials of a phase in their order, with breaks and adaptive levels.
class TrialSequence {
 public:
  /// `levels` as the answers of earlier sessions left them.
  TrialSequence(const Sitting& sitting, AdaptiveLevels levels)
      : sitting_(sitting), levels_(std::move(levels)) {}

  /// The waiting trials of a phase, or of one round of practice (0: all), introduced by a page.
  bool run_phase(TrialPhase phase, std::int64_t round);

  /// Shows a trial until it is completed, then what follows it as the `done`th of `total`; after a
  /// pause, and when too much of the gaze was lost, it starts again from the interval.
  bool run_one(const PlannedTrial& trial, const SessionProgress& here, std::int64_t done,
               std::int64_t total);

  /// How the scale was used in practice, where there was one.
  bool summarise_practice();

  [[nodiscard]] const GazeTroubles& gaze_troubles() const { return troubles_; }

 private:
  PlannedTrial with_level(const PlannedTrial& planned);
  bool run_trial(const PlannedTrial& planned, SessionProgress here);
  bool ask_to_repeat(double lost_share);
  void note_completed(const PlannedTrial& trial, const AttemptRecord& record);
  void note_lost_gaze(const AttemptRecord& record);
  bool after_trial(const PlannedTrial& trial, std::int64_t done, std::int64_t total);
  bool take_break(std::int64_t done, std::int64_t total);
  bool look_at_lateness(bool may_stop);

  const Sitting& sitting_;
  AdaptiveLevels levels_;
  std::map<std::int64_t, std::int64_t> practice_use_;  ///< how often each rating was given
  std::optional<Page> feedback_;                       ///< on the last practice trial
  bool gaze_was_lost_{false};                          ///< in the trial before
  GazeTroubles troubles_;
  Lateness lateness_;  ///< of trials since the last break
};

/// The tracks as the answers of earlier sessions left them.
AdaptiveLevels levels_after(const SessionHistory& history, const Plan& plan, const Design& design);

}  // namespace impetus::inline session
