// SPDX-License-Identifier: MIT
#include "experiments/session/session.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "experiments/session/demonstration.hpp"
#include "experiments/session/gaze_latency.hpp"
#include "experiments/session/session_pages.hpp"

namespace impetus {
namespace {

constexpr const char* kConsentId = "consent";

/// Every stage returns whether the session goes on; when it does not, `ending_` says why.
class Session {
 public:
  Session(const Script& script, const Plan& plan, const SessionHistory& history, const Ports& ports)
      : script_(script),
        plan_(plan),
        history_(history),
        ports_(ports),
        practice_(history.practice) {}

  SessionResult run() {
    const bool finished = welcome() && ask_consent() && ask_demographics() && instruct() &&
                          practise() && run_phase(TrialPhase::kMain, 0) && ask_questions() &&
                          thank();
    ports_.recorder.await_saved();
    result_.ending = finished ? SessionEnding::kFinished : ending_;
    result_.completed_trials = completed_count();
    result_.expected_trials = progress().total;
    return result_;
  }

 private:
  bool welcome() {
    const Text& text = history_.resumed ? welcome_back(completed_count()) : script_.welcome;
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
    if (!agreed) {
      ending_ = SessionEnding::kDeclined;
    }
    return agreed;
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

  /// Demonstrations, then rounds of practice until one was understood; nothing once main trials
  /// have begun.
  bool practise() {
    if (main_has_begun()) {
      return true;
    }
    if (!demonstrate()) {
      return false;
    }
    for (round_ = 1; round_ <= last_round(); ++round_) {
      if (!run_phase(TrialPhase::kPractice, round_)) {
        return false;
      }
      const std::vector<std::string> missing = missing_in(round_);
      if (missing.empty()) {
        return summarise_practice();
      }
      if (round_ < last_round() && !ask(practice_again(missing, progress()))) {
        return false;
      }
    }
    return last_round() == 0 || ask_whether_to_go_on();
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
        if (interruption != Interruption::kNone && !handle(interruption)) {
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
    std::vector<PracticeResult> results;
    for (const PlannedTrial& trial : plan_) {
      const auto found = practice_.find(trial.slot);
      if (trial.phase == TrialPhase::kPractice && trial.repetition == round &&
          found != practice_.end()) {
        results.push_back({trial.condition, found->second.rating, found->second.clicks});
      }
    }
    return missing_in_practice(*script_.practice_rule, script_, results);
  }

  /// Practice was not understood in all its rounds: the experimenter decides.
  bool ask_whether_to_go_on() {
    ports_.recorder.save(NoteRecord{"practice not understood", ""});
    const auto answer = ask(practice_not_understood(progress()));
    if (answer && answer->choice != kContinueChoice) {
      ports_.recorder.save(NoteRecord{"quit", ""});
      ending_ = SessionEnding::kQuit;
      return false;
    }
    return answer.has_value();
  }

  bool run_phase(TrialPhase phase, std::int64_t round) {
    const PhaseTrials trials = trials_of(phase, round);
    if (trials.waiting.empty()) {
      return true;
    }
    if (!ask(phase_intro(phase, round, trials.waiting.size(), progress()))) {
      return false;
    }
    std::int64_t done = trials.total - static_cast<std::int64_t>(trials.waiting.size());
    for (const PlannedTrial* trial : trials.waiting) {
      const Progress here = trial_progress(phase, done + 1, trials.total);
      if (!run_trial(*trial, here) || !after_trial(phase, ++done, trials.total)) {
        return false;
      }
    }
    return true;
  }

  /// Shows a trial until it is completed; after a pause it starts again from the interval.
  bool run_trial(const PlannedTrial& trial, const Progress& here) {
    std::int64_t number = attempts_before(trial.slot);
    while (true) {
      AttemptResult attempt = run_attempt(trial, ++number, script_, here, ports_);
      const bool completed = attempt.record.outcome == AttemptOutcome::kCompleted;
      if (completed) {
        note_completed(trial, attempt.record);
      }
      ports_.recorder.save(std::move(attempt.record));
      if (completed) {
        return true;
      }
      if (!handle(attempt.interruption)) {
        return false;
      }
    }
  }

  void note_completed(const PlannedTrial& trial, const AttemptRecord& record) {
    newly_completed_.insert(trial.slot);
    last_ = {trial.condition, record.ratings.front().rating,
             static_cast<std::int64_t>(record.clicks.size())};
    if (trial.phase == TrialPhase::kPractice) {
      practice_[trial.slot] = last_;
    }
    const double latency_ms = record.gaze_latency_p95_ms.value_or(0.0);
    result_.slow_gaze_trials += latency_ms > kWarnedGazeLatency_ms ? 1 : 0;
    result_.late_gaze_trials += latency_ms > kMarkedGazeLatency_ms ? 1 : 0;
  }

  bool after_trial(TrialPhase phase, std::int64_t done, std::int64_t total) {
    if (phase == TrialPhase::kPractice) {
      ++practice_use_[last_.rating];
      return ask(practice_feedback(script_, last_.rating, last_.clicks, progress())).has_value();
    }
    const bool break_due = script_.break_every > 0 && done % script_.break_every == 0;
    if (!break_due || done == total) {
      return true;
    }
    ports_.recorder.save(NoteRecord{"break", "after main trial " + std::to_string(done)});
    return ask(break_page(script_.break_text, done, total, progress())).has_value();
  }

  bool summarise_practice() {
    if (practice_use_.empty()) {
      return true;  // all of it was done in an earlier session
    }
    return ask(practice_summary(script_.scale, practice_use_, progress())).has_value();
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
    ports_.input.ask(thanks_page(script_.thanks, progress()));
    return true;
  }

  /// Asks until there is an answer; nothing when the participant quits or the display closes.
  std::optional<Answer> ask(const Page& page) {
    while (true) {
      Answer answer = ports_.input.ask(page);
      if (answer.interruption == Interruption::kNone) {
        return answer;
      }
      if (!handle(answer.interruption)) {
        return std::nullopt;
      }
    }
  }

  bool handle(Interruption interruption) {
    return interruption == Interruption::kPauseRequested ? pause() : display_closed();
  }

  bool pause() {
    ports_.recorder.save(NoteRecord{"pause", progress().label});
    while (true) {
      const Answer answer = ports_.input.ask(pause_page(progress()));
      if (answer.interruption == Interruption::kDisplayClosed) {
        return display_closed();
      }
      if (answer.choice == kContinueChoice) {
        ports_.recorder.save(NoteRecord{"continue", ""});
        return true;
      }
      const Answer sure = ports_.input.ask(quit_page(progress()));
      if (sure.interruption == Interruption::kDisplayClosed) {
        return display_closed();
      }
      if (sure.choice == kQuitChoice) {
        ports_.recorder.save(NoteRecord{"quit", ""});
        ending_ = SessionEnding::kQuit;
        return false;
      }
    }
  }

  bool display_closed() {
    ports_.recorder.save(NoteRecord{"display closed", ""});
    ending_ = SessionEnding::kDisplayClosed;
    return false;
  }

  struct PhaseTrials {
    std::vector<const PlannedTrial*> waiting;
    std::int64_t total{0};
  };

  /// `round` of practice; 0 for all rounds and for the main trials.
  [[nodiscard]] PhaseTrials trials_of(TrialPhase phase, std::int64_t round) const {
    PhaseTrials trials;
    for (const PlannedTrial& trial : plan_) {
      if (trial.phase != phase || (round > 0 && trial.repetition != round)) {
        continue;
      }
      ++trials.total;
      if (!is_completed(trial.slot)) {
        trials.waiting.push_back(&trial);
      }
    }
    return trials;
  }

  [[nodiscard]] bool is_completed(std::int64_t slot) const {
    return history_.completed_slots.contains(slot) || newly_completed_.contains(slot);
  }

  [[nodiscard]] bool main_has_begun() const {
    const PhaseTrials main = trials_of(TrialPhase::kMain, 0);
    return static_cast<std::int64_t>(main.waiting.size()) < main.total;
  }

  [[nodiscard]] std::int64_t last_round() const {
    std::int64_t last = 0;
    for (const PlannedTrial& trial : plan_) {
      last = trial.phase == TrialPhase::kPractice ? std::max(last, trial.repetition) : last;
    }
    return last;
  }

  [[nodiscard]] std::int64_t attempts_before(std::int64_t slot) const {
    const auto found = history_.attempts.find(slot);
    return found == history_.attempts.end() ? 0 : found->second;
  }

  [[nodiscard]] std::int64_t completed_count() const {
    return static_cast<std::int64_t>(history_.completed_slots.size() + newly_completed_.size());
  }

  [[nodiscard]] Progress progress() const {
    // Rounds of practice after the present one may never be needed.
    const auto total = std::count_if(plan_.begin(), plan_.end(), [&](const PlannedTrial& trial) {
      return trial.phase == TrialPhase::kMain ||
             trial.repetition <= std::max<std::int64_t>(1, round_) || is_completed(trial.slot);
    });
    return {completed_count(), total, ""};
  }

  [[nodiscard]] Progress trial_progress(TrialPhase phase, std::int64_t number,
                                        std::int64_t total) const {
    Progress here = progress();
    here.label = std::string(phase == TrialPhase::kPractice ? "Practice " : "Trial ") +
                 std::to_string(number) + " of " + std::to_string(total);
    return here;
  }

  const Script& script_;
  const Plan& plan_;
  const SessionHistory& history_;
  const Ports& ports_;
  SessionEnding ending_{SessionEnding::kQuit};
  std::set<std::int64_t> newly_completed_;
  std::map<std::int64_t, PracticeResult> practice_;    ///< by slot, earlier sessions' too
  std::map<std::int64_t, std::int64_t> practice_use_;  ///< how often each rating was given
  std::int64_t round_{1};                              ///< of practice
  PracticeResult last_;
  SessionResult result_;
};

}  // namespace

SessionResult run_session(const Script& script, const Plan& plan, const SessionHistory& history,
                          const Ports& ports) {
  return Session(script, plan, history, ports).run();
}

}  // namespace impetus
