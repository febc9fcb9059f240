// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/catch_checks.hpp"

#include <algorithm>
#include <string>

#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/design_reading.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

std::string condition_of_kind(std::size_t index) {
  return "/design/catch_trials/" + std::to_string(index) + "/condition";
}

const char* words_of_type(const json& value) {
  return value.is_string() ? "a text" : value.is_boolean() ? "a boolean" : "a number";
}

bool is_alike(const json& a, const json& b) {
  return a.is_number() ? b.is_number() : a.type() == b.type();
}

void check_condition(const JsonDocument& protocol, const std::string& place,
                     const json& condition) {
  const json& design = protocol.value["design"];
  for (const json& factor : design["factors"]) {
    const auto name = factor["name"].get<std::string>();
    if (!condition.contains(name)) {
      refuse(protocol, place, "expected a level for every factor, but \"" + name + "\" has none");
    }
    const json& own = factor["levels"].front();
    if (!is_alike(own, condition[name])) {
      refuse(protocol, place + "/" + name,
             std::string("expected ") + words_of_type(own) +
                 ", as the factor's own levels are, got " + condition[name].dump());
    }
  }
  for (auto level = condition.begin(); level != condition.end(); ++level) {
    if (!has_factor(design, level.key())) {
      refuse(protocol, place,
             "expected only factors of the design, got " + json(level.key()).dump());
    }
  }
}

}  // namespace

void check_catch_trials(const JsonDocument& protocol) {
  const json kinds = protocol.value["design"].value("catch_trials", json::array());
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const json& condition = kinds[i]["condition"];
    check_condition(protocol, condition_of_kind(i), condition);
    for (std::size_t before = 0; before < i; ++before) {
      if (kinds[before]["condition"] == condition) {
        refuse(protocol, condition_of_kind(i),
               "expected a condition of its own, got " + condition.dump() + " again");
      }
    }
  }
}

void check_catch_scenes(const Protocol& protocol) {
  for (std::size_t i = 0; i < protocol.design.catch_trials.size(); ++i) {
    for (const FactorLevel& level : protocol.design.catch_trials[i].condition) {
      const std::string message = complaint(scene_under(protocol, {level}));
      if (!message.empty()) {
        refuse(protocol.document, condition_of_kind(i) + "/" + level.factor, message);
      }
    }
    const std::string message =
        complaint(scene_under(protocol, protocol.design.catch_trials[i].condition));
    if (!message.empty()) {
      refuse(protocol.document, condition_of_kind(i), message);
    }
  }
}

}  // namespace impetus::inline protocol
