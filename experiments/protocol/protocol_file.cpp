// SPDX-License-Identifier: MIT
#include "experiments/protocol/protocol_file.hpp"

#include <utility>

#include <xxhash.h>

#include "experiments/protocol/checks/participant_checks.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/checks/yoke_checks.hpp"
#include "experiments/protocol/protocol_language.hpp"
#include "experiments/protocol/protocol_rows.hpp"
#include "experiments/protocol/scene_levels.hpp"
#include "experiments/protocol/scene_loading.hpp"
#include "experiments/protocol/solved_values.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/settings/named_file.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

/// The mesh and figure files that factors and demonstrations put into the scene.
MoreFiles files_of_design(const Protocol& protocol) {
  MoreFiles files;
  const auto add = [&](const std::string& pointer, const LevelValue& value) {
    const auto* name = std::get_if<std::string>(&value);
    if (name != nullptr && pointer.ends_with("/shape/file")) {
      files.meshes.push_back(*name);
    }
    if (name != nullptr && pointer.ends_with("/figure")) {
      files.figures.push_back(*name);
    }
  };
  std::vector<Condition> beside;  // what is shown besides the design's own levels
  for (const CatchTrials& kind : protocol.design.catch_trials) {
    beside.push_back(kind.condition);
  }
  if (const TwoIntervalQuestion* question = find_two_interval(protocol.script)) {
    beside.push_back(question->standard_levels());
  }
  for (const Factor& factor : protocol.design.factors) {
    for (const LevelValue& level : factor.levels) {
      add(factor.pointer, level);
    }
    for (const Condition& condition : beside) {
      for (const FactorLevel& level : condition) {
        if (level.factor == factor.name) {
          add(factor.pointer, level.value);
        }
      }
    }
  }
  for (const Demonstration& demonstration : protocol.script.demonstrations) {
    for (const auto& [pointer, value] : demonstration.set) {
      add(pointer, value);
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

/// What was read becomes a protocol of this scene, checked.
Protocol with_scene(Protocol protocol, JsonDocument scene) {
  check_participants(protocol);
  require_scene(scene, *protocol.shapes);
  take_levels_of_scene(protocol, scene.value);
  protocol.hash = hash_of(protocol.document.value, scene.value);
  protocol.scene = std::move(scene);
  check_design(protocol);
  check_responses(protocol);
  check_solve(protocol);
  check_levels(protocol);
  check_catch_scenes(protocol);
  check_practice(protocol);
  check_practice_rule(protocol);
  check_training(protocol);
  check_demonstrations(protocol);
  check_gaze(protocol);
  check_standard(protocol);
  check_yoking(protocol);
  return protocol;
}

}  // namespace

json scene_under(const Protocol& protocol, const Condition& condition) {
  json scene = protocol.scene.value;
  for (const FactorLevel& level : condition) {
    const Factor& factor = protocol.design.factors.at(factor_place(protocol.design, level.factor));
    if (!factor.pointer.empty()) {
      scene[json::json_pointer(factor.pointer)] = to_json(level.value);
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

Protocol load_protocol(const std::filesystem::path& path) {
  JsonDocument document = read_json(path);
  hold_language(document, path);
  Protocol protocol = read_protocol(std::move(document));
  check_texts(protocol);
  const std::filesystem::path file = named_file(protocol.document, path, "/scene", "a file");
  JsonDocument scene = read_scene(file, files_of_design(protocol));
  return with_scene(std::move(protocol), std::move(scene));
}

}  // namespace impetus::inline protocol
