// SPDX-License-Identifier: MIT
#include "experiments/protocol/scene_levels.hpp"

#include <map>
#include <string>
#include <utility>

#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/protocol_rows.hpp"

namespace impetus::inline protocol {
namespace {

/// What the scene says in place of null, by factor.
using OwnLevels = std::map<std::string, nlohmann::json>;

OwnLevels own_levels(const Design& design, const nlohmann::json& scene) {
  OwnLevels levels;
  for (const Factor& factor : design.factors) {
    if (names_single_value(scene, factor.pointer)) {
      levels[factor.name] = scene[nlohmann::json::json_pointer(factor.pointer)];
    }
  }
  return levels;
}

void put_own(const OwnLevels& own, const std::string& factor, nlohmann::json& level) {
  const auto found = own.find(factor);
  if (level.is_null() && found != own.end()) {
    level = found->second;
  }
}

void put_own(const OwnLevels& own, nlohmann::json& condition) {
  for (auto level = condition.begin(); level != condition.end(); ++level) {
    put_own(own, level.key(), level.value());
  }
}

/// The document with levels in place of null, wherever it may have it.
nlohmann::json with_own_levels(nlohmann::json document, const OwnLevels& own) {
  nlohmann::json& design = document["design"];
  for (nlohmann::json& factor : design["factors"]) {
    for (nlohmann::json& level : factor["levels"]) {
      put_own(own, factor["name"], level);
    }
  }
  if (design.contains("practice")) {
    for (nlohmann::json& condition : design["practice"]) {
      put_own(own, condition);
    }
  }
  if (design.contains("catch_trials")) {
    for (nlohmann::json& kind : design["catch_trials"]) {
      put_own(own, kind["condition"]);
    }
  }
  if (design.contains("adaptation")) {
    for (nlohmann::json& stream : design["adaptation"]) {
      put_own(own, stream["when"]);
      for (nlohmann::json& condition : stream["conditions"]) {
        put_own(own, condition);
      }
    }
  }
  if (design.contains("practice_until")) {
    nlohmann::json& rule = design["practice_until"];
    put_own(own, rule["factor"], rule["best"]);
    put_own(own, rule["factor"], rule["worst"]);
  }
  if (document.contains("two_interval")) {
    put_own(own, document["two_interval"]["standard"]);
  }
  return document;
}

}  // namespace

void take_levels_of_scene(Protocol& protocol, const nlohmann::json& scene) {
  const nlohmann::json document =
      with_own_levels(protocol.document.value, own_levels(protocol.design, scene));
  if (document == protocol.document.value) {
    return;
  }
  Protocol anew = protocol_of(document);
  protocol.design = std::move(anew.design);
  protocol.script.asked = std::move(anew.script.asked);
  protocol.script.practice_rule = std::move(anew.script.practice_rule);
}

}  // namespace impetus::inline protocol
