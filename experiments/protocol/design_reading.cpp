// SPDX-License-Identifier: MIT
#include "experiments/protocol/design_reading.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/questions/level_value.hpp"
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline protocol {

using nlohmann::json;

namespace {

Blocks blocks_from(const json& object) {
  const auto order = object["order"].get<std::string>();
  return {object["factors"].get<std::vector<std::string>>(),
          order == "fixed"          ? Blocks::Order::kFixed
          : order == "latin-square" ? Blocks::Order::kLatinSquare
                                    : Blocks::Order::kRandom};
}

Staircase staircase_from(const json& object) {
  Staircase staircase;
  staircase.up = object["up"].get<std::int64_t>();
  staircase.down = object["down"].get<std::int64_t>();
  staircase.steps = object.value("steps", std::vector<std::int64_t>{1});
  for (const json& start : object["starts"]) {
    staircase.starts.push_back(level_value(start));
  }
  return staircase;
}

QuestPlus quest_plus_from(const json& object) {
  const auto function = object["function"].get<std::string>();
  const auto scale = object["scale"].get<std::string>();
  QuestPlus quest_plus;
  quest_plus.function =
      function == "normal" ? QuestPlus::Function::kNormal : QuestPlus::Function::kWeibull;
  quest_plus.scale = scale == "decibel" ? QuestPlus::Scale::kDecibel
                     : scale == "log10" ? QuestPlus::Scale::kLog10
                                        : QuestPlus::Scale::kLinear;
  quest_plus.thresholds = object["thresholds"].get<std::vector<double>>();
  quest_plus.slopes = object["slopes"].get<std::vector<double>>();
  quest_plus.guess_rates = object["guess_rates"].get<std::vector<double>>();
  quest_plus.lapse_rates = object["lapse_rates"].get<std::vector<double>>();
  return quest_plus;
}

Adaptive adaptive_from(const json& object) {
  Adaptive adaptive;
  adaptive.factor = object["factor"].get<std::string>();
  adaptive.trials_per_track = object["trials_per_track"].get<std::int64_t>();
  if (object.contains("staircase")) {
    adaptive.method = staircase_from(object["staircase"]);
  } else {
    adaptive.method = quest_plus_from(object["quest_plus"]);
  }
  return adaptive;
}

}  // namespace

json to_json(const LevelValue& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    const bool whole = std::floor(*number) == *number && std::abs(*number) < 1e15;
    return whole ? json(static_cast<std::int64_t>(*number)) : json(*number);
  }
  return std::visit([](const auto& any) { return json(any); }, value);
}

Design design_from(const json& object) {
  Design design;
  for (const json& entry : object["factors"]) {
    Factor factor{entry["name"].get<std::string>(), {}};
    for (const json& level : entry["levels"]) {
      factor.levels.push_back(level_value(level));
    }
    design.factors.push_back(std::move(factor));
  }
  design.repetitions = object["repetitions"].get<std::int64_t>();
  if (object.contains("practice_until")) {
    design.practice_rounds = object["practice_until"]["rounds"].get<std::int64_t>();
  }
  if (object.contains("train_until")) {
    const auto most = object["train_until"]["most_trials"].get<std::int64_t>();
    const auto round = static_cast<std::int64_t>(object.value("practice", json::array()).size());
    design.most_practice_trials = most;
    design.practice_rounds = round > 0 ? (most + round - 1) / round : 0;
  }
  for (const json& rule : object.value("longest_runs", json::array())) {
    design.longest_runs.push_back(
        {rule["factor"].get<std::string>(), rule["longest"].get<std::int64_t>()});
  }
  if (object.contains("blocks")) {
    design.blocks = blocks_from(object["blocks"]);
  }
  for (const json& kind : object.value("catch_trials", json::array())) {
    design.catch_trials.push_back(
        {condition_from_json(kind["condition"], design), kind["count"].get<std::int64_t>()});
  }
  if (object.contains("adaptive")) {
    design.adaptive = adaptive_from(object["adaptive"]);
  }
  return design;
}

std::optional<PracticeRule> practice_rule_from(const json& design) {
  if (!design.contains("practice_until")) {
    return std::nullopt;
  }
  const json& rule = design["practice_until"];
  return PracticeRule{rule["factor"].get<std::string>(), level_value(rule["best"]),
                      level_value(rule["worst"])};
}

std::optional<TrainingRule> training_rule_from(const json& design) {
  if (!design.contains("train_until")) {
    return std::nullopt;
  }
  const json& rule = design["train_until"];
  return TrainingRule{rule["right"].get<std::int64_t>(), rule["of"].get<std::int64_t>(),
                      rule["most_trials"].get<std::int64_t>()};
}

json to_json(const Condition& condition) {
  json object = json::object();
  for (const FactorLevel& level : condition) {
    object[level.factor] = to_json(level.value);
  }
  return object;
}

bool has_factor(const json& design, const std::string& name) {
  const json& factors = design["factors"];
  return std::any_of(factors.begin(), factors.end(),
                     [&](const json& factor) { return factor["name"] == name; });
}

Condition condition_from_json(const json& object, const Design& design) {
  Condition condition;
  for (const Factor& factor : design.factors) {
    if (object.contains(factor.name)) {
      condition.push_back({factor.name, level_value(object.at(factor.name))});
    }
  }
  return condition;
}

}  // namespace impetus::inline protocol
