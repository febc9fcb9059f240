// SPDX-License-Identifier: MIT
#include "experiments/design/design.hpp"

#include <algorithm>

#include "experiments/settings/input_error.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline design {

std::size_t factor_place(const Design& design, const std::string& name) {
  const auto found = std::find_if(design.factors.begin(), design.factors.end(),
                                  [&](const Factor& factor) { return factor.name == name; });
  return static_cast<std::size_t>(found - design.factors.begin());
}

const Factor* find_factor(const Design& design, const std::string& name) {
  const std::size_t place = factor_place(design, name);
  return place < design.factors.size() ? &design.factors[place] : nullptr;
}

bool has_level(const Factor& factor, const LevelValue& level) {
  return std::find(factor.levels.begin(), factor.levels.end(), level) != factor.levels.end();
}

std::vector<ConditionBeside> conditions_beside(const Design& design) {
  std::vector<ConditionBeside> beside;
  const auto add = [&](const std::string& place, const Condition& condition) {
    beside.push_back({place, condition});
  };
  for (std::size_t i = 0; i < design.catch_trials.size(); ++i) {
    add("/design/catch_trials/" + std::to_string(i) + "/condition",
        design.catch_trials[i].condition);
  }
  for (std::size_t i = 0; i < design.adaptation.size(); ++i) {
    const std::vector<Condition>& conditions = design.adaptation[i].conditions;
    for (std::size_t j = 0; j < conditions.size(); ++j) {
      add("/design/adaptation/" + std::to_string(i) + "/conditions/" + std::to_string(j),
          conditions[j]);
    }
  }
  return beside;
}

bool has_levels(const Condition& condition, const Condition& levels) {
  return std::all_of(levels.begin(), levels.end(), [&](const FactorLevel& level) {
    return std::find(condition.begin(), condition.end(), level) != condition.end();
  });
}

const FactorLevel* find_level(const Condition& condition, const std::string& factor) {
  const auto found = std::find_if(condition.begin(), condition.end(),
                                  [&](const FactorLevel& level) { return level.factor == factor; });
  return found == condition.end() ? nullptr : &*found;
}

std::vector<double> numbers(const std::vector<LevelValue>& levels) {
  std::vector<double> numbers;
  numbers.reserve(levels.size());
  for (const LevelValue& level : levels) {
    numbers.push_back(std::get<double>(level));
  }
  return numbers;
}

std::vector<Condition> cells_of(const Design& design, const std::vector<std::string>& factors) {
  Design part;
  for (const Factor& factor : design.factors) {
    if (std::find(factors.begin(), factors.end(), factor.name) != factors.end()) {
      part.factors.push_back(factor);
    }
  }
  return cells(part);
}

std::vector<Condition> cells(const Design& design) {
  std::vector<Condition> result{Condition{}};
  for (const Factor& factor : design.factors) {
    std::vector<Condition> wider;
    for (const Condition& condition : result) {
      for (const LevelValue& level : factor.levels) {
        wider.push_back(condition);
        wider.back().push_back({factor.name, level});
      }
    }
    result = std::move(wider);
  }
  return result;
}

std::string to_text(const LevelValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    return *text;
  }
  if (const auto* flag = std::get_if<bool>(&value)) {
    return *flag ? "true" : "false";
  }
  return exact_number(std::get<double>(value));
}

std::string condition_words(const Condition& condition) {
  return listed(condition,
                [](const FactorLevel& level) { return level.factor + " " + to_text(level.value); });
}

}  // namespace impetus::inline design
