// SPDX-License-Identifier: MIT
#include "experiments/lines/standing.hpp"

#include <algorithm>
#include <stdexcept>

#include "experiments/design/adaptive_levels.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "experiments/session/practice.hpp"
#include "experiments/settings/optional_json.hpp"

namespace impetus::inline lines {
namespace {

using nlohmann::json;

PlannedTrial& trial_at(std::int64_t slot, Plan& plan) {
  const auto found = std::find_if(plan.begin(), plan.end(),
                                  [&](const PlannedTrial& trial) { return trial.slot == slot; });
  if (found == plan.end()) {
    throw std::runtime_error("expected a trial of the plan, got " + std::to_string(slot));
  }
  return *found;
}

void add_attempt(const AttemptRecord& attempt, Standing& standing) {
  const PlannedTrial& trial = trial_at(attempt.slot, standing.plan);
  SessionHistory& history = standing.history;
  history.attempts[attempt.slot] = attempt.number;
  if (attempt.outcome != AttemptOutcome::kCompleted) {
    return;
  }
  history.completed_slots.insert(attempt.slot);
  if (trial.phase == TrialPhase::kPractice) {
    history.practice[attempt.slot] = practice_result({}, attempt);
  }
  if (const auto answer = counted_answer(attempt); answer && trial.track) {
    history.counted_answers[attempt.slot] = *answer;
  }
}

}  // namespace

void add(const AnyRecord& record, Standing& standing) {
  if (const auto* attempt = std::get_if<AttemptRecord>(&record)) {
    add_attempt(*attempt, standing);
  } else if (const auto* chosen = std::get_if<ChosenLevel>(&record)) {
    trial_at(chosen->slot, standing.plan).condition = chosen->condition;
  } else if (const auto* question = std::get_if<QuestionRecord>(&record)) {
    if (question->kind != "consent" || question->answer != "declined") {
      standing.history.answered.insert(question->id);
    }
  }
}

json to_json(const Standing& standing, const Design& design) {
  json practice = json::array();
  for (const auto& [slot, result] : standing.history.practice) {
    practice.push_back({slot, result.rating, result.clicks, result.right});
  }
  json levels = json::array();
  for (const PlannedTrial& trial : standing.plan) {
    if (trial.track && has_its_level(trial, design)) {
      levels.push_back({trial.slot, to_json(trial.condition)});
    }
  }
  return {{"completed", standing.history.completed_slots},
          {"attempts", standing.history.attempts},
          {"answered", standing.history.answered},
          {"counted", standing.history.counted_answers},
          {"practice", practice},
          {"levels", levels}};
}

Standing standing_from(const json& from, Plan plan, const Design& design) {
  Standing standing{std::move(plan), {}};
  SessionHistory& history = standing.history;
  history.resumed = true;
  from.at("completed").get_to(history.completed_slots);
  from.at("attempts").get_to(history.attempts);
  from.at("answered").get_to(history.answered);
  from.at("counted").get_to(history.counted_answers);
  for (const json& row : from.at("practice")) {
    PracticeResult& result = history.practice[row.at(0).get<std::int64_t>()];
    row.at(1).get_to(result.rating);
    row.at(2).get_to(result.clicks);
    row.at(3).get_to(result.right);
  }
  for (const json& row : from.at("levels")) {
    trial_at(row.at(0).get<std::int64_t>(), standing.plan).condition =
        condition_from_json(row.at(1), design);
  }
  return standing;
}

}  // namespace impetus::inline lines
