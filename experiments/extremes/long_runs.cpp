// Ten million steps of one body, a million of a crowd.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <string>

#include "experiments/extremes/building_blocks.hpp"
#include "experiments/extremes/crowd_scene.hpp"
#include "experiments/extremes/extreme_cases.hpp"

namespace impetus::inline extremes {
namespace {

std::vector<ExtremeScene> tumbling(Rotation rotation, std::int64_t steps) {
  ExtremeScene scene;
  scene.settings.rotation = rotation;
  scene.bodies = {block({0.2, 0.4, 0.6}, Vector3::Zero(), {1e-3, 2e-3, 3e-3})};
  scene.bodies[0].start.spin_rad_s = Vector3(0.05, 5.0, 0.05);
  scene.step_s = 1.0 / 60.0;
  scene.steps = steps;
  scene.name = short_number(static_cast<double>(steps)) + " steps";
  return {scene};
}

/// The midpoint rule's promise ends at a million steps (README.md, "Limits").
std::vector<ExtremeScene> tumbling_by_midpoint(Length length) {
  return tumbling(Rotation::kMidpoint, length == Length::kQuick ? 100'000 : 1'000'000);
}

std::vector<ExtremeScene> tumbling_with_energy_kept(Length length) {
  return tumbling(Rotation::kEnergyKept, length == Length::kQuick   ? 100'000
                                         : length == Length::kUsual ? 1'000'000
                                                                    : 10'000'000);
}

std::vector<ExtremeScene> crowd(Length length) {
  const std::int64_t steps = length == Length::kQuick   ? 1'000
                             : length == Length::kUsual ? 10'000
                                                        : 1'000'000;
  ExtremeScene scene = crowd_scene(15, 0.3, 1.0, steps);
  scene.name = short_number(static_cast<double>(steps)) + " steps";
  return {scene};
}

/// How far the angular momentum at the end is from that at the start, as its share.
double angular_momentum_drift(const Course& course) {
  const Vector3 inertia = inertia_of(course.scene().bodies[0]);
  const auto momentum = [&](const MotionSeen& motion) {
    const Quaternion& turn = motion.pose.orientation;
    return Vector3(turn *
                   Vector3(inertia.cwiseProduct(Vector3(turn.conjugate() * motion.spin_rad_s))));
  };
  const Vector3 before = momentum(course.start(0));
  return (momentum(course.last(0)) - before).norm() / before.norm();
}

double energy_drift(const Course& course) {
  return course.finite() ? energy_swing(course) : std::numeric_limits<double>::infinity();
}

std::vector<ExtremePromise> tumbling_promises(const std::string& how, double energy_share) {
  return {{"A tumbling block (" + how + ") keeps its energy at all times within a share of",
           energy_share, "", energy_drift},
          {"and its angular momentum but for a share of", 1e-12, "", angular_momentum_drift},
          {"and its momentum but for a share of", 0.0, "", momentum_drift},
          {"and the length of one of its orientation but for", 1e-15, "", unit_length_lost}};
}

}  // namespace

std::vector<ExtremeCase> long_run_cases() {
  const std::string family = "long runs";
  return {
      {family, "long-body", tumbling_promises("by the midpoint rule, 1e6 steps", 1e-3),
       tumbling_by_midpoint},
      {family, "long-body-energy-kept",
       tumbling_promises("by the rule that keeps energy, 1e7 steps, 1e6 as usual", 1e-9),
       tumbling_with_energy_kept},
      {family,
       "long-crowd",
       {{"15 blocks in a cube (1e6 steps; 1e4 as usual) keep their energy within a share of", 1e-9,
         "", energy_drift}},
       crowd},
  };
}

}  // namespace impetus::inline extremes
