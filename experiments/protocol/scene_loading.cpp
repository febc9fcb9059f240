// SPDX-License-Identifier: MIT
#include "experiments/protocol/scene_loading.hpp"

#include "experiments/protocol/validation.hpp"
#include "experiments/scenes/scene_file.hpp"

namespace impetus {

void require_scene(const JsonDocument& scene) {
  if (const auto problem = find_schema_problem(scene_schema(), scene.value)) {
    refuse(scene, problem->pointer, problem->message);
  }
  for (const SceneProblem& problem : scene_problems(scene.value)) {
    refuse(scene, problem.pointer, problem.message);
  }
}

JsonDocument load_scene(const std::filesystem::path& path) {
  JsonDocument scene = read_json(path);
  require_scene(scene);
  return scene;
}

}  // namespace impetus
