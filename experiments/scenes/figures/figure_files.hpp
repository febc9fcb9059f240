// Figures of a scene from files, held by content.
//
//   "figures": [{"figure": "humanoid.json", ...}]
//        │ read once, when the scene is
//        └─> "figure_files": {"humanoid.json": {"parts": [...], ...}}
//
// The scene that a study records therefore holds all that a replay needs, and a factor may change
// any value of a figure by its JSON Pointer.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace impetus::inline scenes {

/// The figure's JSON Schema (stimuli/figure.schema.json), as built into the program.
const nlohmann::json& figure_schema();

/// A place of the scene that names a figure file.
struct FigureFile {
  std::string pointer;  ///< to "figure"
  std::string file;
};

/// Those that the scene names, in its order. Precondition: valid by the scene's schema.
std::vector<FigureFile> figure_files_of(const nlohmann::json& scene);

/// The figure that the scene holds for a file. Precondition: it holds one.
const nlohmann::json& figure_content(const nlohmann::json& scene, const std::string& file);

/// The JSON Pointer to a figure's content, and to one of its parts.
std::string figure_place(const std::string& file);
std::string part_place(const std::string& file, std::size_t part);

}  // namespace impetus::inline scenes
