// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_timing.hpp"

namespace impetus::inline scenes {

using nlohmann::json;

double intended_hold_s(const json& scene) {
  return scene.value("imposed", json::object()).value("contact_hold_ms", 0.0) / 1e3;
}

double scene_duration_s(const json& scene, double hold_s) {
  if (!scene.contains("meeting")) {
    return scene["duration_s"].get<double>();
  }
  const json& meeting = scene["meeting"];
  return meeting["lead_s"].get<double>() + hold_s + meeting["follow_s"].get<double>();
}

}  // namespace impetus::inline scenes
