// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/yoke_checks.hpp"

#include <algorithm>

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

bool is_recorded(const json& scene) {
  const json::json_pointer kind(kRegionKindPointer);
  return scene.contains(kind) && scene[kind] == json(kRecordedLevel);
}

std::optional<std::size_t> index_of_kind_factor(const Protocol& protocol) {
  const json& factors = protocol.document.value["design"]["factors"];
  for (std::size_t i = 0; i < factors.size(); ++i) {
    if (factors[i]["pointer"] == json(kRegionKindPointer)) {
      return i;
    }
  }
  return std::nullopt;
}

bool has_level(const Protocol& protocol, std::size_t factor, const char* name) {
  const json& levels = protocol.document.value["design"]["factors"][factor]["levels"];
  return std::any_of(levels.begin(), levels.end(),
                     [&](const json& level) { return level == json(name); });
}

void check_factor(const Protocol& protocol) {
  const auto factor = index_of_kind_factor(protocol);
  if (!factor || !has_level(protocol, *factor, kRecordedLevel)) {
    refuse(protocol.document, "/gaze/yoked_to",
           "expected a factor over " + std::string(kRegionKindPointer) +
               " with the level \"recorded\", but there is none");
  }
  const bool from_here = protocol.script.gaze->yoked_to->protocol.empty();
  if (from_here && !has_level(protocol, *factor, kTrackedLevel)) {
    refuse(protocol.document, "/design/factors/" + std::to_string(*factor) + "/levels",
           "expected the level \"tracked\", whose gaze \"recorded\" follows, or another protocol "
           "in /gaze/yoked_to");
  }
}

}  // namespace

std::optional<std::string> region_kind_factor(const Protocol& protocol) {
  const auto index = index_of_kind_factor(protocol);
  return index ? std::optional(protocol.design.factors[*index].name) : std::nullopt;
}

std::optional<Condition> followed_condition(const Protocol& protocol, const Condition& condition) {
  const auto factor = region_kind_factor(protocol);
  Condition followed = condition;
  const auto level = std::find_if(followed.begin(), followed.end(), [&](const FactorLevel& one) {
    return factor && one.factor == *factor && one.value == LevelValue(std::string(kRecordedLevel));
  });
  if (level == followed.end()) {
    return std::nullopt;
  }
  level->value = std::string(kTrackedLevel);
  return followed;
}

void check_yoking(const Protocol& protocol) {
  if (is_recorded(protocol.scene.value)) {
    refuse(protocol.scene, kRegionKindPointer,
           "expected \"recorded\" only as a level of a protocol's factor, where /gaze/yoked_to "
           "says whose");
  }
  for (const Demonstration& demonstration : protocol.script.demonstrations) {
    if (is_recorded(demonstration_scene(protocol, demonstration.id))) {
      refuse(protocol.document, "/session/demonstrations",
             "expected regions that follow nobody, but " + demonstration.id +
                 " follows a recorded gaze");
    }
  }
  if (protocol.script.gaze && protocol.script.gaze->yoked_to) {
    check_factor(protocol);
    return;
  }
  const auto factor = index_of_kind_factor(protocol);
  if (factor && has_level(protocol, *factor, kRecordedLevel)) {
    refuse(protocol.document, "/gaze",
           "expected the key \"yoked_to\", because regions follow a recorded gaze under \"" +
               protocol.design.factors[*factor].name + "\": \"recorded\", but it is missing");
  }
}

}  // namespace impetus::inline protocol
