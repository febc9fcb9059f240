// Sizes from a micrometre to a thousand kilometres, alone and together.
// SPDX-License-Identifier: MIT
#include "experiments/extremes/building_blocks.hpp"
#include "experiments/extremes/extreme_cases.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline extremes {
namespace {

constexpr double kSizes_m[] = {1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6};

std::vector<ExtremeScene> balls_of_all_sizes(Length /*length*/) {
  std::vector<ExtremeScene> scenes;
  for (const double size_m : kSizes_m) {
    scenes.push_back(head_on(size_m, size_m, kStep_s));
    scenes.back().name = short_number(size_m) + " m";
  }
  return scenes;
}

/// Two blocks, one of them turned, that meet off their centres.
ExtremeScene blocks(double size_m, TreeKind kind) {
  ExtremeScene scene;
  scene.name = name_of(kind) + ", " + short_number(size_m) + " m";
  scene.bodies = {block(size_m * Vector3(1.0, 0.6, 0.4), size_m * Vector3(-0.9, 0.1, 0.0),
                        size_m * Vector3(1.0, 0.0, 0.0)),
                  block(size_m * Vector3(0.8, 0.8, 0.3), size_m * Vector3(0.9, -0.1, 0.05),
                        size_m * Vector3(-1.0, 0.0, 0.0))};
  scene.bodies[1].start.pose.orientation = Quaternion(1.0, 0.1, 0.4, 0.2).normalized();
  for (ExtremeBody& body : scene.bodies) {
    body.tree = kind;
  }
  scene.settings.rotation = Rotation::kEnergyKept;  // what is left is what impacts add
  scene.step_s = kStep_s;
  return scene;
}

std::vector<ExtremeScene> blocks_of_all_sizes(Length length) {
  std::vector<ExtremeScene> scenes;
  for (const double size_m : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    for (const TreeKind kind : all_tree_kinds()) {
      if (length != Length::kQuick || kind != TreeKind::kMedial) {
        scenes.push_back(blocks(size_m, kind));
      }
    }
  }
  return scenes;
}

/// A ball of 1e6 m that nothing moves, and smaller ones that fall on it along the axes, each by
/// its own size in a second.
std::vector<ExtremeScene> mixed_sizes(Length /*length*/) {
  constexpr double kBig_m = 1e6;
  ExtremeScene scene;
  scene.name = "1e-6 to 1e6 m";
  scene.bodies = {ball(kBig_m)};
  scene.bodies[0].mass_kg = 0.0;
  const Vector3 axes[] = {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ(), -Vector3::UnitX(),
                          -Vector3::UnitY()};
  const double sizes_m[] = {1e-6, 1e-3, 1.0, 1e3, 1e5};
  for (int i = 0; i < 5; ++i) {
    const double size_m = sizes_m[i];
    scene.bodies.push_back(ball(size_m, (kBig_m + 1.3 * size_m) * axes[i], -size_m * axes[i]));
  }
  scene.step_s = kStep_s;
  return {scene};
}

/// The worst error of the speed at which each ball leaves the first.
double mixed_rebound_error(const Course& course) {
  double worst = 0.0;
  for (std::size_t body = 1; body < course.scene().bodies.size(); ++body) {
    const Vector3& met = course.start(body).velocity_m_s;
    const double error = (course.last(body).velocity_m_s + met).norm() / met.norm();
    worst = error <= worst ? worst : error;  // no number is the worst
  }
  return worst;
}

}  // namespace

std::vector<ExtremeCase> size_cases() {
  const std::string family = "sizes";
  return {
      {family,
       "sizes-balls",
       {{"Balls of 1e-6 to 1e6 m part as fast as they met, but for a share of", 1e-9, "",
         rebound_error}},
       balls_of_all_sizes},
      {family,
       "sizes-blocks",
       {{"Blocks of 1e-6 to 1e6 m in trees of every kind meet, and gain of their energy at most",
         1e-9, "", energy_gain_by_touching}},
       blocks_of_all_sizes},
      {family,
       "sizes-mixed",
       {{"Balls of 1e-6 to 1e5 m rebound from one of 1e6 m as fast as they met, but for a share of",
         1e-9, "", mixed_rebound_error}},
       mixed_sizes},
  };
}

}  // namespace impetus::inline extremes
