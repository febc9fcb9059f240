// SPDX-License-Identifier: MIT
#include "experiments/scenes/figures/figure_files.hpp"

#include "experiments/scenes/embedded_figure_schema.hpp"

namespace impetus::inline scenes {

using nlohmann::json;

const json& figure_schema() {
  static const json schema = json::parse(kFigureSchemaText);
  return schema;
}

std::vector<FigureFile> figure_files_of(const json& scene) {
  std::vector<FigureFile> files;
  if (scene.contains("figure_crowd")) {
    files.push_back({"/figure_crowd/figure", scene["figure_crowd"]["figure"].get<std::string>()});
  }
  const std::size_t figures = scene.contains("figures") ? scene["figures"].size() : 0;
  for (std::size_t i = 0; i < figures; ++i) {
    files.push_back({"/figures/" + std::to_string(i) + "/figure",
                     scene["figures"][i]["figure"].get<std::string>()});
  }
  return files;
}

const json& figure_content(const json& scene, const std::string& file) {
  return scene.at("figure_files").at(file);
}

std::string figure_place(const std::string& file) {
  return (json::json_pointer("/figure_files") / file).to_string();
}

std::string part_place(const std::string& file, std::size_t part) {
  return figure_place(file) + "/parts/" + std::to_string(part);
}

}  // namespace impetus::inline scenes
