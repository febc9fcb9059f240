// SPDX-License-Identifier: MIT
#include "experiments/session/session.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "experiments/questions/script.hpp"
#include "experiments/questions/session_pages.hpp"
#include "experiments/record/frame_grid.hpp"
#include "experiments/run/live_run.hpp"
#include "experiments/session/practice.hpp"
#include "experiments/session/trial.hpp"
#include "experiments/session/trial_sequence.hpp"

namespace impetus::inline session {
namespace {

/// The part of a session before its main trials: demonstrations, then practice until it suffices.
class PracticePart {
 public:
  /// Both must outlive this.
  PracticePart(const Sitting& sitting, TrialSequence& trials)
      : sitting_(sitting), trials_(trials) {}

  /// Demonstrations, then practice; nothing once main trials have begun. Whether the session goes
  /// on; when it does not, the sitting's conversation knows why.
  bool run();

 private:
  bool train();
  bool practise_rounds();
  bool demonstrate();
  [[nodiscard]] std::vector<std::string> missing_in(std::int64_t round) const;
  bool ask_whether_to_go_on();

  const Sitting& sitting_;
  TrialSequence& trials_;
};

/// Plays a demonstration once, a scene that is shown before practice without a task, after an
/// interval; nothing of it is recorded. Returns what
/// interrupted it.
Interruption show_demonstration(const std::string& id, const Script& script,
                                const SessionProgress& progress, const Ports& ports) {
  LiveRun live(ports.scenes.stage_demonstration(id, ports.display.geometry()), 0, ports.work_clock);
  const double hz = ports.display.refresh_hz();
  const std::int64_t interval = whole_frames(script.timing.interval_ms / 1e3, hz);
  const SessionProgress shown = script.progress_during_stimuli ? progress : SessionProgress{};
  ports.display.restart_grid();
  for (std::int64_t frame = -interval; frame <= whole_frames(live.ends_s(), hz); ++frame) {
    const double time_s = std::max(0.0, static_cast<double>(frame) / hz);
    const std::vector<Pose> poses = frame < 0 ? std::vector<Pose>{} : live.poses_at(time_s);
    ports.display.show(picture_of(live.scene(), poses, time_s, shown));
    const Interruption interruption = ports.input.interruption();
    if (interruption != Interruption::kNone) {
      return interruption;
    }
  }
  return Interruption::kNone;
}

bool PracticePart::run() {
  const bool goes_on =
      sitting_.standing.main_has_begun() ||
      (demonstrate() && (sitting_.script.training_rule ? train() : practise_rounds()));
  if (goes_on) {
    sitting_.standing.end_practice();
  }
  return goes_on;
}

/// Practice trials until enough of the last ones were answered right, or none is left.
bool PracticePart::train() {
  const TrainingRule& rule = *sitting_.script.training_rule;
  const PhaseTrials trials = sitting_.standing.trials_of(TrialPhase::kPractice, 0);
  std::int64_t done = trials.total - static_cast<std::int64_t>(trials.waiting.size());
  if (is_trained(rule, sitting_.standing.practice_results(0))) {
    return true;  // in an earlier session
  }
  if (!trials.waiting.empty() && !sitting_.ask(training_intro(rule, sitting_.progress()))) {
    return false;
  }
  for (const PlannedTrial* trial : trials.waiting) {
    sitting_.standing.begin_round(trial->repetition);
    const SessionProgress here =
        sitting_.standing.trial_progress(TrialPhase::kPractice, ++done, trials.total, true);
    if (!trials_.run_one(*trial, here, done, trials.total)) {
      return false;
    }
    if (is_trained(rule, sitting_.standing.practice_results(0))) {
      return sitting_
          .ask(training_over(right_of_last(rule.of, sitting_.standing.practice_results(0)), rule.of,
                             sitting_.progress()))
          .has_value();
    }
  }
  return ask_whether_to_go_on();
}

/// Rounds of practice until one was understood.
bool PracticePart::practise_rounds() {
  const std::int64_t last_round = sitting_.standing.last_round();
  for (std::int64_t round = 1; round <= last_round; ++round) {
    sitting_.standing.begin_round(round);
    if (!trials_.run_phase(TrialPhase::kPractice, round)) {
      return false;
    }
    const std::vector<std::string> missing = missing_in(round);
    if (missing.empty()) {
      return trials_.summarise_practice();
    }
    const bool begins = round < last_round &&
                        sitting_.standing.trials_of(TrialPhase::kPractice, round + 1).done == 0;
    if (begins && !sitting_.ask(practice_again(missing, sitting_.progress()))) {
      return false;
    }
  }
  return last_round == 0 || ask_whether_to_go_on();
}

bool PracticePart::demonstrate() {
  for (const Demonstration& demonstration : sitting_.script.demonstrations) {
    if (!sitting_.ask(text_page(demonstration.text, sitting_.progress()))) {
      return false;
    }
    std::optional<Answer> again;
    do {
      sitting_.ports.recorder.save(NoteRecord{"demonstration", demonstration.id});
      const Interruption interruption = show_demonstration(demonstration.id, sitting_.script,
                                                           sitting_.progress(), sitting_.ports);
      if (interruption != Interruption::kNone && !sitting_.talk.handle(interruption)) {
        return false;
      }
      again = sitting_.ask(demonstration_over(demonstration.text, sitting_.progress()));
    } while (again && again->choice == kAgainChoice);
    if (!again) {
      return false;
    }
  }
  return true;
}

/// What the round of practice lacks to be understood; nothing where nobody asks.
std::vector<std::string> PracticePart::missing_in(std::int64_t round) const {
  if (!sitting_.script.practice_rule) {
    return {};
  }
  return missing_in_practice(*sitting_.script.practice_rule, sitting_.script,
                             sitting_.standing.practice_results(round));
}

/// Practice was not understood in all its rounds: the experimenter decides.
bool PracticePart::ask_whether_to_go_on() {
  sitting_.ports.recorder.save(NoteRecord{"practice not understood", ""});
  return sitting_.ask_whether_to_go_on(practice_not_understood(sitting_.progress()));
}

constexpr const char* kConsentId = "consent";

/// Every stage returns whether the session goes on; when it does not, `talk_` knows why.
class Session {
 public:
  Session(const Script& script, const Plan& plan, const SessionHistory& history, const Ports& ports,
          const Design& design)
      : script_(script),
        history_(history),
        ports_(ports),
        standing_(plan, history, script.language, script.light_pages),
        talk_(ports.input, ports.recorder, standing_),
        sitting_{script, design, ports_, standing_, talk_, calibration_},
        trials_(sitting_, levels_after(history, plan, design)) {
    go_on_with_practice(script, standing_);
    if (script.gaze && script.gaze->calibration && ports.gaze != nullptr && !plan.empty()) {
      calibration_.emplace(*script.gaze->calibration, plan.front().seed, ports_, talk_, standing_);
    }
  }

  SessionResult run() {
    const bool finished = welcome() && ask_consent() && ask_demographics() && instruct() &&
                          calibrate() && PracticePart(sitting_, trials_).run() &&
                          trials_.run_phase(TrialPhase::kMain, 0) && ask_questions() && thank();
    ports_.recorder.await_saved();
    return {finished ? SessionEnding::kFinished : talk_.ending(), standing_.completed_count(),
            standing_.progress().total, trials_.gaze_troubles()};
  }

 private:
  /// Who was interrupted before consenting has begun nothing to come back to.
  bool welcome() {
    const bool back = history_.resumed && history_.answered.contains(kConsentId);
    const Text text =
        back ? welcome_back(script_.language, standing_.completed_count()) : script_.welcome;
    return ask(text_page(text, progress())).has_value();
  }

  /// Asks until there is a consent, or a refusal that was confirmed.
  bool ask_consent() {
    if (history_.answered.contains(kConsentId)) {
      return true;
    }
    const Page page = consent_page(script_.consent, script_.consent_statement, progress());
    while (const auto answer = ask(page)) {
      const auto choice = static_cast<ConsentChoice>(answer->choice);
      if (choice == ConsentChoice::kAgree) {
        save_consent(page.statement, "agreed");
        return true;
      }
      const auto next = ask_after(choice);
      if (!next) {
        return false;
      }
      if (choice == ConsentChoice::kDecline && next->choice != kBackChoice) {
        return decline(page.statement);
      }
    }
    return false;
  }

  /// What comes between the consent page and its return: the welcome again, or whether a refusal is
  /// meant.
  std::optional<Answer> ask_after(ConsentChoice choice) {
    return ask(choice == ConsentChoice::kBack ? text_page(script_.welcome, progress())
                                              : refusal_page(progress()));
  }

  /// Saved before the words, as a finished session is.
  bool decline(const std::string& statement) {
    save_consent(statement, "declined");
    ports_.recorder.await_saved();
    ports_.input.ask(declined_page(progress()));
    return talk_.end(SessionEnding::kDeclined);
  }

  void save_consent(const std::string& statement, const char* answer) {
    ports_.recorder.save(QuestionRecord{"consent", kConsentId, statement, answer});
  }

  /// A session that ended while they were saved is asked what is missing.
  bool ask_demographics() {
    std::vector<Field> fields = script_.demographics;
    std::erase_if(fields, [&](const Field& field) { return history_.answered.contains(field.id); });
    if (fields.empty()) {
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
    const std::vector<Text>& texts = script_.instructions;
    for (std::size_t at = 0; at < texts.size();) {
      const auto answer = ask(at == 0 ? text_page(texts[at], progress())
                                      : text_page_with_way_back(texts[at], progress()));
      if (!answer) {
        return false;
      }
      at = at > 0 && answer->choice == kBackChoice ? at - 1 : at + 1;
    }
    return true;
  }

  /// In every session anew; nothing where no trial waits.
  bool calibrate() {
    const auto next = standing_.next_slot();
    return !calibration_ || !next || calibration_->calibrate(*next);
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
  Sitting sitting_;
  TrialSequence trials_;
};

}  // namespace

SessionResult run_session(const Script& script, const Plan& plan, const SessionHistory& history,
                          const Ports& ports, const Design& design) {
  return Session(script, plan, history, ports, design).run();
}

}  // namespace impetus::inline session
