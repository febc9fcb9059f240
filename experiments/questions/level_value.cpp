// SPDX-License-Identifier: MIT
#include "experiments/questions/level_value.hpp"

#include <cmath>

namespace impetus::inline questions {

using nlohmann::json;

LevelValue level_value(const json& value) {
  if (value.is_string()) {
    return value.get<std::string>();
  }
  if (value.is_boolean()) {
    return value.get<bool>();
  }
  return value.is_null() ? LevelValue{} : value.get<double>();
}

Kind<LevelValue> factor_level_kind() {
  const OrderedJson types{{"type", {"number", "string", "boolean"}}};
  return defined("level", Kind<LevelValue>{{types}, level_value});
}

Kind<LevelValue> own_level_kind() {
  const OrderedJson types{{"type", {"number", "string", "boolean", "null"}}};
  return defined("level_or_null", Kind<LevelValue>{{types}, level_value},
                 "null: as the scene says.");
}

Kind<Condition> condition_kind() {
  const auto read = [](const json& levels) { return condition_from_json(levels); };
  return defined("condition", Kind<Condition>{by_name_form(own_level_kind()), read},
                 "A level for every factor, by name.");
}

json to_json(const LevelValue& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    const bool whole = std::floor(*number) == *number && std::abs(*number) < 1e15;
    return whole ? json(static_cast<std::int64_t>(*number)) : json(*number);
  }
  return std::visit([](const auto& any) { return json(any); }, value);
}

json to_json(const Condition& condition) {
  json object = json::object();
  for (const FactorLevel& level : condition) {
    object[level.factor] = to_json(level.value);
  }
  return object;
}

Condition condition_from_json(const json& object) {
  Condition condition;
  for (auto level = object.begin(); level != object.end(); ++level) {
    condition.push_back({level.key(), level_value(level.value())});
  }
  return condition;
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

std::string list_text(const std::vector<LevelValue>& levels) {
  json list = json::array();
  for (const LevelValue& level : levels) {
    list.push_back(to_json(level));
  }
  return list.dump();
}

const Factor& named_factor(const JsonDocument& protocol, const std::string& place,
                           const Design& design, const std::string& name) {
  const Factor* factor = find_factor(design, name);
  if (factor == nullptr) {
    refuse(protocol, place, "expected the name of a factor, got " + json_text(name));
  }
  return *factor;
}

const Factor& factor_within(const JsonDocument& protocol, const std::string& place,
                            const Design& design, const std::string& name) {
  const Factor& factor = named_factor(protocol, place, design, name);
  if (factor.between) {
    refuse(protocol, place,
           "expected a factor that varies within participants, got " + json_text(name) +
               ", which is between them");
  }
  return factor;
}

}  // namespace impetus::inline questions
