// SPDX-License-Identifier: MIT
#include "experiments/protocol/scene_loading.hpp"

#include "experiments/models/readable_file.hpp"
#include "experiments/scenes/scene_checks.hpp"
#include "experiments/scenes/scene_meshes.hpp"

namespace impetus::inline protocol {

namespace {

void require_schema(const JsonDocument& scene) {
  if (const auto problem = find_scene_schema_problem(scene.value)) {
    refuse(scene, problem->pointer, problem->message);
  }
}

/// Puts the content of `file` into the scene, unless it is there; `pointer` is where it is named.
void hold_figure(JsonDocument& scene, const FigureFile& named,
                 const std::filesystem::path& folder) {
  if (scene.value.contains("figure_files") && scene.value["figure_files"].contains(named.file)) {
    return;
  }
  std::string problem = problem_of_place(named.file, folder);
  const std::filesystem::path path = folder / named.file;
  if (!problem.empty()) {
    refuse(scene, named.pointer, problem);
  }
  if (problem = reading_problem(path); !problem.empty()) {
    refuse(scene, named.pointer, "expected a figure file, but " + path.string() + ": " + problem);
  }
  const JsonDocument figure = read_json(path);
  if (const auto broken = find_schema_problem(figure_schema(), figure.value)) {
    refuse(figure, broken->pointer, broken->message);
  }
  scene.value["figure_files"][named.file] = figure.value;
}

/// Figures first: their parts may be meshes.
void hold_files(JsonDocument& scene, const MoreFiles& more, const std::filesystem::path& folder) {
  std::vector<FigureFile> figures = named_figure_files(scene.value);
  for (const std::string& file : more.figures) {
    figures.push_back({"", file});
  }
  for (const FigureFile& each : figures) {
    hold_figure(scene, each, folder);
  }
  std::vector<MeshFile> meshes = named_mesh_files(scene.value);
  for (const std::string& file : more.meshes) {
    meshes.push_back({"", file});
  }
  for (const MeshFile& each : meshes) {
    const std::string problem = hold_mesh(scene.value, each.file, folder);
    if (!problem.empty()) {
      refuse(scene, each.pointer, problem);
    }
  }
  if (!figures.empty() || !meshes.empty()) {
    scene.text = scene.value.dump();
  }
}

}  // namespace

void require_scene(const JsonDocument& scene, ShapeLibrary& shapes) {
  require_schema(scene);
  for (const SceneProblem& problem : scene_problems(scene.value, shapes)) {
    refuse(scene, problem.pointer, problem.message);
  }
}

void require_scene(const JsonDocument& scene) {
  ShapeLibrary shapes;
  require_scene(scene, shapes);
}

std::optional<SchemaProblem> find_scene_schema_problem(const nlohmann::json& scene) {
  if (auto problem = find_schema_problem(scene_schema(), scene)) {
    return problem;
  }
  const nlohmann::json figures = scene.value("figure_files", nlohmann::json::object());
  for (auto figure = figures.begin(); figure != figures.end(); ++figure) {
    if (auto problem = find_schema_problem(figure_schema(), figure.value())) {
      problem->pointer = figure_place(figure.key()) + problem->pointer;
      return problem;
    }
  }
  return std::nullopt;
}

JsonDocument read_scene(const std::filesystem::path& path, const MoreFiles& more) {
  JsonDocument scene = read_json(path);
  require_schema(scene);
  hold_files(scene, more, path.parent_path());
  return scene;
}

JsonDocument load_scene(const std::filesystem::path& path) {
  JsonDocument scene = read_scene(path);
  require_scene(scene);
  return scene;
}

}  // namespace impetus::inline protocol
