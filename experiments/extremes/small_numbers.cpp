// Numbers below the smallest normal one, and zeros with a sign.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "engine/dynamics/state_hash.hpp"
#include "experiments/extremes/building_blocks.hpp"
#include "experiments/extremes/crowd_scene.hpp"
#include "experiments/extremes/extreme_cases.hpp"

namespace impetus::inline extremes {
namespace {

constexpr double kDenormal = 3e-310;

/// Bodies that touch, with velocities, spins and offsets below the smallest normal number.
std::vector<ExtremeScene> denormals(Length /*length*/) {
  std::vector<ExtremeScene> scenes;
  for (const ResponseMethod method : {ResponseMethod::kInTurn, ResponseMethod::kTogether}) {
    ExtremeScene scene;
    scene.name = method == ResponseMethod::kInTurn ? "in turn" : "together";
    scene.bodies = {ball(0.5), block({1.0, 1.0, 1.0}, {1.0, kDenormal, 0.0}),
                    block({1.0, 1.0, 1.0}, {1.0, 1.0, -kDenormal})};
    for (ExtremeBody& body : scene.bodies) {
      const double towards = body.start.pose.position.x() > 0.0 ? -kDenormal : kDenormal;
      body.start.velocity_m_s = Vector3(towards, kDenormal, -kDenormal);
      body.start.spin_rad_s = Vector3(kDenormal, -kDenormal, 0.0);
    }
    scene.bodies[2].tree = TreeKind::kBox;
    scene.settings.response = method;
    scenes.push_back(scene);
  }
  return scenes;
}

void turn_signs_of_zeros(Vector3& v) {
  for (int axis = 0; axis < 3; ++axis) {
    if (v[axis] == 0.0) {
      v[axis] = -v[axis];
    }
  }
}

/// Steps whose hashes differ between a scene full of zeros and the same with their signs turned.
std::vector<double> signed_zeros(Length /*length*/, const Progress& /*progress*/) {
  double differ = 0.0;
  for (const TreeKind kind : all_tree_kinds()) {
    ExtremeScene scene;
    scene.bodies = {block({1.0, 0.6, 0.4}, {-0.9, 0.0, 0.0}, {1.0, 0.0, 0.0}), ball(0.2),
                    block({0.8, 0.8, 0.3}, {0.0, 0.9, 0.0}, {0.0, -1.0, 0.0})};
    scene.bodies[0].tree = kind;
    scene.bodies[2].tree = kind;
    World plus = world_of(scene);
    World minus = plus;
    for (BodyState& state : minus.mutable_states()) {
      turn_signs_of_zeros(state.pose.position);
      turn_signs_of_zeros(state.linear_momentum);
      turn_signs_of_zeros(state.angular_momentum);
      state.pose.orientation = Quaternion(1.0, -0.0, -0.0, -0.0);
    }
    StepInput input;
    input.dt_s = scene.step_s;
    FixedWork meter(kUnlimitedTests);
    for (int step = 0; step < 480; ++step) {
      const std::uint64_t hash = plus.step(input, meter).state.hash;
      differ += hash == minus.step(input, meter).state.hash ? 0.0 : 1.0;
    }
  }
  return {differ};
}

}  // namespace

std::vector<ExtremeCase> small_number_cases() {
  const std::string family = "small numbers";
  return {
      {family,
       "denormals",
       {{"Touching bodies with velocities, spins and offsets of 3e-310 go, in a second, at most",
         1e-300, "m", distance_gone_m}},
       denormals},
      {family,
       "signed-zeros",
       {{"Steps whose hashes change with the signs of zeros", 0.0}},
       {},
       signed_zeros},
  };
}

}  // namespace impetus::inline extremes
