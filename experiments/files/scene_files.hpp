// Scene files, with the meshes, figures and sounds that they name read and held in them.
//
//   scene.json ──names──> meshes, figures, sounds ──read once──> one document, checked, that needs
//   no file
//
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/settings/json_document.hpp"

namespace impetus::inline files {

/// The scene in the file, valid by its schema and its own rules. Throws InputError with one
/// sentence, "file:/pointer: expected ..., got ...".
JsonDocument load_scene(const std::filesystem::path& path);

/// The scene in the file, valid by its schema alone, holding its meshes, figures and sounds: what
/// load_scene() goes on to check. Throws InputError.
JsonDocument read_scene(const std::filesystem::path& path);

/// Files that something beside a scene puts into it: a protocol's factors and demonstrations.
struct MoreFiles {
  std::vector<std::string> meshes;
  std::vector<std::string> figures;
  std::vector<std::string> sounds;
};

/// The same of a scene that was read already, or written by a program, as if it lay at `path`, and
/// holding what `more` names, too.
JsonDocument with_files(JsonDocument scene, const std::filesystem::path& path,
                        const MoreFiles& more = {});

/// Puts the content of `file` into the scene's "meshes", unless it is there; `folder` is the
/// scene's. Returns what is wrong in words, "" when nothing is: the path leaves the folder, the
/// file cannot be read, or the mesh cannot be simulated.
std::string hold_mesh(nlohmann::json& scene, const std::string& file,
                      const std::filesystem::path& folder);

}  // namespace impetus::inline files
