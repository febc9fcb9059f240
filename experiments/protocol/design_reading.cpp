// SPDX-License-Identifier: MIT
#include "experiments/protocol/design_reading.hpp"

#include <cmath>
#include <utility>

namespace impetus {

using nlohmann::json;

LevelValue level_value(const json& value) {
  if (value.is_string()) {
    return value.get<std::string>();
  }
  if (value.is_boolean()) {
    return value.get<bool>();
  }
  return value.get<double>();
}

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

Condition condition_from_json(const json& object, const Design& design) {
  Condition condition;
  for (const Factor& factor : design.factors) {
    condition.push_back({factor.name, level_value(object.at(factor.name))});
  }
  return condition;
}

}  // namespace impetus
