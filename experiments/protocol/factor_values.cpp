// SPDX-License-Identifier: MIT
#include "experiments/protocol/factor_values.hpp"

#include <set>

#include "experiments/questions/level_value.hpp"

namespace impetus::inline protocol {

using nlohmann::json;

json values_of(const Factor& factor, const LevelValue& level) {
  if (!factor.pointer.empty()) {
    return {{factor.pointer, to_json(level)}};
  }
  const auto set = factor.sets.find(to_text(level));
  return set == factor.sets.end() ? json::object() : json::parse(set->second);
}

bool has_set(const Factor& factor, const LevelValue& level) {
  const auto* word = std::get_if<std::string>(&level);
  return word != nullptr && factor.sets.contains(*word);
}

std::vector<std::string> overridden_by(const Factor& factor) {
  if (!factor.pointer.empty()) {
    return {factor.pointer};
  }
  std::set<std::string> pointers;
  for (const auto& [level, text] : factor.sets) {
    const json values = json::parse(text);
    for (auto value = values.begin(); value != values.end(); ++value) {
      pointers.insert(value.key());
    }
  }
  return {pointers.begin(), pointers.end()};
}

}  // namespace impetus::inline protocol
