// SPDX-License-Identifier: MIT
#include "experiments/protocol/protocol_file.hpp"

#include <utility>

#include <xxhash.h>

#include "experiments/protocol/checks/participant_checks.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/checks/yoke_checks.hpp"
#include "experiments/protocol/design_reading.hpp"
#include "experiments/protocol/embedded_schema.hpp"
#include "experiments/protocol/scene_loading.hpp"
#include "experiments/protocol/script_reading.hpp"
#include "experiments/protocol/solved_values.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "experiments/settings/named_file.hpp"
#include "experiments/settings/schema_check.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

const json& protocol_schema() {
  static const json schema = json::parse(kProtocolSchemaText);
  return schema;
}

/// The mesh and figure files that factors and demonstrations put into the scene.
MoreFiles files_of_design(const json& protocol) {
  MoreFiles files;
  const auto add = [&](const std::string& pointer, const json& value) {
    if (pointer.ends_with("/shape/file") && value.is_string()) {
      files.meshes.push_back(value.get<std::string>());
    }
    if (pointer.ends_with("/figure") && value.is_string()) {
      files.figures.push_back(value.get<std::string>());
    }
  };
  for (const json& factor : protocol["design"]["factors"]) {
    for (const json& level : factor["levels"]) {
      add(factor["pointer"].get<std::string>(), level);
    }
    const auto name = factor["name"].get<std::string>();
    for (const json& kind : protocol["design"].value("catch_trials", json::array())) {
      if (kind["condition"].contains(name)) {
        add(factor["pointer"].get<std::string>(), kind["condition"][name]);
      }
    }
    for (const json& levels : levels_of_questions(protocol)) {
      if (levels.contains(name)) {
        add(factor["pointer"].get<std::string>(), levels[name]);
      }
    }
  }
  const json entries =
      protocol.value("session", json::object()).value("demonstrations", json::array());
  for (const json& entry : entries) {
    for (auto value = entry["set"].begin(); value != entry["set"].end(); ++value) {
      add(value.key(), value.value());
    }
  }
  return files;
}

std::string hash_of(const json& protocol, const json& scene) {
  const std::string canonical = protocol.dump() + "\n" + scene.dump();
  const XXH128_hash_t hash = XXH3_128bits(canonical.data(), canonical.size());
  char text[33];
  std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return text;
}

}  // namespace

json scene_under(const Protocol& protocol, const Condition& condition) {
  json scene = protocol.scene.value;
  for (const FactorLevel& level : condition) {
    scene[json::json_pointer(protocol.pointers.at(level.factor))] = to_json(level.value);
  }
  return scene;
}

json demonstration_scene(const Protocol& protocol, const std::string& id) {
  json scene = protocol.scene.value;
  for (const json& entry : protocol.document.value["session"]["demonstrations"]) {
    if (entry["id"].get<std::string>() == id) {
      const json& values = entry["set"];
      for (auto value = values.begin(); value != values.end(); ++value) {
        scene[json::json_pointer(value.key())] = value.value();
      }
    }
  }
  return scene;
}

Protocol make_protocol(JsonDocument document, JsonDocument scene) {
  require_schema(document, protocol_schema());
  check_participants(document);
  require_scene(scene);
  Protocol protocol;
  protocol.name = document.value["name"].get<std::string>();
  protocol.title = document.value["title"].get<std::string>();
  protocol.hash = hash_of(document.value, scene.value);
  protocol.document = std::move(document);
  protocol.scene = std::move(scene);

  const json& design = protocol.document.value["design"];
  check_design(protocol.document, protocol.scene);
  check_responses(protocol.document);
  protocol.design = design_from(design);
  for (const json& factor : design["factors"]) {
    const auto name = factor["name"].get<std::string>();
    protocol.pointers[name] = factor["pointer"].get<std::string>();
    protocol.labels[name] = factor.value("label", name);
  }
  check_solve(protocol);
  check_levels(protocol);
  check_catch_scenes(protocol);
  check_practice(protocol.document);
  check_practice_rule(protocol.document);
  protocol.script = script_from(protocol.document.value);
  check_training(protocol);
  check_demonstrations(protocol);
  check_gaze(protocol);
  for (const json& condition : design.value("practice", json::array())) {
    protocol.design.practice.push_back(condition_from_json(condition, protocol.design));
  }
  check_standard(protocol);
  check_yoking(protocol);
  return protocol;
}

Protocol load_protocol(const std::filesystem::path& path) {
  JsonDocument document = read_json(path);
  require_schema(document, protocol_schema());
  check_texts(document);
  const std::filesystem::path scene = named_file(document, path, "/scene", "a file");
  const MoreFiles files = files_of_design(document.value);
  return make_protocol(std::move(document), read_scene(scene, files));
}

}  // namespace impetus::inline protocol
