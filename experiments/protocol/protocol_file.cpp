// SPDX-License-Identifier: MIT
#include "experiments/protocol/protocol_file.hpp"

#include <map>
#include <string>
#include <utility>

#include "experiments/models/mesh_bytes.hpp"
#include "experiments/protocol/checked_scene.hpp"
#include "experiments/protocol/checks/participant_checks.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/checks/yoke_checks.hpp"
#include "experiments/protocol/factor_values.hpp"
#include "experiments/protocol/protocol_language.hpp"
#include "experiments/protocol/protocol_rows.hpp"
#include "experiments/protocol/solved_values.hpp"
#include "experiments/questions/level_value.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

std::string hash_of(const json& protocol, const json& scene) {
  return content_hash(protocol.dump() + "\n" + scene.dump());
}

/// What the scene says in place of null, by factor.
using OwnLevels = std::map<std::string, json>;

OwnLevels own_levels(const Design& design, const json& scene) {
  OwnLevels levels;
  for (const Factor& factor : design.factors) {
    if (names_single_value(scene, factor.pointer)) {
      levels[factor.name] = scene[json::json_pointer(factor.pointer)];
    }
  }
  return levels;
}

void put_own(const OwnLevels& own, const std::string& factor, json& level) {
  const auto found = own.find(factor);
  if (level.is_null() && found != own.end()) {
    level = found->second;
  }
}

void put_own(const OwnLevels& own, json& condition) {
  for (auto level = condition.begin(); level != condition.end(); ++level) {
    put_own(own, level.key(), level.value());
  }
}

/// The document with levels in place of null, wherever it may have it.
json with_own_levels(json document, const OwnLevels& own) {
  json& design = document["design"];
  for (json& factor : design["factors"]) {
    for (json& level : factor["levels"]) {
      put_own(own, factor["name"], level);
    }
  }
  if (design.contains("practice")) {
    for (json& condition : design["practice"]) {
      put_own(own, condition);
    }
  }
  if (design.contains("catch_trials")) {
    for (json& kind : design["catch_trials"]) {
      put_own(own, kind["condition"]);
    }
  }
  if (design.contains("adaptation")) {
    for (json& stream : design["adaptation"]) {
      put_own(own, stream["when"]);
      for (json& condition : stream["conditions"]) {
        put_own(own, condition);
      }
    }
  }
  if (design.contains("practice_until")) {
    json& rule = design["practice_until"];
    put_own(own, rule["factor"], rule["best"]);
    put_own(own, rule["factor"], rule["worst"]);
  }
  if (document.contains("two_interval")) {
    put_own(own, document["two_interval"]["standard"]);
  }
  if (document.contains("slider")) {
    for (json& scale : document["slider"]["scales"]) {
      if (scale.contains("when")) {
        put_own(own, scale["when"]);
      }
    }
  }
  return document;
}

/// Puts what the scene says in place of levels that are null: design and script are read anew.
/// Pointers that the scene lacks are left to the checks of the design.
void take_levels_of_scene(Protocol& protocol, const json& scene) {
  const json document =
      with_own_levels(protocol.document.value, own_levels(protocol.design, scene));
  if (document == protocol.document.value) {
    return;
  }
  Protocol anew = protocol_of(document);
  protocol.design = std::move(anew.design);
  protocol.script.asked = std::move(anew.script.asked);
  protocol.script.practice_rule = std::move(anew.script.practice_rule);
}

void put_scene(JsonDocument scene, Protocol& protocol) {
  take_levels_of_scene(protocol, scene.value);
  protocol.hash = hash_of(protocol.document.value, scene.value);
  protocol.scene = std::move(scene);
}

}  // namespace

Protocol with_scene(Protocol protocol, JsonDocument scene) {
  check_participants(protocol);
  require_scene(scene, *protocol.shapes);
  put_scene(std::move(scene), protocol);
  check_design(protocol);
  check_responses(protocol);
  check_solve(protocol);
  check_levels(protocol);
  check_scenes_beside(protocol);
  check_named_bodies(protocol);
  check_practice(protocol);
  check_practice_rule(protocol);
  check_training(protocol);
  check_exclusion_rules(protocol.document, protocol.exclude_when, protocol.script, protocol.design);
  check_demonstrations(protocol);
  check_gaze(protocol);
  check_standard(protocol);
  check_yoking(protocol);
  return protocol;
}

Protocol trusted_protocol(JsonDocument document, JsonDocument scene) {
  Protocol protocol = protocol_of(document.value);
  protocol.script.language = language_of(document);
  protocol.document = std::move(document);
  put_scene(std::move(scene), protocol);
  return protocol;
}

json scene_under(const Protocol& protocol, const Condition& condition) {
  json scene = protocol.scene.value;
  for (const FactorLevel& level : condition) {
    const Factor& factor = protocol.design.factors.at(factor_place(protocol.design, level.factor));
    const json values = values_of(factor, level.value);
    for (auto value = values.begin(); value != values.end(); ++value) {
      scene[json::json_pointer(value.key())] = value.value();
    }
  }
  return scene;
}

json demonstration_scene(const Protocol& protocol, const Demonstration& demonstration) {
  json scene = protocol.scene.value;
  for (const auto& [pointer, value] : demonstration.set) {
    scene[json::json_pointer(pointer)] = to_json(value);
  }
  return scene;
}

Protocol make_protocol(JsonDocument document, JsonDocument scene,
                       std::shared_ptr<ShapeLibrary> shapes) {
  Protocol protocol = read_protocol(std::move(document));
  protocol.shapes = std::move(shapes);
  return with_scene(std::move(protocol), std::move(scene));
}

}  // namespace impetus::inline protocol
