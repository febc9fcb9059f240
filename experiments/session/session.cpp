// SPDX-License-Identifier: MIT
#include "experiments/session/session.hpp"

#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "experiments/session/adaptive_levels.hpp"
#include "experiments/session/calibration_pages.hpp"
#include "experiments/session/conversation.hpp"
#include "experiments/session/demonstration.hpp"
#include "experiments/session/gaze_calibration.hpp"
#include "experiments/session/gaze_latency.hpp"
#include "experiments/session/gaze_loss.hpp"
#include "experiments/session/session_pages.hpp"

namespace impetus {
namespace {

constexpr const char* kConsentId = "consent";

/// The tracks as the answers of earlier sessions left them.
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

/// Every stage returns whether the session goes on; when it does not, `talk_` knows why.
class Session {
 public:
  Session(const Script& script, const Plan& plan, const SessionHistory& history, const Ports& ports,
          const Design& design)
      : script_(script),
        history_(history),
        ports_(ports),
        standing_(plan, history),
        talk_(ports.input, ports.recorder, standing_),
        design_(design),
        levels_(levels_after(history, plan, design)) {
    if (script.gaze && script.gaze->calibration && ports.gaze != nullptr && !plan.empty()) {
      calibration_.emplace(*script.gaze->calibration, plan.front().seed, ports_, talk_, standing_);
    }
  }

  SessionResult run() {
    const bool finished = welcome() && ask_consent() && ask_demographics() && instruct() &&
                          calibrate() && practise() && run_phase(TrialPhase::kMain, 0) &&
                          ask_questions() && thank();
    ports_.recorder.await_saved();
    result_.ending = finished ? SessionEnding::kFinished : talk_.ending();
    result_.completed_trials = standing_.completed_count();
    result_.expected_trials = standing_.progress().total;
    return result_;
  }

 private:
  bool welcome() {
    const Text& text =
        history_.resumed ? welcome_back(standing_.completed_count()) : script_.welcome;
    return ask(text_page(text, progress())).has_value();
  }

  bool ask_consent() {
    if (history_.answered.contains(kConsentId)) {
      return true;
    }
    const auto answer = ask(consent_page(script_.consent, progress()));
    if (!answer) {
      return false;
    }
    const bool agreed = answer->choice == 0;
    ports_.recorder.save(QuestionRecord{"consent", kConsentId, script_.consent_statement,
                                        agreed ? "agreed" : "declined"});
    return agreed || talk_.end(SessionEnding::kDeclined);
  }

  bool ask_demographics() {
    const std::vector<Field>& fields = script_.demographics;
    if (fields.empty() || history_.answered.contains(fields.front().id)) {
      return true;
    }
    const auto answer = ask(demographics_page(fields, progress()));
    for (std::size_t i = 0; answer && i < fields.size(); ++i) {
      ports_.recorder.save(
          QuestionRecord{"demographic", fields[i].id, fields[i].label, answer->fields[i]});
    }
    return answer.has_value();
  }

  bool instruct() {
    for (const Text& text : script_.instructions) {
      if (!ask(text_page(text, progress()))) {
        return false;
      }
    }
    return true;
  }

  /// In every session anew; nothing where no trial waits.
  bool calibrate() {
    const auto next = standing_.next_slot();
    return !calibration_ || !next || calibration_->calibrate(*next);
  }

  /// Demonstrations, then practice; nothing once main trials have begun.
  bool practise() {
    const bool goes_on = standing_.main_has_begun() ||
                         (demonstrate() && (script_.training_rule ? train() : practise_rounds()));
    if (goes_on) {
      standing_.end_practice();
    }
    return goes_on;
  }

  /// Practice trials until enough of the last ones were answered right, or none is left.
  bool train() {
    const TrainingRule& rule = *script_.training_rule;
    const PhaseTrials trials = standing_.trials_of(TrialPhase::kPractice, 0);
    std::int64_t done = trials.total - static_cast<std::int64_t>(trials.waiting.size());
    if (is_trained(rule, standing_.practice_results(0))) {
      return true;  // in an earlier session
    }
    if (!trials.waiting.empty() && !ask(training_intro(rule, progress()))) {
      return false;
    }
    for (const PlannedTrial* trial : trials.waiting) {
      standing_.begin_round(trial->repetition);
      const SessionProgress here =
          standing_.trial_progress(TrialPhase::kPractice, ++done, trials.total, true);
      if (!run_trial(*trial, here) || !after_trial(TrialPhase::kPractice, done, trials.total)) {
        return false;
      }
      if (is_trained(rule, standing_.practice_results(0))) {
        return ask(training_over(right_of_last(rule.of, standing_.practice_results(0)), rule.of,
                                 progress()))
            .has_value();
      }
    }
    return ask_whether_to_go_on();
  }

  /// Rounds of practice until one was understood.
  bool practise_rounds() {
    const std::int64_t last_round = standing_.last_round();
    for (std::int64_t round = 1; round <= last_round; ++round) {
      standing_.begin_round(round);
      if (!run_phase(TrialPhase::kPractice, round)) {
        return false;
      }
      const std::vector<std::string> missing = missing_in(round);
      if (missing.empty()) {
        return summarise_practice();
      }
      if (round < last_round && !ask(practice_again(missing, progress()))) {
        return false;
      }
    }
    return last_round == 0 || ask_whether_to_go_on();
  }

  bool demonstrate() {
    for (const Demonstration& demonstration : script_.demonstrations) {
      if (!ask(text_page(demonstration.text, progress()))) {
        return false;
      }
      std::optional<Answer> again;
      do {
        ports_.recorder.save(NoteRecord{"demonstration", demonstration.id});
        const Interruption interruption =
            show_demonstration(demonstration.id, script_, progress(), ports_);
        if (interruption != Interruption::kNone && !talk_.handle(interruption)) {
          return false;
        }
        again = ask(demonstration_over(demonstration.text, progress()));
      } while (again && again->choice == kAgainChoice);
      if (!again) {
        return false;
      }
    }
    return true;
  }

  /// What the round of practice lacks to be understood; nothing where nobody asks.
  [[nodiscard]] std::vector<std::string> missing_in(std::int64_t round) const {
    if (!script_.practice_rule) {
      return {};
    }
    return missing_in_practice(*script_.practice_rule, script_, standing_.practice_results(round));
  }

  /// Practice was not understood in all its rounds: the experimenter decides.
  bool ask_whether_to_go_on() {
    ports_.recorder.save(NoteRecord{"practice not understood", ""});
    const auto answer = ask(practice_not_understood(progress()));
    if (answer && answer->choice != kContinueChoice) {
      ports_.recorder.save(NoteRecord{"quit", ""});
      return talk_.end(SessionEnding::kQuit);
    }
    return answer.has_value();
  }

  bool run_phase(TrialPhase phase, std::int64_t round) {
    const PhaseTrials trials = standing_.trials_of(phase, round);
    if (trials.waiting.empty()) {
      return true;
    }
    if (!ask(phase_intro(phase, round, trials.waiting.size(), progress()))) {
      return false;
    }
    std::int64_t done = trials.total - static_cast<std::int64_t>(trials.waiting.size());
    for (const PlannedTrial* trial : trials.waiting) {
      const SessionProgress here = standing_.trial_progress(phase, done + 1, trials.total);
      if (!run_trial(*trial, here) || !after_trial(phase, ++done, trials.total)) {
        return false;
      }
    }
    return true;
  }

  /// The trial as it is shown: an adaptive one gets its level, which is handed over to be stored
  /// unless an earlier session did so.
  PlannedTrial with_level(const PlannedTrial& planned) {
    PlannedTrial trial = planned;
    if (trial.track && !has_its_level(trial, design_)) {
      ChosenLevel chosen = levels_.choose(trial);
      trial.condition = chosen.condition;
      ports_.recorder.save(std::move(chosen));
    }
    return trial;
  }

  /// Shows a trial until it is completed; after a pause, and when too much of the gaze was lost, it
  /// starts again from the interval.
  bool run_trial(const PlannedTrial& planned, SessionProgress here) {
    const PlannedTrial trial = with_level(planned);
    std::int64_t number = standing_.attempts_before(trial.slot);
    std::int64_t repeats = 0;
    while (true) {
      here.gaze_was_lost = std::exchange(gaze_was_lost_, false);
      AttemptResult attempt =
          run_attempt(trial, ++number, script_, here, ports_, repeats < most_repeats(script_));
      const bool completed = attempt.record.outcome == AttemptOutcome::kCompleted;
      if (completed) {
        note_completed(trial, attempt.record);
      }
      const double lost_share = attempt.record.gaze_lost_share.value_or(0.0);
      ports_.recorder.save(std::move(attempt.record));
      if (completed) {
        return true;
      }
      if (attempt.interruption != Interruption::kNone) {
        if (!talk_.handle(attempt.interruption)) {
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

  bool ask_to_repeat(double lost_share) {
    ++result_.repeated_trials;
    const bool by_pointer = ports_.gaze->is_pointer();
    return ask(gaze_was_lost_page(lost_share, by_pointer, progress())).has_value();
  }

  void note_completed(const PlannedTrial& trial, const AttemptRecord& record) {
    const PracticeResult result = practice_result(trial.condition, record);
    if (trial.phase == TrialPhase::kPractice) {
      feedback_ = practice_feedback(script_, record, progress());
      if (result.rating) {
        ++practice_use_[*result.rating];
      }
    }
    standing_.complete(trial, result);
    levels_.take(trial, counted_answer(record));
    const double latency_ms = record.gaze_latency_p95_ms.value_or(0.0);
    result_.slow_gaze_trials += latency_ms > kWarnedGazeLatency_ms ? 1 : 0;
    result_.late_gaze_trials += latency_ms > kMarkedGazeLatency_ms ? 1 : 0;
    note_lost_gaze(record);
  }

  void note_lost_gaze(const AttemptRecord& record) {
    gaze_was_lost_ = gaze_was_lost(script_, record.gaze_lost_share);
    if (gaze_was_lost_) {
      ++result_.lost_gaze_trials;
      ports_.recorder.save(
          NoteRecord{kGazeLost, "trial " + std::to_string(record.slot) + ", attempt " +
                                    std::to_string(record.number) + ": " +
                                    std::to_string(std::lround(100.0 * *record.gaze_lost_share)) +
                                    " % of the stimulus"});
    }
  }

  bool after_trial(TrialPhase phase, std::int64_t done, std::int64_t total) {
    if (phase == TrialPhase::kPractice) {
      if (feedback_) {
        feedback_->progress = progress();
      }
      return !feedback_ || ask(*feedback_).has_value();
    }
    const bool break_due = script_.break_every > 0 && done % script_.break_every == 0;
    if (!break_due || done == total) {
      return true;
    }
    ports_.recorder.save(NoteRecord{"break", "after main trial " + std::to_string(done)});
    Text text = script_.break_text;
    if (calibration_) {
      text.paragraphs.emplace_back(ports_.gaze->is_pointer() ? kPointAtTheMiddle
                                                             : kLookAtTheMiddle);
    }
    return ask(break_page(text, done, total, progress())).has_value() &&
           (!calibration_ || calibration_->check_drift(*standing_.next_slot()));
  }

  bool summarise_practice() {
    if (practice_use_.empty()) {
      return true;  // all of it was done in an earlier session, or nothing was rated
    }
    return ask(practice_summary(*script_.scale, practice_use_, progress())).has_value();
  }

  bool ask_questions() {
    for (const FreeQuestion& question : script_.questions) {
      if (history_.answered.contains(question.id)) {
        continue;
      }
      const auto answer = ask(question_page(question, progress()));
      if (!answer) {
        return false;
      }
      ports_.recorder.save(
          QuestionRecord{"question", question.id, question.text, answer->fields.front()});
    }
    return true;
  }

  bool thank() {
    // Saved before the words: closing the window on the last page loses nothing.
    ports_.recorder.mark_finished();
    ports_.recorder.await_saved();
    ports_.input.ask(thanks_page(script_.thanks, script_.part_follows, progress()));
    return true;
  }

  std::optional<Answer> ask(const Page& page) { return talk_.ask(page); }
  [[nodiscard]] SessionProgress progress() const { return standing_.progress(); }

  const Script& script_;
  const SessionHistory& history_;
  Ports ports_;  ///< with the present correction of the gaze
  SessionStanding standing_;
  Conversation talk_;
  std::optional<GazeCalibration> calibration_;
  std::map<std::int64_t, std::int64_t> practice_use_;  ///< how often each rating was given
  std::optional<Page> feedback_;                       ///< on the last practice trial
  bool gaze_was_lost_{false};                          ///< in the trial before
  SessionResult result_;
  const Design& design_;
  AdaptiveLevels levels_;
};

}  // namespace

SessionResult run_session(const Script& script, const Plan& plan, const SessionHistory& history,
                          const Ports& ports, const Design& design) {
  return Session(script, plan, history, ports, design).run();
}

}  // namespace impetus
