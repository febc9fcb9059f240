// SPDX-License-Identifier: MIT
#include "experiments/commands/replays/replay_levels.hpp"

#include <cstdio>
#include <map>
#include <set>

#include "experiments/questions/level_value.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "experiments/store/adaptive_rows.hpp"

namespace impetus::inline commands {
namespace {

RecordedLevel recorded(const StoredAdaptiveTrial& trial, const Design& design) {
  RecordedLevel level;
  level.trial_id = trial.trial_id;
  level.chosen.slot = trial.slot;
  level.chosen.condition = condition_from_json(nlohmann::json::parse(trial.condition), design);
  level.chosen.state = condition_from_json(nlohmann::json::parse(trial.state));
  level.track = trial.track;
  level.completed = trial.completed;
  level.counted_answer = trial.counted_answer;
  return level;
}

}  // namespace

std::vector<LevelDivergence> divergent_levels(StudyFile& study, ReplayLibrary& library) {
  std::map<std::int64_t, std::vector<StoredAdaptiveTrial>> by_enrolment;
  for (StoredAdaptiveTrial& trial : load_adaptive_trials(study)) {
    by_enrolment[trial.enrolment_id].push_back(std::move(trial));
  }
  std::vector<LevelDivergence> divergences;
  for (const auto& [enrolment, trials] : by_enrolment) {
    const Design& design = library.protocol(trials.front().protocol_id).design;
    std::vector<RecordedLevel> levels;
    for (const StoredAdaptiveTrial& trial : trials) {
      levels.push_back(recorded(trial, design));
    }
    const auto found = level_divergences(design, levels);
    divergences.insert(divergences.end(), found.begin(), found.end());
  }
  return divergences;
}

std::int64_t compare_levels(StudyFile& study, const std::vector<StoredAttempt>& attempts,
                            ReplayLibrary& library) {
  std::set<std::int64_t> asked;
  for (const StoredAttempt& attempt : attempts) {
    asked.insert(attempt.trial_id);
  }
  std::int64_t diverged = 0;
  for (const LevelDivergence& divergence : divergent_levels(study, library)) {
    if (asked.contains(divergence.trial_id)) {
      std::printf("trial %lld: %s\n", static_cast<long long>(divergence.trial_id),
                  divergence.words.c_str());
      ++diverged;
    }
  }
  return diverged;
}

}  // namespace impetus::inline commands
