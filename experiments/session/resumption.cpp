// SPDX-License-Identifier: MIT
#include "experiments/session/resumption.hpp"

namespace impetus::inline session {
namespace {

/// The block of the first main trial that waits, where some of the main trials are done.
std::optional<std::int64_t> begun_block(const Plan& plan, const SessionHistory& history) {
  for (const PlannedTrial& trial : plan) {
    if (!trial.is_practice() && !history.completed_slots.contains(trial.slot)) {
      return trial.block;
    }
  }
  return std::nullopt;
}

std::set<std::int64_t> done_of_block(const Plan& plan, const SessionHistory& history,
                                     std::int64_t block) {
  std::set<std::int64_t> done;
  for (const PlannedTrial& trial : plan) {
    if (!trial.is_practice() && trial.block == block &&
        history.completed_slots.contains(trial.slot)) {
      done.insert(trial.slot);
    }
  }
  return done;
}

}  // namespace

Resumption resume(const Script& script, const Plan& plan, SessionHistory& history) {
  Resumption resumption;
  if (script.resume.at == ResumeRule::At::kBlock) {
    if (const auto block = begun_block(plan, history)) {
      resumption.set_aside = done_of_block(plan, history, *block);
    }
    for (const std::int64_t slot : resumption.set_aside) {
      history.completed_slots.erase(slot);
    }
  }
  SessionStanding standing(plan, history);
  go_on_with_practice(script, standing);
  resumption.first_slot = standing.next_slot();
  return resumption;
}

void go_on_with_practice(const Script& script, SessionStanding& standing) {
  const bool trained =
      script.training_rule && is_trained(*script.training_rule, standing.practice_results(0));
  const auto is_understood = [&](std::int64_t round) {
    return !script.training_rule &&
           (!script.practice_rule ||
            missing_in_practice(*script.practice_rule, script, standing.practice_results(round))
                .empty());
  };
  for (std::int64_t round = 1; !trained && round <= standing.last_round(); ++round) {
    standing.begin_round(round);
    if (!standing.trials_of(TrialPhase::kPractice, round).waiting.empty()) {
      return;
    }
    if (is_understood(round)) {
      break;
    }
  }
  standing.end_practice();
}

}  // namespace impetus::inline session
