// SPDX-License-Identifier: MIT
#include "experiments/study/stored_plan.hpp"

#include <algorithm>
#include <stdexcept>

#include "experiments/design/between_participants.hpp"
#include "experiments/protocol/solved_values.hpp"

namespace impetus::inline study {

std::vector<StoredTrial> stored(const Plan& plan) {
  std::vector<StoredTrial> trials;
  for (const PlannedTrial& trial : plan) {
    trials.push_back({0, trial.slot, trial.phase, trial.repetition, to_json(trial.condition).dump(),
                      trial.seed, trial.block, trial.catch_trial, trial.track});
    trials.back().solved = to_text(trial.solved);
    trials.back().yoked_trial_id = trial.yoked_trial_id;
  }
  return trials;
}

Plan planned(const std::vector<StoredTrial>& trials, const Design& design) {
  Plan plan;
  for (const StoredTrial& trial : trials) {
    const auto condition = nlohmann::json::parse(trial.condition);
    plan.push_back({trial.slot, trial.phase, trial.repetition,
                    condition_from_json(condition, design), trial.seed, trial.block,
                    trial.catch_trial, trial.track});
    plan.back().solved = solved_values_from(trial.solved);
    plan.back().yoked_trial_id = trial.yoked_trial_id;
  }
  return plan;
}

Condition stored_group(const std::vector<StoredTrial>& trials, const Design& design) {
  const Condition first =
      trials.empty() ? Condition{}
                     : condition_from_json(nlohmann::json::parse(trials.front().condition), design);
  const Condition group = group_of(design, first);
  const std::vector<Condition> known = groups(design);
  if (std::find(known.begin(), known.end(), group) == known.end()) {
    throw std::runtime_error(
        "its first trial is of no group of the factors between participants: " +
        to_json(first).dump());
  }
  return group;
}

ProtocolTexts texts_of(const Protocol& protocol) {
  return {protocol.name, protocol.hash, protocol.document.text, protocol.scene.text};
}

std::string hash_of(const std::string& protocol_json, const std::string& scene_json) {
  return make_protocol(parse_json("protocol", protocol_json), parse_json("scene", scene_json)).hash;
}

}  // namespace impetus::inline study
