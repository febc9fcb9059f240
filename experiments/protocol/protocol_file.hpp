// A protocol file and the scene it names, validated, as the structs a session runs on.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "experiments/design/design.hpp"
#include "experiments/protocol/design_reading.hpp"
#include "experiments/questions/script.hpp"
#include "experiments/settings/json_document.hpp"

namespace impetus::inline protocol {

/// A protocol, read and checked: its design, its script, and the scene of its trials.
struct Protocol {
  std::string name;
  std::string title;
  Design design;
  Script script;
  std::map<std::string, std::string> pointers;  ///< factor -> JSON Pointer into the scene
  std::map<std::string, std::string> labels;    ///< factor -> words
  JsonDocument document;
  JsonDocument scene;
  std::string hash;  ///< of both values; white space does not count
};

/// Reads the protocol and the scene beside it. Throws InputError naming file, place, what was
/// expected and what was there.
Protocol load_protocol(const std::filesystem::path& path);

/// The same from texts, as a study file keeps them.
Protocol make_protocol(JsonDocument document, JsonDocument scene);

/// The scene with the levels of `condition` put in. `condition` names factors of the protocol.
nlohmann::json scene_under(const Protocol& protocol, const Condition& condition);

/// The scene with the values that the demonstration sets. `id` is one of the protocol's.
nlohmann::json demonstration_scene(const Protocol& protocol, const std::string& id);

}  // namespace impetus::inline protocol
