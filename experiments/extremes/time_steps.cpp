// Time steps from a microsecond to a tenth of a second.
// SPDX-License-Identifier: MIT
#include "experiments/extremes/building_blocks.hpp"
#include "experiments/extremes/extreme_cases.hpp"

#include <cmath>

namespace impetus::inline extremes {
namespace {

constexpr double kSteps_s[] = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1};

std::vector<ExtremeScene> meetings(Length /*length*/) {
  std::vector<ExtremeScene> scenes;
  for (const double restitution : {0.0, 0.5, 1.0}) {
    for (const double step_s : kSteps_s) {
      scenes.push_back(head_on(0.1, 3.0, step_s));
      scenes.back().settings.restitution = restitution;
      scenes.back().name = short_number(step_s) + " s, restitution " + short_number(restitution);
    }
  }
  return scenes;
}

/// A ball thrown up, for a tenth of a second of time at the least step, for a second at others.
std::vector<ExtremeScene> throws(Length /*length*/) {
  std::vector<ExtremeScene> scenes;
  for (const double step_s : kSteps_s) {
    ExtremeScene scene;
    scene.name = short_number(step_s) + " s";
    scene.bodies = {ball(0.1, Vector3::Zero(), {1.0, 3.0, 0.0})};
    scene.settings.gravity_m_s2 = {0.0, -9.81, 0.0};
    scene.step_s = step_s;
    scene.steps = std::llround((step_s < 1e-5 ? 0.1 : 1.0) / step_s);
    scenes.push_back(scene);
  }
  return scenes;
}

double distance_from_parabola_m(const Course& course) {
  const double t_s = static_cast<double>(course.steps()) * course.scene().step_s;
  const Vector3 place = course.start(0).pose.position + t_s * course.start(0).velocity_m_s +
                        0.5 * t_s * t_s * course.scene().settings.gravity_m_s2;
  return (course.last(0).pose.position - place).norm();
}

/// Ten balls dropped on a fixed floor that bounce and settle.
std::vector<ExtremeScene> settling(Length length) {
  std::vector<ExtremeScene> scenes;
  for (const double step_s : {1e-4, 1e-3, 1e-2, 1e-1}) {
    ExtremeScene scene;
    scene.name = short_number(step_s) + " s";
    scene.bodies = {block({4.0, 0.5, 4.0}, {0.0, -0.25, 0.0})};
    scene.bodies[0].mass_kg = 0.0;
    for (int i = 0; i < 10; ++i) {
      scene.bodies.push_back(ball(0.1, {0.25 * (i % 3), 0.3 + 0.3 * i, 0.24 * (i % 2)}));
    }
    scene.settings.gravity_m_s2 = {0.0, -9.81, 0.0};
    scene.settings.restitution = 0.5;
    scene.step_s = step_s;
    scene.steps = std::llround((length == Length::kQuick ? 1.0 : 3.0) / step_s);
    scenes.push_back(scene);
  }
  return scenes;
}

}  // namespace

std::vector<ExtremeCase> time_step_cases() {
  const std::string family = "time steps";
  return {
      {family,
       "steps-balls",
       {{"At steps of 1e-6 to .1 s balls part at the restitution's share of the speed, but for",
         1e-9, "", rebound_error}},
       meetings},
      {family,
       "steps-parabola",
       {{"A ball that is thrown leaves its parabola by at most", 1e-9, "m",
         distance_from_parabola_m}},
       throws},
      {family,
       "steps-settling",
       {{"Ten balls that bounce and settle, at steps of 1e-4 to .1 s, gain of their energy at most",
         1e-9, "", energy_gain_by_touching}},
       settling},
  };
}

}  // namespace impetus::inline extremes
