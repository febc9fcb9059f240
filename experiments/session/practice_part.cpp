// SPDX-License-Identifier: MIT
#include "experiments/session/practice_part.hpp"

#include <optional>

#include "experiments/questions/session_pages.hpp"
#include "experiments/session/demonstration.hpp"
#include "experiments/session/practice.hpp"

namespace impetus::inline session {

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
    if (round < last_round && !sitting_.ask(practice_again(missing, sitting_.progress()))) {
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
  const auto answer = sitting_.ask(practice_not_understood(sitting_.progress()));
  if (answer && answer->choice != kContinueChoice) {
    sitting_.ports.recorder.save(NoteRecord{"quit", ""});
    return sitting_.talk.end(SessionEnding::kQuit);
  }
  return answer.has_value();
}

}  // namespace impetus::inline session
