// Figures in scenes to change single values of: a doll of three parts, and the shipped humanoid.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/files/scene_files.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus {

/// A trunk, an arm that hangs from its side and a forearm that hangs from that; of height 1 share.
inline json doll() {
  return json::parse(R"({
    "schema_version": 1, "title": "a doll",
    "parts": [
      {"name": "trunk", "colour": 1,
       "shape": {"kind": "rectangle-swept", "width_share": 0.2, "height_share": 0.4,
                 "radius_share": 0.1}},
      {"name": "arm", "shape": {"kind": "line-swept", "length_share": 0.2, "radius_share": 0.05},
       "hinge": {"name": "shoulder", "parent": "trunk", "on_parent": [0.3, 0.2, 0],
                 "on_part": [0, 0.1, 0], "axis": [0, 0, 2], "rest_deg": 30, "least_deg": -10,
                 "most_deg": 170, "fold_deg": 40, "core_of_parent": [0, -1, 0]}},
      {"name": "forearm", "shape": {"kind": "sphere", "radius_share": 0.05},
       "hinge": {"name": "elbow", "parent": "arm", "on_parent": [0, -0.1, 0],
                 "on_part": [0, 0.06, 0], "axis": [1, 0, 0]}}],
    "motions": {
      "flap": {"period_s": 2, "bob_share": [0, 0.1, 0], "root_spin_deg_s": [0, 90, 0],
               "waves": {"shoulder": {"middle_deg": 60, "amplitude_deg": 20, "phase": 0.25,
                                      "cycles": 3}}},
      "recorded": {"repeats": true, "keys": [
        {"time_s": 0, "angles_deg": {"shoulder": 10}},
        {"time_s": 1, "angles_deg": {"shoulder": 50, "elbow": 20}},
        {"time_s": 2, "angles_deg": {"shoulder": 10}}]}}})");
}

/// "anna", a doll 10° high at the centre of nothing, with the doll's file held by content.
inline json doll_scene() {
  json scene = json::parse(R"({
    "schema_version": 1, "title": "a doll",
    "engine": {"step_hz": 240, "restitution": 1, "tree_depth": 2},
    "viewer": {"azimuth_deg": 0},
    "duration_s": 2,
    "figures": [
      {"name": "anna", "figure": "doll.json", "height_deg": 10, "density_kg_m3": 1000,
       "colours": ["#ff0000", "#0000ff"], "position_deg": [1, 2, 3]}]})");
  scene["figure_files"]["doll.json"] = doll();
  return scene;
}

inline constexpr const char* kDollPlace = "/figure_files/doll.json";

/// A scene of the shipped humanoid, standing.
inline json humanoid_scene() {
  json scene = doll_scene();
  scene["figures"][0]["figure"] = "humanoid.json";
  scene["figure_files"] = {{"humanoid.json", json::parse(shipped("stimuli/humanoid.json"))}};
  EXPECT_EQ(hold_mesh(scene, "head.obj", std::filesystem::path(source_folder()) / "stimuli"), "");
  return scene;
}

/// Humanoids at random places in a cube.
inline json humanoid_crowd(int count, double edge_deg) {
  json scene = humanoid_scene();
  scene.erase("figures");
  scene["enclosure"] = {{"edge_deg", edge_deg}};
  scene["figure_crowd"] = {
      {"figure", "humanoid.json"}, {"count", count},   {"height_deg", 5}, {"density_kg_m3", 1000},
      {"colours", {"#ff0000"}},    {"speed_deg_s", 5}, {"spin_deg_s", 60}};
  return scene;
}

}  // namespace impetus
