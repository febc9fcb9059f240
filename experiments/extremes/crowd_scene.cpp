// SPDX-License-Identifier: MIT
#include "experiments/extremes/crowd_scene.hpp"

#include "engine/numerics/elementary_functions.hpp"
#include "engine/numerics/random_stream.hpp"
#include "experiments/extremes/building_blocks.hpp"

namespace impetus::inline extremes {
namespace {

Vector3 random_in_cube(RandomStream& random, double half_m) {
  const double x = 2.0 * random.uniform() - 1.0;
  const double y = 2.0 * random.uniform() - 1.0;
  const double z = 2.0 * random.uniform() - 1.0;
  return half_m * Vector3(x, y, z);
}

}  // namespace

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
