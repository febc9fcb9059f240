// Speeds to a thousand kilometres per second, spins to ten thousand radians per second, time steps
// from a microsecond to a tenth of a second, and runs of ten million of them.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <string>

#include "experiments/extremes/building_blocks.hpp"
#include "experiments/extremes/extreme_cases.hpp"

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

/// A block that turns about nearly its middle axis, as unsteady as it gets.
ExtremeScene spinning(double spin_rad_s, Rotation rotation, double step_s, std::int64_t steps) {
  ExtremeScene scene;
  scene.name = short_number(spin_rad_s) + " rad/s, " +
               (rotation == Rotation::kMidpoint ? "midpoint" : "energy kept");
  scene.bodies = {block({0.2, 0.4, 0.6})};
  scene.bodies[0].start.spin_rad_s = spin_rad_s * Vector3(0.01, 1.0, 0.01);
  scene.settings.rotation = rotation;
  scene.step_s = step_s;
  scene.steps = steps;
  return scene;
}

std::vector<ExtremeScene> all_spins(Length length, Rotation rotation) {
  std::vector<ExtremeScene> scenes;
  for (const double spin_rad_s : {1e-3, 1.0, 1e1, 1e2, 1e3, 1e4}) {
    scenes.push_back(
        spinning(spin_rad_s, rotation, 1.0 / 240.0, length == Length::kQuick ? 2'000 : 20'000));
  }
  return scenes;
}

/// A spinning block that a ball flies into.
std::vector<ExtremeScene> hits(Length /*length*/) {
  std::vector<ExtremeScene> scenes;
  for (const double spin_rad_s : {1.0, 1e2, 1e4}) {
    for (const TreeKind kind : all_tree_kinds()) {
      ExtremeScene scene = spinning(spin_rad_s, Rotation::kEnergyKept, 1.0 / 240.0, 480);
      scene.name += ", " + name_of(kind);
      scene.bodies[0].tree = kind;
      scene.bodies.push_back(ball(0.1, {-1.0, 0.05, 0.1}, {1.0, 0.0, 0.0}));
      scenes.push_back(scene);
    }
  }
  return scenes;
}

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

std::vector<ExtremeCase> speed_cases() {
  const std::string family = "speeds";
  return {
      single_promise(family, "speeds-rest",
                     "Bodies at rest that touch nothing go nowhere in 1,000 steps, by", 0.0, "m",
                     distance_gone_m, at_rest),
      {family,
       "speeds-balls",
       {{"Balls that meet at 1e-6 to 1e6 m/s part at the restitution's share of it, but for", 1e-9,
         "", rebound_error},
        {"and keep their momentum but for a share of", 1e-12, "", momentum_drift},
        {"and gain of their energy at most", 1e-9, "", energy_gain_by_touching}},
       all_speeds},
  };
}

std::vector<ExtremeCase> spin_cases() {
  const std::string family = "spins";
  return {
      {family,
       "spins-midpoint",
       {{"A block tumbling at 1e-3 to 1e4 rad/s keeps its energy at all times within a share of",
         1e-3, "", energy_swing},
        {"and the length of one of its orientation but for", 1e-15, "", unit_length_lost}},
       [](Length length) { return all_spins(length, Rotation::kMidpoint); }},
      {family,
       "spins-energy-kept",
       {{"By the rule that keeps energy, within a share of", 1e-11, "", energy_swing},
        {"and the length of one of its orientation but for", 1e-15, "", unit_length_lost}},
       [](Length length) { return all_spins(length, Rotation::kEnergyKept); }},
      single_promise(family, "spins-hit",
                     "A ball flies into one, in trees of every kind: energy gained at most", 1e-9,
                     "", energy_gain_by_touching, hits),
  };
}

std::vector<ExtremeCase> time_step_cases() {
  const std::string family = "time steps";
  return {
      single_promise(
          family, "steps-balls",
          "At steps of 1e-6 to .1 s balls part at the restitution's share of the speed, but for",
          1e-9, "", rebound_error, meetings),
      single_promise(family, "steps-parabola",
                     "A ball that is thrown leaves its parabola by at most", 1e-9, "m",
                     distance_from_parabola_m, throws),
      single_promise(family, "steps-settling",
                     "Ten balls that bounce and settle, at steps of 1e-4 to .1 s, gain of their "
                     "energy at most",
                     1e-9, "", energy_gain_by_touching, settling),
  };
}

std::vector<ExtremeCase> long_run_cases() {
  const std::string family = "long runs";
  return {
      {family, "long-body", tumbling_promises("by the midpoint rule, 1e6 steps", 1e-3),
       tumbling_by_midpoint},
      {family, "long-body-energy-kept",
       tumbling_promises("by the rule that keeps energy, 1e7 steps, 1e6 as usual", 1e-9),
       tumbling_with_energy_kept},
      single_promise(
          family, "long-crowd",
          "15 blocks in a cube (1e6 steps; 1e4 as usual) keep their energy within a share of", 1e-9,
          "", energy_drift, crowd),
  };
}

}  // namespace impetus::inline extremes
