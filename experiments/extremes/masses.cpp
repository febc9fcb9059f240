// Mass ratios to 1e12, needles and plates.
// SPDX-License-Identifier: MIT
#include "experiments/extremes/building_blocks.hpp"
#include "experiments/extremes/extreme_cases.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline extremes {
namespace {

std::vector<ExtremeScene> all_ratios(Length /*length*/) {
  std::vector<ExtremeScene> scenes;
  for (const double restitution : {0.0, 1.0}) {
    for (const double ratio : {1.0, 1e2, 1e4, 1e6, 1e9, 1e12}) {
      for (const std::size_t heavy : {0, 1}) {
        ExtremeScene scene = head_on(0.1, 1.0, kStep_s);
        scene.bodies[0].mass_kg = 1.0;
        scene.bodies[1].mass_kg = 1.0;
        scene.bodies[heavy].mass_kg = ratio;
        scene.settings.restitution = restitution;
        scene.name = short_number(ratio) + ", restitution " + short_number(restitution);
        scenes.push_back(scene);
      }
    }
  }
  return scenes;
}

/// The worst error of a velocity after the impact, in that at which they met:
/// v_i' = (m_1 v_1 + m_2 v_2 ± m_j e (v_j − v_i)) / (m_1 + m_2).
double impact_error(const Course& course) {
  const ExtremeScene& scene = course.scene();
  const double restitution = scene.settings.restitution;
  const double m[] = {scene.bodies[0].mass_kg, scene.bodies[1].mass_kg};
  const double v[] = {course.start(0).velocity_m_s.x(), course.start(1).velocity_m_s.x()};
  double worst = 0.0;
  for (const std::size_t i : {0, 1}) {
    const std::size_t j = 1 - i;
    const double after =
        (m[0] * v[0] + m[1] * v[1] + m[j] * restitution * (v[j] - v[i])) / (m[0] + m[1]);
    const double error = std::abs(course.last(i).velocity_m_s.x() - after) / std::abs(v[0] - v[1]);
    worst = error <= worst ? worst : error;
  }
  return worst;
}

/// A light ball between two heavy ones that come together.
std::vector<ExtremeScene> between_heavy_ones(Length /*length*/) {
  std::vector<ExtremeScene> scenes;
  for (const ResponseMethod method : {ResponseMethod::kInTurn, ResponseMethod::kTogether}) {
    for (const double ratio : {1e3, 1e6, 1e12}) {
      ExtremeScene scene = head_on(0.1, 1.0, kStep_s);
      scene.bodies[0].mass_kg = ratio;
      scene.bodies[1].mass_kg = ratio;
      scene.bodies[0].start.pose.position.x() -= 0.1;
      scene.bodies[1].start.pose.position.x() += 0.1;
      scene.bodies.push_back(ball(0.1));
      scene.bodies[2].mass_kg = 1.0;
      scene.settings.response = method;
      scene.steps = 240;
      scene.name =
          short_number(ratio) + (method == ResponseMethod::kInTurn ? ", in turn" : ", together");
      scenes.push_back(scene);
    }
  }
  return scenes;
}

ExtremeScene tumbling(const std::string& name, const Vector3& edges_m, std::int64_t steps) {
  ExtremeScene scene;
  scene.name = name;
  scene.bodies = {block(edges_m)};
  scene.bodies[0].start.spin_rad_s = Vector3(3.0, 2.0, 1.0);
  scene.steps = steps;
  return scene;
}

std::vector<ExtremeScene> needles_and_plates(Length length) {
  const std::int64_t steps = length == Length::kQuick ? 2'400 : 100'000;
  return {tumbling("needle 1000:1", {1.0, 1e-3, 1e-3}, steps),
          tumbling("flat needle", {1.0, 1e-2, 1e-3}, steps),
          tumbling("plate 1000:1", {1.0, 1.0, 1e-3}, steps),
          tumbling("oblong plate", {1.0, 0.5, 1e-3}, steps)};
}

/// A needle and a plate, each struck near its end by a ball that comes at the thin side's normal.
std::vector<ExtremeScene> struck(Length /*length*/) {
  std::vector<ExtremeScene> scenes;
  for (const ResponseMethod method : {ResponseMethod::kInTurn, ResponseMethod::kTogether}) {
    for (const ExtremeScene& scene :
         {tumbling("needle", {1.0, 1e-3, 1e-3}, 480), tumbling("plate", {1.0, 1.0, 1e-3}, 480)}) {
      for (const bool in_tree : {false, true}) {
        ExtremeScene each = scene;
        each.bodies[0].start.spin_rad_s = Vector3(0.0, 0.1, 0.0);
        each.bodies.push_back(ball(0.05, {0.4, 0.0, 0.5}, {0.0, 0.0, -2.0}));
        each.settings.response = method;
        each.name += method == ResponseMethod::kInTurn ? ", in turn" : ", together";
        if (in_tree) {
          each.bodies[0].tree = TreeKind::kBox;
          each.name += ", box tree";
        }
        scenes.push_back(each);
      }
    }
  }
  return scenes;
}

}  // namespace

std::vector<ExtremeCase> mass_cases() {
  const std::string family = "masses and inertias";
  return {
      {family,
       "mass-ratios",
       {{"Balls of mass ratios to 1e12 part as momentum and restitution have it, but for a share "
         "of",
         1e-9, "", impact_error}},
       all_ratios},
      {family,
       "mass-between",
       {{"A light ball between heavy ones that come together: energy gained at most", 1e-9, "",
         energy_gain_by_touching}},
       between_heavy_ones},
      {family,
       "inertias-tumble",
       {{"Needles and plates of 1000 to 1 keep their energy at all times within a share of", 1e-4,
         "", energy_swing}},
       needles_and_plates},
      {family,
       "inertias-struck",
       {{"Struck near their ends by a ball, the two gain of their energy at most", 1e-9, "",
         energy_gain_by_touching}},
       struck},
  };
}

}  // namespace impetus::inline extremes
