// SPDX-License-Identifier: MIT
#include "experiments/extremes/building_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/numerics/random_stream.hpp"

namespace impetus::inline extremes {
namespace {

constexpr double kPi = 3.14159265358979323846;

ExtremeBody body_of(const Solid& solid, const Vector3& place_m, const Vector3& velocity_m_s) {
  ExtremeBody body;
  body.solid = solid;
  body.mass_kg = water_mass_kg(solid);
  body.start.pose.position = place_m;
  body.start.velocity_m_s = velocity_m_s;
  return body;
}

Vector3 random_in_cube(RandomStream& random, double half_m) {
  const double x = 2.0 * random.uniform() - 1.0;
  const double y = 2.0 * random.uniform() - 1.0;
  const double z = 2.0 * random.uniform() - 1.0;
  return half_m * Vector3(x, y, z);
}

}  // namespace

double water_mass_kg(const Solid& solid) {
  constexpr double kDensity_kg_m3 = 1000.0;
  if (const auto* ball = std::get_if<SolidBall>(&solid)) {
    return kDensity_kg_m3 * 4.0 / 3.0 * kPi * ball->radius_m * ball->radius_m * ball->radius_m;
  }
  return kDensity_kg_m3 * std::get<SolidBlock>(solid).edges_m.prod();
}

std::string short_number(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", number);
  return text;
}

ExtremeBody ball(double radius_m, const Vector3& place_m, const Vector3& velocity_m_s) {
  return body_of(SolidBall{radius_m}, place_m, velocity_m_s);
}

ExtremeBody block(const Vector3& edges_m, const Vector3& place_m, const Vector3& velocity_m_s) {
  return body_of(SolidBlock{edges_m}, place_m, velocity_m_s);
}

ExtremeScene head_on(double radius_m, double speed_m_s, double step_s) {
  constexpr double kStepsToMeet = 10.5;
  const double away_m = radius_m + kStepsToMeet * speed_m_s * step_s;
  ExtremeScene scene;
  scene.bodies = {ball(radius_m, {-away_m, 0.0, 0.0}, {speed_m_s, 0.0, 0.0}),
                  ball(radius_m, {away_m, 0.0, 0.0}, {-speed_m_s, 0.0, 0.0})};
  scene.step_s = step_s;
  scene.steps = 21;
  return scene;
}

std::vector<TreeKind> all_tree_kinds() {
  return {TreeKind::kOctree, TreeKind::kMedial, TreeKind::kVoxel,
          TreeKind::kBox,    TreeKind::kSwept,  TreeKind::kHeterogeneous};
}

double rebound_error(const Course& course) {
  const auto along = [](const MotionSeen& a, const MotionSeen& b) {
    return a.velocity_m_s.x() - b.velocity_m_s.x();
  };
  const double met = along(course.start(0), course.start(1));
  const double parted = along(course.last(0), course.last(1));
  return std::abs(parted / met + course.scene().settings.restitution);
}

double energy_gain(const Course& course) {
  return course.most_energy_J() / course.start_energy_J() - 1.0;
}

double energy_swing(const Course& course) {
  return (course.most_energy_J() - course.least_energy_J()) / course.start_energy_J();
}

double momentum_drift(const Course& course) {
  return course.momentum_drift_Ns() / course.start_momentum_Ns();
}

double unit_length_lost(const Course& course) { return course.unit_length_lost(); }

double distance_gone_m(const Course& course) {
  double farthest_m = course.finite() ? 0.0 : std::numeric_limits<double>::infinity();
  for (std::size_t body = 0; body < course.scene().bodies.size(); ++body) {
    farthest_m = std::max(farthest_m, (course.greatest_m(body) - course.least_m(body)).norm());
  }
  return farthest_m;
}

double energy_gain_by_touching(const Course& course) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  bool deflected = false;
  for (std::size_t body = 0; body < course.scene().bodies.size(); ++body) {
    deflected |= course.last(body).velocity_m_s != course.start(body).velocity_m_s;
  }
  return deflected && course.finite() ? energy_gain(course) : kNever;
}

ExtremeScene crowd_scene(int count, double filled, double restitution, std::int64_t steps,
                         TreeKind kind) {
  const Vector3 edges_m(0.2, 0.12, 0.08);
  const double bound_m = 0.5 * edges_m.norm();
  constexpr double kBallContent = 4.18879020478639;  // of a unit ball
  const double half_m =
      0.5 * cube_root(count * kBallContent * bound_m * bound_m * bound_m / filled);
  RandomStream random(8, "crowd at an extreme");
  ExtremeScene scene;
  scene.name = short_number(100.0 * filled) + " %, restitution " + short_number(restitution);
  for (int i = 0; i < count; ++i) {
    const Vector3 place = random_in_cube(random, half_m - bound_m);
    scene.bodies.push_back(block(edges_m, place, random_in_cube(random, 1.0)));
    MotionSeen& start = scene.bodies.back().start;
    const Vector3 axis = random_in_cube(random, 1.0);
    start.pose.orientation = Quaternion(0.5, axis.x(), axis.y(), axis.z()).normalized();
    start.spin_rad_s = random_in_cube(random, 5.0);
    scene.bodies.back().tree = kind;
  }
  scene.settings.enclosure = ClosedCube{half_m};
  scene.settings.restitution = restitution;
  scene.settings.most_response_passes = 50;
  scene.settings.rotation = Rotation::kEnergyKept;
  scene.steps = steps;
  return scene;
}

}  // namespace impetus::inline extremes
