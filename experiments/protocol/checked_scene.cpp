// SPDX-License-Identifier: MIT
#include "experiments/protocol/checked_scene.hpp"

#include "experiments/scenes/scene_checks.hpp"

namespace impetus::inline protocol {

void require_scene_schema(const JsonDocument& scene) {
  if (const auto problem = find_scene_schema_problem(scene.value)) {
    refuse(scene, problem->pointer, problem->message);
  }
}

void require_scene(const JsonDocument& scene, ShapeLibrary& shapes) {
  require_scene_schema(scene);
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

}  // namespace impetus::inline protocol
