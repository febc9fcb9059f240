// SPDX-License-Identifier: MIT
#include "experiments/design/design.hpp"

#include <algorithm>

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

std::vector<double> numbers(const std::vector<LevelValue>& levels) {
  std::vector<double> numbers;
  numbers.reserve(levels.size());
  for (const LevelValue& level : levels) {
    numbers.push_back(std::get<double>(level));
  }
  return numbers;
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

}  // namespace impetus::inline design
