// SPDX-License-Identifier: MIT
#include "experiments/session/session.hpp"

#include <optional>
#include <utility>

#include "experiments/session/session_pages.hpp"

namespace impetus {
namespace {

constexpr const char* kConsentId = "consent";

/// Every stage returns whether the session goes on; when it does not, `ending_` says why.
class Session {
 public:
  Session(const Script& script, const Plan& plan, const SessionHistory& history, const Ports& ports)
      : script_(script), plan_(plan), history_(history), ports_(ports) {}

  SessionResult run() {
    const bool finished = welcome() && ask_consent() && ask_demographics() && instruct() &&
                          run_phase(TrialPhase::kPractice) && run_phase(TrialPhase::kMain) &&
                          ask_questions() && thank();
    ports_.recorder.await_saved();
    return {finished ? SessionEnding::kFinished : ending_, completed_count()};
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

  bool run_phase(TrialPhase phase) {
    const PhaseTrials trials = trials_of(phase);
    if (trials.waiting.empty()) {
      return true;
    }
    if (!ask(phase_intro(phase, trials.waiting.size(), progress()))) {
      return false;
    }
    std::int64_t done = trials.total - static_cast<std::int64_t>(trials.waiting.size());
    for (const PlannedTrial* trial : trials.waiting) {
      const Progress here = trial_progress(phase, done + 1, trials.total);
      if (!run_trial(*trial, here) || !after_trial(phase, ++done, trials.total)) {
        return false;
      }
    }
    return phase == TrialPhase::kMain || summarise_practice();
  }

  /// Shows a trial until it is completed; after a pause it starts again from the interval.
  bool run_trial(const PlannedTrial& trial, const Progress& here) {
    std::int64_t number = attempts_before(trial.slot);
    while (true) {
      AttemptResult attempt = run_attempt(trial, ++number, script_, here, ports_);
      const bool completed = attempt.record.outcome == AttemptOutcome::kCompleted;
      if (completed) {
        last_rating_ = attempt.record.ratings.front().rating;
        newly_completed_.insert(trial.slot);
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

  bool after_trial(TrialPhase phase, std::int64_t done, std::int64_t total) {
    if (phase == TrialPhase::kPractice) {
      ++practice_use_[last_rating_];
      return ask(practice_feedback(script_.scale, last_rating_, progress())).has_value();
    }
    const bool break_due = script_.break_every > 0 && done % script_.break_every == 0;
    if (!break_due || done == total) {
      return true;
    }
    ports_.recorder.save(NoteRecord{"break", "after main trial " + std::to_string(done)});
    return ask(break_page(script_.break_text, done, total, progress())).has_value();
  }

  bool summarise_practice() {
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

  [[nodiscard]] PhaseTrials trials_of(TrialPhase phase) const {
    PhaseTrials trials;
    for (const PlannedTrial& trial : plan_) {
      if (trial.phase != phase) {
        continue;
      }
      ++trials.total;
      if (!history_.completed_slots.contains(trial.slot)) {
        trials.waiting.push_back(&trial);
      }
    }
    return trials;
  }

  [[nodiscard]] std::int64_t attempts_before(std::int64_t slot) const {
    const auto found = history_.attempts.find(slot);
    return found == history_.attempts.end() ? 0 : found->second;
  }

  [[nodiscard]] std::int64_t completed_count() const {
    return static_cast<std::int64_t>(history_.completed_slots.size() + newly_completed_.size());
  }

  [[nodiscard]] Progress progress() const {
    const auto total = static_cast<std::int64_t>(plan_.size());
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
  std::map<std::int64_t, std::int64_t> practice_use_;  ///< how often each rating was given
  std::int64_t last_rating_{0};
};

}  // namespace

SessionResult run_session(const Script& script, const Plan& plan, const SessionHistory& history,
                          const Ports& ports) {
  return Session(script, plan, history, ports).run();
}

}  // namespace impetus
