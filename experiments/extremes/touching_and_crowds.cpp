// Bodies that touch exactly, lie in one spot or are squeezed into each other, and crowds in closed
// cubes that are too small for them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include "engine/numerics/random_stream.hpp"
#include "experiments/extremes/building_blocks.hpp"
#include "experiments/extremes/extreme_cases.hpp"

namespace impetus::inline extremes {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Two alike at rest, a whole edge or diameter apart, or nothing.
ExtremeScene pair_at_rest(const ExtremeBody& body, double apart_m) {
  ExtremeScene scene;
  scene.bodies = {body, body};
  scene.bodies[1].start.pose.position.x() += apart_m;
  scene.steps = 1000;
  return scene;
}

/// A ball, a block and blocks of every tree kind, `edges` apart.
std::vector<ExtremeScene> pairs_at_rest(double edges) {
  std::vector<ExtremeScene> scenes{pair_at_rest(ball(0.5), edges),
                                   pair_at_rest(block({1, 1, 1}), edges)};
  scenes[0].name = "balls";
  scenes[1].name = "blocks";
  for (const TreeKind kind : all_tree_kinds()) {
    ExtremeBody body = block({1.0, 1.0, 1.0});
    body.tree = kind;
    scenes.push_back(pair_at_rest(body, edges));
    scenes.back().name = "blocks, " + name_of(kind);
  }
  return scenes;
}

/// In one spot, flying apart or turning against each other.
std::vector<ExtremeScene> coincident_and_moving(Length /*length*/) {
  std::vector<ExtremeScene> scenes = pairs_at_rest(0.0);
  for (ExtremeScene& scene : scenes) {
    scene.bodies[0].start.velocity_m_s = {1.0, 0.3, -0.2};
    scene.bodies[1].start.velocity_m_s = {-0.5, 0.1, 0.4};
    scene.bodies[1].start.spin_rad_s = {0.0, 1.0, 0.5};
    scene.name += ", coincident";
  }
  return scenes;
}

/// A small ball deep within a large one or a block, on its way out.
std::vector<ExtremeScene> deep_inside(Length /*length*/) {
  std::vector<ExtremeScene> scenes;
  for (ExtremeScene scene : pairs_at_rest(0.0)) {
    scene.bodies[1] = ball(0.05, {0.1, 0.2, -0.05}, {1.0, 0.5, 0.25});
    scene.name += ", a ball deep inside";
    scenes.push_back(scene);
  }
  return scenes;
}

/// A thousand balls whose centres coincide, each with a velocity of its own.
std::vector<ExtremeScene> one_spot(Length length) {
  RandomStream random(8, "one spot");
  ExtremeScene scene;
  const int count = length == Length::kQuick ? 200 : 1000;
  scene.name = std::to_string(count) + " balls";
  for (int i = 0; i < count; ++i) {
    const Vector3 velocity(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
    scene.bodies.push_back(ball(0.1, Vector3::Zero(), velocity));
  }
  scene.settings.restitution = 0.5;
  scene.steps = 3;
  return {scene};
}

/// Balls on a grid in a closed cube of half the volume that they have room in, under gravity.
std::vector<ExtremeScene> squeezed_pile(Length length) {
  constexpr double kRadius_m = 0.1;
  constexpr double kSpacing_m = 2.0 * kRadius_m * 0.7937005259840998;  // the cube root of a half
  const int side = length == Length::kQuick ? 4 : 6;
  ExtremeScene scene;
  scene.name = std::to_string(side * side * side) + " balls";
  const double middle = 0.5 * (side - 1);
  for (int i = 0; i < side * side * side; ++i) {
    const int layer = i / (side * side);
    const Vector3 cell(i % side - middle, i / side % side - middle, layer - middle);
    scene.bodies.push_back(ball(kRadius_m, kSpacing_m * cell));
  }
  scene.settings.enclosure = ClosedCube{0.5 * kSpacing_m * side};
  scene.settings.gravity_m_s2 = {0.0, -9.81, 0.0};
  scene.settings.restitution = 0.5;
  scene.settings.most_response_passes = 20;
  scene.steps = length == Length::kQuick ? 120 : 480;
  return {scene};
}

/// Kinetic energy that there was beyond what falling through the cube can give (a share of that).
double pile_gain(const Course& course) {
  const ExtremeScene& scene = course.scene();
  const double height_m = 2.0 * std::get<ClosedCube>(*scene.settings.enclosure).half_edge_m;
  double weight_N = 0.0;
  for (const ExtremeBody& body : scene.bodies) {
    weight_N += body.mass_kg * scene.settings.gravity_m_s2.norm();
  }
  return course.finite()
             ? (course.most_energy_J() - course.start_energy_J()) / (weight_N * height_m)
             : kNever;
}

std::vector<ExtremeScene> crowds(Length length) {
  std::vector<ExtremeScene> scenes;
  const std::int64_t steps = length == Length::kQuick ? 240 : 1200;
  for (const double filled : {0.3, 1.5, 2.0}) {
    for (const double restitution : {0.5, 1.0}) {
      scenes.push_back(crowd_scene(100, filled, restitution, steps));
    }
  }
  return scenes;
}

double energy_error(const Course& course) {
  if (!course.finite()) {
    return std::numeric_limits<double>::infinity();
  }
  return course.scene().settings.restitution == 1.0 ? energy_swing(course) : energy_gain(course);
}

/// How far the centre of any body came beyond a wall (m).
double beyond_walls_m(const Course& course) {
  const double half_m = std::get<ClosedCube>(*course.scene().settings.enclosure).half_edge_m;
  double farthest = 0.0;
  for (std::size_t body = 0; body < course.scene().bodies.size(); ++body) {
    farthest = std::max({farthest, course.greatest_m(body).maxCoeff() - half_m,
                         -course.least_m(body).minCoeff() - half_m});
  }
  return course.finite() ? farthest : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<ExtremeCase> touch_cases() {
  const std::string family = "rest and touch";
  return {
      single_promise(family, "touching-exactly",
                     "Bodies at rest that touch exactly go nowhere in 1,000 steps, by", 0.0, "m",
                     distance_gone_m, [](Length) { return pairs_at_rest(1.0); }),
      single_promise(family, "coincident-rest",
                     "Bodies at rest in exactly one place go nowhere in 1,000 steps, by", 0.0, "m",
                     distance_gone_m, [](Length) { return pairs_at_rest(0.0); }),
      single_promise(family, "coincident-moving",
                     "Those that move from exactly one place gain of their energy at most", 1e-9,
                     "", energy_gain, coincident_and_moving),
      single_promise(family, "deep-inside",
                     "A ball deep inside another body, on its way out: energy gained at most", 1e-9,
                     "", energy_gain, deep_inside),
      single_promise(family, "one-spot",
                     "A thousand balls in one spot gain of their energy at most", 1e-9, "",
                     energy_gain, one_spot),
      single_promise(
          family, "squeezed-pile",
          "A pile squeezed into half its volume gains, of what falling through it gives, at most",
          1e-9, "", pile_gain, squeezed_pile),
  };
}

std::vector<ExtremeCase> crowd_cases() {
  return {{"crowd pressure",
           "crowd",
           {{"100 blocks that fill 30 to 200 % of a cube keep their energy (at restitution .5: "
             "gain none) within a share of",
             1e-9, "", energy_error},
            {"and none of their centres leaves the cube, by", 0.0, "m", beyond_walls_m}},
           crowds}};
}

}  // namespace impetus::inline extremes
