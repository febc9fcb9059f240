// SPDX-License-Identifier: MIT
#include "experiments/protocol/scene_loading.hpp"

#include "experiments/protocol/validation.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/scenes/scene_meshes.hpp"

namespace impetus {

namespace {

void require_schema(const JsonDocument& scene) {
  if (const auto problem = find_schema_problem(scene_schema(), scene.value)) {
    refuse(scene, problem->pointer, problem->message);
  }
}

}  // namespace

void require_scene(const JsonDocument& scene) {
  require_schema(scene);
  for (const SceneProblem& problem : scene_problems(scene.value)) {
    refuse(scene, problem.pointer, problem.message);
  }
}

JsonDocument read_scene(const std::filesystem::path& path,
                        const std::vector<std::string>& more_files) {
  JsonDocument scene = read_json(path);
  require_schema(scene);
  std::vector<MeshFile> files = mesh_files_of(scene.value);
  for (const std::string& file : more_files) {
    files.push_back({"", file});
  }
  for (const MeshFile& each : files) {
    const std::string problem = hold_mesh(scene.value, each.file, path.parent_path());
    if (!problem.empty()) {
      refuse(scene, each.pointer, problem);
    }
  }
  if (!files.empty()) {
    scene.text = scene.value.dump();
  }
  return scene;
}

JsonDocument load_scene(const std::filesystem::path& path) {
  JsonDocument scene = read_scene(path);
  require_scene(scene);
  return scene;
}

}  // namespace impetus
