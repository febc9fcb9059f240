// Bullets that move up to four million times their size in a step, at plates a metre or a
// millimetre thick.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "experiments/extremes/building_blocks.hpp"
#include "experiments/extremes/extreme_cases.hpp"

namespace impetus::inline extremes {
namespace {

constexpr double kBullet_m = 1e-3;

/// A bullet straight down on a plate across z, from beyond its bounding sphere; it would be at its
/// middle within a step after `steps_to_plate`.
ExtremeScene shot(const Vector3& edges_m, double speed_m_s, bool fixed,
                  std::optional<TreeKind> kind, double steps_to_plate) {
  ExtremeScene scene;
  ExtremeBody plate = block(edges_m);
  plate.mass_kg = fixed ? 0.0 : plate.mass_kg;
  plate.tree = kind;
  const double way_m = speed_m_s * kStep_s;
  const double away_m = 1.2 * edges_m.norm() + steps_to_plate * way_m;
  scene.bodies = {plate, ball(kBullet_m, {0.07 * edges_m.x(), -0.17 * edges_m.y(), away_m},
                              {0.0, 0.0, -speed_m_s})};
  scene.bodies[1].mass_kg = 0.01;
  scene.name = short_number(speed_m_s) + " m/s, " + short_number(edges_m.z()) + " m" +
               (fixed ? "" : ", free") + (kind ? ", " + name_of(*kind) : "");
  scene.settings.rotation = Rotation::kEnergyKept;  // what is left is what impacts add
  scene.step_s = kStep_s;
  // So many that a bullet that goes on is well behind the plate.
  scene.steps = 3 + std::llround(1.5 * away_m / way_m);
  return scene;
}

std::vector<ExtremeScene> shots(const Vector3& edges_m, bool fixed) {
  std::vector<std::optional<TreeKind>> kinds{std::nullopt};
  const std::vector<TreeKind> of_trees = all_tree_kinds();
  kinds.insert(kinds.end(), of_trees.begin(), of_trees.end());
  std::vector<ExtremeScene> scenes;
  for (const auto& kind : kinds) {
    for (const double speed_m_s : {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6}) {
      for (const double steps_to_plate : {0.37, 2.91}) {
        scenes.push_back(shot(edges_m, speed_m_s, fixed, kind, steps_to_plate));
      }
    }
  }
  return scenes;
}

/// Whether the bullet was ever beyond the plate's middle, where that began.
double passed(const Course& course) {
  return course.finite() && course.least_m(1).z() > course.start(0).pose.position.z() ? 0.0 : 1.0;
}

/// Whether no report told of the impact, as a stop or a collision that began.
double untold(const Course& course) { return course.stopped() + course.began() > 0 ? 0.0 : 1.0; }

}  // namespace

std::vector<ExtremeCase> tunnelling_cases() {
  const std::string family = "tunnelling";
  const std::vector<ExtremePromise> at_wall{
      {"Of bullets at 1 to 1e6 m/s into a wall, in trees of every kind, pass", 0.0, "", passed},
      {"They keep their energy at restitution 1 but for a share of", 1e-9, "", energy_swing},
      {"No report tells of an impact how it was found, of", 0.0, "", untold}};
  const std::vector<ExtremePromise> at_plate{
      {"Into a plate that flies off they gain of the energy at most", 1e-9, "",
       energy_gain_by_touching},
      {"and change the momentum by a share of", 1e-12, "", momentum_drift}};
  const Vector3 metre(4.0, 4.0, 1.0);
  const Vector3 millimetre(0.1, 0.1, 1e-3);
  const auto at = [](const Vector3& edges_m, bool fixed) {
    return [edges_m, fixed](Length) { return shots(edges_m, fixed); };
  };
  return {
      {family, "wall-metre", at_wall, at(metre, /*fixed=*/true)},
      {family, "wall-millimetre", at_wall, at(millimetre, /*fixed=*/true)},
      {family, "plate-metre", at_plate, at(metre, /*fixed=*/false)},
      {family, "plate-millimetre", at_plate, at(millimetre, /*fixed=*/false)},
  };
}

}  // namespace impetus::inline extremes
