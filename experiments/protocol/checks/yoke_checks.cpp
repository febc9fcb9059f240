// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/yoke_checks.hpp"

#include <algorithm>

#include "experiments/questions/two_interval.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

bool is_recorded(const json& scene) {
  const json::json_pointer kind(kRegionKindPointer);
  return scene.contains(kind) && scene[kind] == json(kRecordedLevel);
}

/// The factor that sets the region's kind; null: there is none.
const Factor* kind_factor(const Protocol& protocol) {
  for (const Factor& factor : protocol.design.factors) {
    if (factor.pointer == kRegionKindPointer) {
      return &factor;
    }
  }
  return nullptr;
}

void check_factor(const Protocol& protocol) {
  const Factor* factor = kind_factor(protocol);
  if (factor == nullptr || !has_level(*factor, kRecordedLevel)) {
    refuse(protocol.document, "/gaze/yoked_to",
           "expected a factor over " + std::string(kRegionKindPointer) +
               " with the level \"recorded\", but there is none");
  }
  const bool from_here = protocol.script.gaze->yoked_to->protocol.empty();
  if (from_here && !has_level(*factor, kTrackedLevel)) {
    refuse(protocol.document,
           item("/design/factors", factor_place(protocol.design, factor->name)) + "/levels",
           "expected the level \"tracked\", whose gaze \"recorded\" follows, or another protocol "
           "in /gaze/yoked_to");
  }
  if (from_here && !factor->between) {
    refuse(protocol.document, "/gaze/yoked_to",
           "expected the name of another protocol, run before, or nobody could be the first, since "
           "everybody has recorded regions (\"" +
               factor->name + "\" is no factor between participants)");
  }
}

}  // namespace

std::optional<Condition> followed_condition(const Protocol& protocol, const Condition& condition) {
  const Factor* factor = kind_factor(protocol);
  Condition followed = condition;
  const auto level = std::find_if(followed.begin(), followed.end(), [&](const FactorLevel& one) {
    return factor != nullptr && one.factor == factor->name &&
           one.value == LevelValue(kRecordedLevel);
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
    if (is_recorded(demonstration_scene(protocol, demonstration))) {
      refuse(protocol.document, "/session/demonstrations",
             "expected regions that follow nobody, but " + demonstration.id +
                 " follows a recorded gaze");
    }
  }
  if (protocol.script.gaze && protocol.script.gaze->yoked_to) {
    check_factor(protocol);
    if (find_two_interval(protocol.script) != nullptr) {
      refuse(
          protocol.document, "/two_interval",
          "expected trials of one stimulus where /gaze/yoked_to follows a gaze, got trials of two");
    }
    return;
  }
  const Factor* factor = kind_factor(protocol);
  if (factor != nullptr && has_level(*factor, kRecordedLevel)) {
    refuse(protocol.document, "/gaze",
           "expected the key \"yoked_to\", because regions follow a recorded gaze under \"" +
               factor->name + "\": \"recorded\", but it is missing");
  }
}

}  // namespace impetus::inline protocol
