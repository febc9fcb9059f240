// A scene file as read and checked, for whoever stages it: a protocol, or a scene by itself.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/scenes/scene_file.hpp"
#include "experiments/settings/json_document.hpp"
#include "experiments/settings/schema_sentences.hpp"

namespace impetus::inline protocol {

/// The scene in the file, valid by its schema and its own rules. Throws InputError with one
/// sentence, "file:/pointer: expected ..., got ...".
JsonDocument load_scene(const std::filesystem::path& path);

/// Whether a file is a protocol, by its design, where a scene may be meant.
inline bool is_protocol(const JsonDocument& document) {
  return document.value.is_object() && document.value.contains("design");
}

/// Files that something beside a scene puts into it: a protocol's factors and demonstrations.
struct MoreFiles {
  std::vector<std::string> meshes;
  std::vector<std::string> figures;
};

/// The scene in the file, valid by its schema alone, holding its meshes and figures and those that
/// `more` names: what load_scene() goes on to check. Throws InputError.
JsonDocument read_scene(const std::filesystem::path& path, const MoreFiles& more = {});

/// The first place at which a scene breaks its schema, or a figure that it holds breaks its own.
std::optional<SchemaProblem> find_scene_schema_problem(const nlohmann::json& scene);

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
