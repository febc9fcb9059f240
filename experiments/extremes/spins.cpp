// Spins to ten thousand radians per second: 42 radians in a step of 1/240 s.
// SPDX-License-Identifier: MIT
#include "experiments/extremes/building_blocks.hpp"
#include "experiments/extremes/extreme_cases.hpp"

namespace impetus::inline extremes {
namespace {

/// A block that turns about nearly its middle axis, as unsteady as it gets.
ExtremeScene spinning(double spin_rad_s, Rotation rotation, double step_s, std::int64_t steps) {
  ExtremeScene scene;
  scene.name = short_number(spin_rad_s) + " rad/s, " +
               (rotation == Rotation::kMidpoint ? "midpoint" : "energy kept");
  scene.bodies = {block({0.2, 0.4, 0.6})};
  scene.bodies[0].start.spin_rad_s = spin_rad_s * Vector3(0.01, 1.0, 0.01);
  scene.settings.rotation = rotation;
  scene.step_s = step_s;
  scene.steps = steps;
  return scene;
}

std::vector<ExtremeScene> all_spins(Length length, Rotation rotation) {
  std::vector<ExtremeScene> scenes;
  for (const double spin_rad_s : {1e-3, 1.0, 1e1, 1e2, 1e3, 1e4}) {
    scenes.push_back(
        spinning(spin_rad_s, rotation, 1.0 / 240.0, length == Length::kQuick ? 2'000 : 20'000));
  }
  return scenes;
}

/// A spinning block that a ball flies into.
std::vector<ExtremeScene> hits(Length /*length*/) {
  std::vector<ExtremeScene> scenes;
  for (const double spin_rad_s : {1.0, 1e2, 1e4}) {
    for (const TreeKind kind : all_tree_kinds()) {
      ExtremeScene scene = spinning(spin_rad_s, Rotation::kEnergyKept, 1.0 / 240.0, 480);
      scene.name += ", " + name_of(kind);
      scene.bodies[0].tree = kind;
      scene.bodies.push_back(ball(0.1, {-1.0, 0.05, 0.1}, {1.0, 0.0, 0.0}));
      scenes.push_back(scene);
    }
  }
  return scenes;
}

}  // namespace

std::vector<ExtremeCase> spin_cases() {
  const std::string family = "spins";
  return {
      {family,
       "spins-midpoint",
       {{"A block tumbling at 1e-3 to 1e4 rad/s keeps its energy at all times within a share of",
         1e-3, "", energy_swing},
        {"and the length of one of its orientation but for", 1e-15, "", unit_length_lost}},
       [](Length length) { return all_spins(length, Rotation::kMidpoint); }},
      {family,
       "spins-energy-kept",
       {{"By the rule that keeps energy, within a share of", 1e-11, "", energy_swing},
        {"and the length of one of its orientation but for", 1e-15, "", unit_length_lost}},
       [](Length length) { return all_spins(length, Rotation::kEnergyKept); }},
      {family,
       "spins-hit",
       {{"A ball flies into one, in trees of every kind: energy gained at most", 1e-9, "",
         energy_gain_by_touching}},
       hits},
  };
}

}  // namespace impetus::inline extremes
