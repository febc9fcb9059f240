// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_tree.hpp"

#include <string>

namespace impetus::inline scenes {

using nlohmann::json;

TreeSettings tree_settings_of(const json& engine, int deepest_level) {
  TreeSettings settings;
  settings.depth = engine.value("tree_depth", 0);
  if (engine.contains("tree")) {
    settings.kind = tree_kind(engine["tree"]["kind"].get<std::string>());
    settings.branching = engine["tree"].value("branching", settings.branching);
  }
  if (deepest_level < settings.depth) {
    settings.built_depth = deepest_level;
  }
  return settings;
}

void add_tree_problems(const json& engine, std::vector<SceneProblem>& problems) {
  if (!engine.contains("tree")) {
    return;
  }
  if (!engine.contains("tree_depth")) {
    problems.push_back(
        {"/engine", "expected the key \"tree_depth\" beside \"tree\", which is missing"});
  }
  const std::string problem = problem_of(tree_settings_of(engine));
  if (!problem.empty()) {
    const std::string prefix = "tree: ";
    problems.push_back(
        {"/engine/tree", problem.starts_with(prefix) ? problem.substr(prefix.size()) : problem});
  }
}

}  // namespace impetus::inline scenes
