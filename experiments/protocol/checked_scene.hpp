// A scene that was read, held against its schema and its rules, for whoever stages it.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "experiments/scenes/scene_file.hpp"
#include "experiments/settings/json_document.hpp"
#include "experiments/settings/schema_sentences.hpp"

namespace impetus::inline protocol {

/// Whether a file is a protocol, by its design, or a scene, by its engine, where the other may be
/// meant.
inline bool is_protocol(const JsonDocument& document) {
  return document.value.is_object() && document.value.contains("design");
}

inline bool is_scene(const JsonDocument& document) {
  return document.value.is_object() && document.value.contains("engine") && !is_protocol(document);
}

/// The first place at which a scene breaks its schema, or a figure that it holds breaks its own.
std::optional<SchemaProblem> find_scene_schema_problem(const nlohmann::json& scene);

/// Throws InputError unless the scene, and each figure that it holds, is valid by its schema.
void require_scene_schema(const JsonDocument& scene);

/// Throws InputError unless the scene is valid by its schema and its own rules.
/// `shapes` builds what it is made of.
void require_scene(const JsonDocument& scene, ShapeLibrary& shapes);
void require_scene(const JsonDocument& scene);

/// What `build` returns, which stages the scene; that it has no room is refused with the name of
/// its file.
template <typename Build>
auto staged_from(const JsonDocument& scene, const Build& build) {
  try {
    return build();
  } catch (const NoRoom& none) {
    refuse(scene, none.pointer(), none.what());
  }
}

}  // namespace impetus::inline protocol
