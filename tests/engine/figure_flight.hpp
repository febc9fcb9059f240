// A figure alone in free flight, and what it keeps.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>

#include "tests/engine/figure_scenes.hpp"

namespace impetus {

struct Flight {
  double momentum_drift{0.0};  ///< of the linear, over its size
  double angular_drift{0.0};
  double energy_drift{0.0};
  double widest_gap_m{0.0};
  int steps_cut{0};
};

/// A stirred figure of 16 parts without limits, alone. Of its motion some steps may do, for each
/// drawn anew, fewer than `most_units`.
inline Flight fly(int steps, double stirred, Rotation rotation,
                  std::int64_t most_units = kUnlimitedTests) {
  FigureScene scene = limbs_of_16();
  for (Hinge& hinge : scene.figure.hinges) {
    hinge.least_rad = -std::numeric_limits<double>::infinity();
    hinge.most_rad = std::numeric_limits<double>::infinity();
    hinge.fold_rad = std::numeric_limits<double>::infinity();
  }
  scene.figure.self_collision = {false, false};
  RandomStream random(1, "flight");
  std::vector<BodyState> states =
      states_of(scene.figure, scene.models, poses_of(scene.figure, {}, rest_angles(scene.figure)),
                Vector3(0.3, -0.2, 0.1), Vector3(1.0, 2.0, -0.5));
  stir(scene, stirred, random, states);
  WorldSettings settings;
  settings.figures = {scene.figure};
  settings.rotation = rotation;
  World world(scene.models, states, settings);
  const WholeMomentum before = momentum_of(world.states());
  const double energy_J = energy_of(scene.models, world.states());
  Flight flight;
  for (int step = 0; step < steps; ++step) {
    WorkGrants grants;
    if (most_units < kUnlimitedTests) {
      grants.of(WorkPhase::kMotion) =
          static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(most_units)));
    }
    FixedWork work(grants);
    const bool is_cut = (world.step({kStep_s, {}}, work).degradations & kMotionCut) != 0;
    flight.steps_cut += is_cut ? 1 : 0;
    flight.widest_gap_m = std::max(flight.widest_gap_m, widest_gap_m(scene.figure, world.states()));
    flight.energy_drift = std::max(
        flight.energy_drift, std::abs(energy_of(scene.models, world.states()) / energy_J - 1.0));
  }
  const WholeMomentum after = momentum_of(world.states());
  flight.momentum_drift = (after.linear - before.linear).norm() / before.linear.norm();
  flight.angular_drift = (after.angular - before.angular).norm() / before.angular.norm();
  return flight;
}

}  // namespace impetus
