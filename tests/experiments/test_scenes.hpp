// Scenes to change single values of, what they become, and the sentence with which one is refused.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/files/scene_files.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus {

inline constexpr const char* kCrowdScene = "stimuli/l-blocks-in-a-cube.json";

inline json crowd_scene() { return json::parse(shipped(kCrowdScene)); }

/// Two balls, a box and an L-block with places of their own in a cube of 20°.
inline json free_scene() {
  return json::parse(R"({
    "schema_version": 1, "title": "free",
    "engine": {"step_hz": 240, "restitution": 1, "tree_depth": 2},
    "viewer": {"azimuth_deg": 0},
    "enclosure": {"edge_deg": 20},
    "duration_s": 2,
    "bodies": [
      {"name": "ball", "shape": {"kind": "sphere", "radius_deg": 1}, "density_kg_m3": 1000,
       "colour": "#ffffff", "position_deg": [-5, 0, 0], "velocity_deg_s": [10, 0, 0]},
      {"name": "box", "shape": {"kind": "box", "width_deg": 2, "height_deg": 1, "depth_deg": 3},
       "density_kg_m3": 1000, "colour": "#ffffff", "position_deg": [5, 0, 0],
       "spin_deg_s": [0, 90, 0]},
      {"name": "block", "shape": {"kind": "l-block", "arm_deg": 2, "thickness_deg": 0.7},
       "density_kg_m3": 1000, "colour": "#ffffff", "position_deg": [0, 5, 0]}]})");
}

inline StagedScene built(const json& scene, const std::string& start = "main/1") {
  ShapeLibrary library;
  return build_scene(scene, assumed_screen(), 0.0, library, start);
}

/// The sentence with which a scene file is refused, without the file's name; "accepted" when not.
inline std::string scene_refusal(const json& scene) {
  const TemporaryFolder folder;
  const std::string path = folder.write("scene.json", scene.dump()).string();
  const std::string sentence = refusal([&] { load_scene(path); });
  return sentence.starts_with(path) ? sentence.substr(path.size() + 1) : sentence;
}

inline json changed(json scene, const std::string& pointer, json value) {
  scene[json::json_pointer(pointer)] = std::move(value);
  return scene;
}

inline double metres_of(double degrees) {
  return degrees * metres_per_degree(assumed_screen().viewing_distance_m);
}

}  // namespace impetus
