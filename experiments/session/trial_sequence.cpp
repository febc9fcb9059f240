// SPDX-License-Identifier: MIT
#include "experiments/session/trial_sequence.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "experiments/gaze/gaze_latency.hpp"
#include "experiments/gaze/gaze_loss.hpp"
#include "experiments/questions/session_pages.hpp"
#include "experiments/session/gaze_calibration.hpp"

namespace impetus::inline session {

bool Sitting::ask_whether_to_go_on(const Page& page) const {
  const auto answer = ask(page);
  if (answer && answer->choice != kContinueChoice) {
    ports.recorder.save(NoteRecord{"quit", ""});
    return talk.end(SessionEnding::kQuit);
  }
  return answer.has_value();
}

bool TrialSequence::run_phase(TrialPhase phase, std::int64_t round) {
  const PhaseTrials trials = sitting_.standing.trials_of(phase, round);
  if (trials.waiting.empty()) {
    return true;
  }
  if (!sitting_.ask(phase_intro(sitting_.script, phase, round, trials.total - trials.done,
                                sitting_.progress()))) {
    return false;
  }
  std::int64_t done = trials.done;
  for (const PlannedTrial* trial : trials.waiting) {
    const SessionProgress here = sitting_.standing.trial_progress(phase, done + 1, trials.total);
    const bool goes_on =
        trial->is_asked() ? run_one(*trial, here, ++done, trials.total) : run_trial(*trial, here);
    if (!goes_on) {
      return false;
    }
  }
  return look_at_lateness(/*may_stop=*/phase == TrialPhase::kPractice);
}

bool TrialSequence::run_one(const PlannedTrial& trial, const SessionProgress& here,
                            std::int64_t done, std::int64_t total) {
  return run_trial(trial, here) && after_trial(trial, done, total);
}

/// The trial as it is shown: an adaptive one gets its level, which is handed over to be stored
/// unless an earlier session did so.
PlannedTrial TrialSequence::with_level(const PlannedTrial& planned) {
  PlannedTrial trial = planned;
  if (trial.track && !has_its_level(trial, sitting_.design)) {
    ChosenLevel chosen = levels_.choose(trial);
    trial.condition = chosen.condition;
    sitting_.ports.recorder.save(std::move(chosen));
  }
  return trial;
}

bool TrialSequence::run_trial(const PlannedTrial& planned, SessionProgress here) {
  const PlannedTrial trial = with_level(planned);
  std::int64_t number = sitting_.standing.attempts_before(trial.slot);
  std::int64_t repeats = 0;
  while (true) {
    here.gaze_was_lost = std::exchange(gaze_was_lost_, false);
    AttemptResult attempt = run_attempt(trial, ++number, sitting_.script, here, sitting_.ports,
                                        repeats < most_repeats(gaze_loss_rule(sitting_.script)));
    const bool completed = attempt.record.outcome == AttemptOutcome::kCompleted;
    if (completed) {
      note_completed(trial, attempt.record);
    }
    const double lost_share = attempt.record.gaze_lost_share.value_or(0.0);
    sitting_.ports.recorder.save(std::move(attempt.record));
    if (completed) {
      return true;
    }
    if (attempt.interruption != Interruption::kNone) {
      if (!sitting_.talk.handle(attempt.interruption)) {
        return false;
      }
      continue;
    }
    ++repeats;
    if (!ask_to_repeat(lost_share)) {
      return false;
    }
  }
}

bool TrialSequence::ask_to_repeat(double lost_share) {
  ++troubles_.repeated_trials;
  const bool by_pointer = sitting_.ports.gaze->is_pointer();
  return sitting_.ask(gaze_was_lost_page(lost_share, by_pointer, sitting_.progress())).has_value();
}

void TrialSequence::note_completed(const PlannedTrial& trial, const AttemptRecord& record) {
  const PracticeResult result = practice_result(trial.condition, record);
  if (trial.phase == TrialPhase::kPractice) {
    feedback_ = practice_feedback(sitting_.script, record, sitting_.progress());
    if (result.rating) {
      ++practice_use_[*result.rating];
    }
  }
  lateness_.take(record);
  sitting_.standing.complete(trial, result);
  levels_.take(trial, counted_answer(record));
  const double latency_ms = record.gaze_latency_p95_ms.value_or(0.0);
  troubles_.slow_trials += latency_ms > kWarnedGazeLatency_ms ? 1 : 0;
  troubles_.late_trials += latency_ms > kMarkedGazeLatency_ms ? 1 : 0;
  note_lost_gaze(record);
}

void TrialSequence::note_lost_gaze(const AttemptRecord& record) {
  gaze_was_lost_ = gaze_was_lost(gaze_loss_rule(sitting_.script), record.gaze_lost_share);
  if (gaze_was_lost_) {
    ++troubles_.lost_trials;
    sitting_.ports.recorder.save(
        NoteRecord{kGazeLostNote, "trial " + std::to_string(record.slot) + ", attempt " +
                                      std::to_string(record.number) + ": " +
                                      std::to_string(std::lround(100.0 * *record.gaze_lost_share)) +
                                      " % of the stimulus"});
  }
}

bool TrialSequence::after_trial(const PlannedTrial& trial, std::int64_t done, std::int64_t total) {
  if (trial.phase == TrialPhase::kPractice) {
    if (feedback_) {
      feedback_->progress = sitting_.progress();
    }
    return !feedback_ || sitting_.ask(*feedback_).has_value();
  }
  const bool break_due =
      breaks_after_blocks(sitting_.script)
          ? sitting_.standing.is_block_done(trial.block)
          : sitting_.script.break_every > 0 && done % sitting_.script.break_every == 0;
  return !break_due || done == total || take_break(done, total);
}

bool TrialSequence::take_break(std::int64_t done, std::int64_t total) {
  sitting_.ports.recorder.save(NoteRecord{"break", "after main trial " + std::to_string(done)});
  if (!look_at_lateness(/*may_stop=*/true)) {
    return false;
  }
  Text text = sitting_.script.break_text;
  if (sitting_.calibration) {
    const Language& language = sitting_.script.language;
    text.paragraphs.push_back(sitting_.ports.gaze->is_pointer() ? language.text("point_at_middle")
                                                                : language.text("look_at_middle"));
  }
  return sitting_.ask(break_page(text, done, total, sitting_.progress())).has_value() &&
         (!sitting_.calibration ||
          sitting_.calibration->check_drift(*sitting_.standing.next_slot()));
}

/// Tells the experimenter, who may have to decide, when too much came late since it was looked at
/// last.
bool TrialSequence::look_at_lateness(bool may_stop) {
  const Lateness since = std::exchange(lateness_, {});
  const LatenessRule& rule = sitting_.script.lateness;
  if (!since.exceeds(rule)) {
    return true;
  }
  sitting_.ports.recorder.save(NoteRecord{kLateFramesNote, since.words()});
  if (sitting_.ports.tell) {
    sitting_.ports.tell(since.words());
  }
  if (rule.then != LatenessRule::Then::kStop || !may_stop) {
    return true;
  }
  return sitting_.ask_whether_to_go_on(
      frames_were_late(since.late(), since.frames(), since.slower_share(), sitting_.progress()));
}

bool TrialSequence::summarise_practice() {
  if (practice_use_.empty()) {
    return true;  // all of it was done in an earlier session, or nothing was rated
  }
  return sitting_
      .ask(practice_summary(*find_scale(sitting_.script), practice_use_, sitting_.progress()))
      .has_value();
}

AdaptiveLevels levels_after(const SessionHistory& history, const Plan& plan, const Design& design) {
  AdaptiveLevels levels(design);
  for (const PlannedTrial& trial : plan) {
    if (history.completed_slots.contains(trial.slot)) {
      const auto answer = history.counted_answers.find(trial.slot);
      levels.take(trial, answer == history.counted_answers.end()
                             ? std::nullopt
                             : std::optional<bool>(answer->second));
    }
  }
  return levels;
}

}  // namespace impetus::inline session
