// SPDX-License-Identifier: MIT
#include "experiments/files/protocol_files.hpp"

#include <string>
#include <utility>
#include <vector>

#include "experiments/files/scene_files.hpp"
#include "experiments/protocol/checked_scene.hpp"
#include "experiments/protocol/checks/participant_checks.hpp"
#include "experiments/protocol/checks/sense_checks.hpp"
#include "experiments/protocol/protocol_language.hpp"
#include "experiments/protocol/protocol_rows.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/settings/named_file.hpp"

namespace impetus::inline files {
namespace {

/// The mesh, figure and sound files that factors and demonstrations put into the scene.
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
    if (name != nullptr && pointer.ends_with("/sound/file")) {
      files.sounds.push_back(*name);
    }
  };
  std::vector<Condition> beside;  // what is shown besides the design's own levels
  for (const ConditionBeside& each : conditions_beside(protocol.design)) {
    beside.push_back(each.condition);
  }
  if (const TwoIntervalQuestion* question = find_two_interval(protocol.script)) {
    beside.push_back(question->standard_levels());
  }
  for (const Factor& factor : protocol.design.factors) {
    for (const LevelValue& level : factor.levels) {
      add(factor.pointer, level);
    }
    for (const Condition& condition : beside) {
      if (const FactorLevel* level = find_level(condition, factor.name)) {
        add(factor.pointer, level->value);
      }
    }
  }
  for (const Factor& factor : protocol.design.factors) {
    for (const auto& [level, values] : factor.sets) {
      const nlohmann::json set = nlohmann::json::parse(values);
      if (set.contains("/sound/file") && set["/sound/file"].is_string()) {
        files.sounds.push_back(set["/sound/file"].get<std::string>());
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

}  // namespace

Protocol load_protocol(const std::filesystem::path& path) {
  JsonDocument document = read_json(path);
  if (is_scene(document)) {
    throw InputError(document.name +
                     ": expected a protocol, got a scene, which impetus preview shows");
  }
  return protocol_from(std::move(document), path);
}

Protocol protocol_from(JsonDocument document, const std::filesystem::path& path,
                       std::optional<JsonDocument> scene) {
  hold_language(document, path);
  Protocol protocol = read_protocol(std::move(document));
  check_texts(protocol);
  const std::filesystem::path file =
      scene ? path.parent_path() / protocol.document.value["scene"].get<std::string>()
            : named_file(protocol.document, path, "/scene", "a file");
  JsonDocument own = scene ? std::move(*scene) : read_json(file);
  protocol =
      with_scene(std::move(protocol), with_files(std::move(own), file, files_of_design(protocol)));
  check_sense(protocol);
  return protocol;
}

}  // namespace impetus::inline files
