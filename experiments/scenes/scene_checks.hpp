// What a scene must fulfil beyond its schema; each refusal is one sentence.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace impetus::inline scenes {

/// A broken rule with its JSON Pointer.
struct SceneProblem {
  std::string pointer;
  std::string message;  ///< "expected ..., got ..."
};

/// Precondition: `scene` is valid by scene_schema().
std::vector<SceneProblem> scene_problems(const nlohmann::json& scene);

}  // namespace impetus::inline scenes
