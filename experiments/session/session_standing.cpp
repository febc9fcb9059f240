// SPDX-License-Identifier: MIT
#include "experiments/session/session_standing.hpp"

#include <algorithm>

namespace impetus::inline session {

void SessionStanding::complete(const PlannedTrial& trial, const PracticeResult& result) {
  newly_completed_.insert(trial.slot);
  if (trial.phase == TrialPhase::kPractice) {
    practice_[trial.slot] = result;
  }
}

PhaseTrials SessionStanding::trials_of(TrialPhase phase, std::int64_t round) const {
  PhaseTrials trials;
  const bool of_practice = phase == TrialPhase::kPractice;
  for (const PlannedTrial& trial : plan_) {
    if (trial.is_practice() != of_practice || (round > 0 && trial.repetition != round)) {
      continue;
    }
    trials.total += trial.is_asked() ? 1 : 0;
    if (!is_completed(trial.slot)) {
      trials.waiting.push_back(&trial);
    } else {
      trials.done += trial.is_asked() ? 1 : 0;
    }
  }
  return trials;
}

std::vector<PracticeResult> SessionStanding::practice_results(std::int64_t round) const {
  std::vector<PracticeResult> results;
  for (const PlannedTrial& trial : plan_) {
    const auto found = practice_.find(trial.slot);
    if (trial.phase == TrialPhase::kPractice && (round == 0 || trial.repetition == round) &&
        found != practice_.end()) {
      results.push_back(found->second);
      results.back().condition = trial.condition;
    }
  }
  return results;
}

bool SessionStanding::main_has_begun() const {
  return std::any_of(plan_.begin(), plan_.end(), [&](const PlannedTrial& trial) {
    return !trial.is_practice() && is_completed(trial.slot);
  });
}

bool SessionStanding::is_block_done(std::int64_t block) const {
  const std::vector<const PlannedTrial*> waiting = trials_of(TrialPhase::kMain, 0).waiting;
  return std::none_of(waiting.begin(), waiting.end(),
                      [&](const PlannedTrial* trial) { return trial->block == block; });
}

std::optional<std::int64_t> SessionStanding::next_slot() const {
  if (round_ > 0 && !main_has_begun()) {
    const PhaseTrials practice = trials_of(TrialPhase::kPractice, round_);
    if (!practice.waiting.empty()) {
      return practice.waiting.front()->slot;
    }
  }
  const PhaseTrials main = trials_of(TrialPhase::kMain, 0);
  return main.waiting.empty() ? std::nullopt : std::optional(main.waiting.front()->slot);
}

std::int64_t SessionStanding::last_round() const {
  std::int64_t last = 0;
  for (const PlannedTrial& trial : plan_) {
    last = trial.phase == TrialPhase::kPractice ? std::max(last, trial.repetition) : last;
  }
  return last;
}

std::int64_t SessionStanding::attempts_before(std::int64_t slot) const {
  const auto found = history_.attempts.find(slot);
  return found == history_.attempts.end() ? 0 : found->second;
}

std::int64_t SessionStanding::completed_count() const {
  return static_cast<std::int64_t>(history_.completed_slots.size() + newly_completed_.size());
}

SessionProgress SessionStanding::progress() const {
  const auto total = std::count_if(plan_.begin(), plan_.end(), [&](const PlannedTrial& trial) {
    return !trial.is_practice() || trial.repetition <= round_ || is_completed(trial.slot);
  });
  return {completed_count(), total, "", false, language_, light_pages_};
}

SessionProgress SessionStanding::trial_progress(TrialPhase phase, std::int64_t number,
                                                std::int64_t total, bool at_most) const {
  SessionProgress here = progress();
  const std::initializer_list<Filling> counts{{"number", std::to_string(number)},
                                              {"total", std::to_string(total)}};
  here.label = phase != TrialPhase::kPractice ? language_.text("trial_label", counts)
               : at_most                      ? language_.text("training_label", counts)
                                              : language_.text("practice_label", counts);
  return here;
}

bool SessionStanding::is_completed(std::int64_t slot) const {
  return history_.completed_slots.contains(slot) || newly_completed_.contains(slot);
}

}  // namespace impetus::inline session
