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

Resumption resume(const ResumeRule& rule, const Plan& plan, SessionHistory& history) {
  Resumption resumption;
  if (rule.at == ResumeRule::At::kBlock) {
    if (const auto block = begun_block(plan, history)) {
      resumption.set_aside = done_of_block(plan, history, *block);
    }
    for (const std::int64_t slot : resumption.set_aside) {
      history.completed_slots.erase(slot);
    }
  }
  resumption.first_slot = SessionStanding(plan, history).next_slot();
  return resumption;
}

}  // namespace impetus::inline session
