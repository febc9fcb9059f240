// Bullets that move up to four million times their size in a step, at plates a metre or a
// millimetre thick.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <utility>

#include "experiments/extremes/building_blocks.hpp"
#include "experiments/extremes/extreme_cases.hpp"

namespace impetus {
namespace {

constexpr double kStep_s = 1.0 / 240.0;
constexpr double kBullet_m = 1e-3;
constexpr double kNever = std::numeric_limits<double>::infinity();

/// A bullet straight down on a plate of 4 by 4 m across z; it would be at its middle after
/// `steps_to_plate`.
ExtremeScene shot(double thickness_m, double speed_m_s, bool fixed, std::optional<TreeKind> kind,
                  double steps_to_plate) {
  ExtremeScene scene;
  ExtremeBody plate = block({4.0, 4.0, thickness_m});
  plate.mass_kg = fixed ? 0.0 : plate.mass_kg;
  plate.tree = kind;
  const double away_m = thickness_m + 2.0 * kBullet_m + steps_to_plate * speed_m_s * kStep_s;
  scene.bodies = {plate, ball(kBullet_m, {0.3, -0.7, away_m}, {0.0, 0.0, -speed_m_s})};
  scene.bodies[1].mass_kg = 0.01;
  scene.name = short_number(speed_m_s) + " m/s, " + short_number(thickness_m) + " m" +
               (fixed ? "" : ", free") + (kind ? ", " + name_of(*kind) : "");
  scene.step_s = kStep_s;
  // So many that a bullet that goes on is far behind the plate.
  scene.steps = 4 + std::llround(2.0 * (away_m + thickness_m) / (speed_m_s * kStep_s));
  return scene;
}

std::vector<ExtremeScene> shots(double thickness_m, bool fixed) {
  std::vector<std::optional<TreeKind>> kinds{std::nullopt};
  for (const TreeKind kind : all_tree_kinds()) {
    if (kind != TreeKind::kMedial || thickness_m == 1.0) {  // a thin plate needs too many balls
      kinds.emplace_back(kind);
    }
  }
  std::vector<ExtremeScene> scenes;
  for (const auto& kind : kinds) {
    for (const double speed_m_s : {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6}) {
      for (const double steps_to_plate : {0.37, 2.91}) {
        scenes.push_back(shot(thickness_m, speed_m_s, fixed, kind, steps_to_plate));
      }
    }
  }
  return scenes;
}

/// Whether the bullet was ever beyond the plate's middle, where that began.
double passed(const Course& course) {
  return course.finite() &&
                 course.least_m(1).z() > course.start(0).pose.position.z() - 0.5 * kBullet_m
             ? 0.0
             : 1.0;
}

/// Of the speed at which a bullet met a fixed plate, what it lost or gained.
double speed_error(const Course& course) {
  const Vector3& met = course.start(1).velocity_m_s;
  const Vector3& left = course.last(1).velocity_m_s;
  return course.finite() ? std::abs(left.norm() / met.norm() - 1.0) : kNever;
}

/// Whether no report told of the impact, as a stop or a collision that began.
double untold(const Course& course) { return course.stopped() + course.began() > 0 ? 0.0 : 1.0; }

}  // namespace

std::vector<ExtremeCase> tunnelling_cases() {
  const std::string family = "tunnelling";
  const std::vector<ExtremePromise> at_wall{
      {"Of bullets at 1 to 1e6 m/s into a wall, in trees of every kind, pass", 0.0, "", passed},
      {"They keep their speed at restitution 1 but for a share of", 1e-9, "", speed_error},
      {"No report tells of an impact how it was found, of", 0.0, "", untold}};
  const std::vector<ExtremePromise> at_plate{
      {"Into a plate that flies off they gain of the energy at most", 1e-9, "",
       energy_gain_by_touching},
      {"and change the momentum by a share of", 1e-12, "", momentum_drift}};
  const auto at = [](double thickness_m, bool fixed) {
    return [thickness_m, fixed](Length) { return shots(thickness_m, fixed); };
  };
  return {
      {family, "wall-metre", at_wall, at(1.0, /*fixed=*/true)},
      {family, "wall-millimetre", at_wall, at(1e-3, /*fixed=*/true)},
      {family, "plate-metre", at_plate, at(1.0, /*fixed=*/false)},
      {family, "plate-millimetre", at_plate, at(1e-3, /*fixed=*/false)},
  };
}

}  // namespace impetus
