// Speeds from rest to a thousand kilometres per second.
// SPDX-License-Identifier: MIT
#include "experiments/extremes/building_blocks.hpp"
#include "experiments/extremes/extreme_cases.hpp"

#include <algorithm>

namespace impetus::inline extremes {
namespace {

constexpr double kBallRadius_m = 0.1;

std::vector<ExtremeScene> all_speeds(Length /*length*/) {
  std::vector<ExtremeScene> scenes;
  for (const double restitution : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    for (const double speed_m_s : {1e-6, 1e-3, 1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6}) {
      scenes.push_back(head_on(kBallRadius_m, speed_m_s, kStep_s));
      scenes.back().settings.restitution = restitution;
      scenes.back().name =
          short_number(speed_m_s) + " m/s, restitution " + short_number(restitution);
    }
  }
  return scenes;
}

/// A ball, and a block of every kind of tree, that nothing happens to.
std::vector<ExtremeScene> at_rest(Length /*length*/) {
  ExtremeScene scene;
  scene.name = "0 m/s";
  scene.bodies = {ball(kBallRadius_m, {0.3, 0.1, -0.7})};
  for (const TreeKind kind : all_tree_kinds()) {
    const auto place = static_cast<double>(scene.bodies.size());
    scene.bodies.push_back(block({0.3, 0.2, 0.1}, {place, 0.1, 0.0}));
    scene.bodies.back().tree = kind;
    scene.bodies.back().start.pose.orientation = Quaternion(1.0, 0.3, place, 0.1).normalized();
  }
  scene.steps = 1000;
  return {scene};
}

}  // namespace

std::vector<ExtremeCase> speed_cases() {
  const std::string family = "speeds";
  return {
      {family,
       "speeds-rest",
       {{"Bodies at rest that touch nothing go nowhere in 1,000 steps, by", 0.0, "m",
         distance_gone_m}},
       at_rest},
      {family,
       "speeds-balls",
       {{"Balls that meet at 1e-6 to 1e6 m/s part at the restitution's share of it, but for", 1e-9,
         "", rebound_error},
        {"and keep their momentum but for a share of", 1e-12, "", momentum_drift},
        {"and gain of their energy at most", 1e-9, "", energy_gain_by_touching}},
       all_speeds},
  };
}

}  // namespace impetus::inline extremes
