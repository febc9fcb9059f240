// SPDX-License-Identifier: MIT
#include "experiments/protocol/protocol_file.hpp"

#include <utility>

#include <xxhash.h>

#include "experiments/protocol/checked_scene.hpp"
#include "experiments/protocol/checks/participant_checks.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/checks/yoke_checks.hpp"
#include "experiments/protocol/factor_values.hpp"
#include "experiments/protocol/protocol_language.hpp"
#include "experiments/protocol/protocol_rows.hpp"
#include "experiments/protocol/scene_levels.hpp"
#include "experiments/protocol/solved_values.hpp"
#include "experiments/questions/level_value.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

std::string hash_of(const json& protocol, const json& scene) {
  const std::string canonical = protocol.dump() + "\n" + scene.dump();
  const XXH128_hash_t hash = XXH3_128bits(canonical.data(), canonical.size());
  char text[33];
  std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return text;
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
