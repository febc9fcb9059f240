// A protocol file and the scene it names, validated, as the structs a session runs on.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "experiments/design/design.hpp"
#include "experiments/protocol/exclusion_rules.hpp"
#include "experiments/questions/level_value.hpp"
#include "experiments/questions/script.hpp"
#include "experiments/scenes/shape_library.hpp"
#include "experiments/settings/json_document.hpp"

namespace impetus::inline protocol {

/// Values of the scene that are solved before the plan is stored; which members say how depends on
/// the kind.
struct SolveEntry {
  std::string kind;
  std::string pointer;                ///< JSON Pointer into the scene
  std::vector<std::string> for_each;  ///< factors
  // Of random-spin-limits:
  int accurate_level{0};
  std::size_t runs{0};
  double turn_deg{0.0};
  double size_share{0.0};
  std::array<double, 2> percentiles{};
  // Of equal-lists:
  double share{0.0};
  double within{0.0};
  double pilot_s{0.0};
};

/// A protocol, read and checked: its design, its script, and the scene of its trials.
struct Protocol {
  std::string name;
  std::string title;
  std::string scene_file;
  bool has_participants{true};  ///< people or simulated ones; else nobody, and no script
  Design design;
  Script script;
  std::vector<SolveEntry> solve;
  ExclusionRules exclude_when;
  JsonDocument document;
  JsonDocument scene;
  std::string hash;  ///< of both values; white space does not count

  /// What checks build, trials stage: each shape is built once.
  std::shared_ptr<ShapeLibrary> shapes{std::make_shared<ShapeLibrary>()};
};

/// What was read becomes a protocol of this scene, checked. Throws InputError.
Protocol with_scene(Protocol protocol, JsonDocument scene);

/// A protocol from texts, as a study file keeps them, checked; `shapes` may be shared with other
/// protocols. Throws InputError naming document, place, what was expected and what was there.
Protocol make_protocol(JsonDocument document, JsonDocument scene,
                       std::shared_ptr<ShapeLibrary> shapes = std::make_shared<ShapeLibrary>());

/// The same without a check, of texts that were checked when they were published.
Protocol trusted_protocol(JsonDocument document, JsonDocument scene);

/// The scene with the levels of `condition` put in. `condition` names factors of the protocol.
nlohmann::json scene_under(const Protocol& protocol, const Condition& condition);

/// The scene with the values that the demonstration sets.
nlohmann::json demonstration_scene(const Protocol& protocol, const Demonstration& demonstration);

}  // namespace impetus::inline protocol
