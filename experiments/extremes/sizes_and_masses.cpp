// Sizes from a micrometre to a thousand kilometres, mass ratios to 1e12, needles and plates, and
// places a hundred thousand kilometres from the origin, where 15 nanometres are the least step.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "experiments/extremes/building_blocks.hpp"
#include "experiments/extremes/extreme_cases.hpp"

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

void move_away(ExtremeScene& scene, double distance_m) {
  for (ExtremeBody& body : scene.bodies) {
    body.start.pose.position += distance_m * Vector3(0.6, -0.48, 0.64);
  }
  scene.name = short_number(distance_m) + " m away" + scene.name;
}

std::vector<ExtremeScene> balls_far_away(Length /*length*/) {
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

std::vector<ExtremeScene> blocks_far_away(Length /*length*/) {
  std::vector<ExtremeScene> scenes;
  for (const TreeKind kind : all_tree_kinds()) {
    ExtremeScene scene = blocks(1.0, kind);
    scene.name = ", " + name_of(kind);
    move_away(scene, 1e8);
    scenes.push_back(scene);
  }
  return scenes;
}

/// Balls that meet off their centres.
std::vector<ExtremeScene> glancing_far_away(Length /*length*/) {
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

std::vector<ExtremeCase> size_cases() {
  const std::string family = "sizes";
  return {
      single_promise(family, "sizes-balls",
                     "Balls of 1e-6 to 1e6 m part as fast as they met, but for a share of", 1e-9,
                     "", rebound_error, balls_of_all_sizes),
      single_promise(
          family, "sizes-blocks",
          "Blocks of 1e-6 to 1e6 m in trees of every kind meet, and gain of their energy at most",
          1e-9, "", energy_gain_by_touching, blocks_of_all_sizes),
      single_promise(family, "sizes-mixed",
                     "Balls of 1e-6 to 1e5 m rebound from one of 1e6 m as fast as they met, but "
                     "for a share of",
                     1e-9, "", mixed_rebound_error, mixed_sizes),
  };
}

std::vector<ExtremeCase> mass_cases() {
  const std::string family = "masses and inertias";
  return {
      single_promise(
          family, "mass-ratios",
          "Balls of mass ratios to 1e12 part as momentum and restitution have it, but for a share "
          "of",
          1e-9, "", impact_error, all_ratios),
      single_promise(family, "mass-between",
                     "A light ball between heavy ones that come together: energy gained at most",
                     1e-9, "", energy_gain_by_touching, between_heavy_ones),
      single_promise(
          family, "inertias-tumble",
          "Needles and plates of 1000 to 1 keep their energy at all times within a share of", 1e-4,
          "", energy_swing, needles_and_plates),
      single_promise(family, "inertias-struck",
                     "Struck near their ends by a ball, the two gain of their energy at most", 1e-9,
                     "", energy_gain_by_touching, struck),
  };
}

std::vector<ExtremeCase> far_place_cases() {
  const std::string family = "far places";
  return {
      single_promise(
          family, "far-balls",
          "Balls of .1 m that meet up to 1e8 m from the origin part as fast, but for a share of",
          1e-9, "", rebound_error, balls_far_away),
      single_promise(
          family, "far-glancing",
          "and those that meet off their centres as they would at the origin, but for a share of",
          1e-5, "", differs_from_near, glancing_far_away),
      single_promise(family, "far-blocks",
                     "Blocks in trees of every kind that meet there gain of their energy at most",
                     1e-9, "", energy_gain_by_touching, blocks_far_away),
  };
}

}  // namespace impetus::inline extremes
