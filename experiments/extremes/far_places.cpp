// A hundred thousand kilometres from the origin, where a place is known to 15 nanometres.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "experiments/extremes/building_blocks.hpp"
#include "experiments/extremes/extreme_cases.hpp"

namespace impetus::inline extremes {
namespace {

void move_away(ExtremeScene& scene, double distance_m) {
  for (ExtremeBody& body : scene.bodies) {
    body.start.pose.position += distance_m * Vector3(0.6, -0.48, 0.64);
  }
  scene.name = short_number(distance_m) + " m away" + scene.name;
}

std::vector<ExtremeScene> balls(Length /*length*/) {
  std::vector<ExtremeScene> scenes;
  for (const double distance_m : {0.0, 1e2, 1e4, 1e6, 1e8}) {
    for (const double speed_m_s : {1e-2, 1.0, 1e3, 1e6}) {
      scenes.push_back(head_on(0.1, speed_m_s, 1.0 / 240.0));
      scenes.back().name = ", " + short_number(speed_m_s) + " m/s";
      move_away(scenes.back(), distance_m);
    }
  }
  return scenes;
}

std::vector<ExtremeScene> blocks(Length /*length*/) {
  std::vector<ExtremeScene> scenes;
  for (const TreeKind kind : all_tree_kinds()) {
    ExtremeScene scene;
    scene.bodies = {block({1.0, 0.6, 0.4}, {-0.9, 0.1, 0.0}, {1.0, 0.0, 0.0}),
                    block({0.8, 0.8, 0.3}, {0.9, -0.1, 0.05}, {-1.0, 0.0, 0.0})};
    scene.bodies[1].start.pose.orientation = Quaternion(1.0, 0.1, 0.4, 0.2).normalized();
    for (ExtremeBody& body : scene.bodies) {
      body.tree = kind;
    }
    scene.settings.rotation = Rotation::kEnergyKept;
    scene.name = ", " + name_of(kind);
    move_away(scene, 1e8);
    scenes.push_back(scene);
  }
  return scenes;
}

/// Balls that meet off their centres.
std::vector<ExtremeScene> glancing(Length /*length*/) {
  std::vector<ExtremeScene> scenes;
  for (const double distance_m : {1e4, 1e6, 1e8}) {
    scenes.push_back(head_on(0.1, 1.0, 1.0 / 240.0));
    scenes.back().bodies[0].start.pose.position.y() += 0.07;
    scenes.back().bodies[1].start.pose.position.z() += 0.05;
    move_away(scenes.back(), distance_m);
  }
  return scenes;
}

/// How far the velocities at the end are from those of the same scene about the origin, as a share
/// of the speeds.
double differs_from_near(const Course& course) {
  ExtremeScene near = course.scene();
  const Vector3 middle = 0.5 * (course.start(0).pose.position + course.start(1).pose.position);
  for (ExtremeBody& body : near.bodies) {
    body.start.pose.position -= middle;
  }
  const Course at_origin = run_scene(near);
  double worst = 0.0;
  for (const std::size_t body : {0, 1}) {
    const Vector3 apart = course.last(body).velocity_m_s - at_origin.last(body).velocity_m_s;
    worst = std::max(worst, apart.norm() / course.start(body).velocity_m_s.norm());
  }
  return course.last(0).velocity_m_s == course.start(0).velocity_m_s ? 1.0 : worst;
}

}  // namespace

std::vector<ExtremeCase> far_place_cases() {
  const std::string family = "far places";
  return {
      {family,
       "far-balls",
       {{"Balls of .1 m that meet up to 1e8 m from the origin part as fast, but for a share of",
         1e-9, "", rebound_error}},
       balls},
      {family,
       "far-glancing",
       {{"and those that meet off their centres as they would at the origin, but for a share of",
         1e-5, "", differs_from_near}},
       glancing},
      {family,
       "far-blocks",
       {{"Blocks in trees of every kind that meet there gain of their energy at most", 1e-9, "",
         energy_gain_by_touching}},
       blocks},
  };
}

}  // namespace impetus::inline extremes
