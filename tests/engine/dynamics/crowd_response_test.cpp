// A crowd whose impulses are found together: nothing approaches after a step, no energy is gained.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/dynamics/impulse.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::crowd_response_test {

/// Balls that fly from a shell towards one point, so that all touch at once.
World imploding_balls(int count, double restitution, ResponseMethod response) {
  RandomStream random(5, "implosion");
  const BodyModel model = ball(0.1, 1.0);
  std::vector<BodyState> states;
  for (int i = 0; i < count; ++i) {
    const Vector3 direction = random_direction(random);
    states.push_back(moving(model, (0.5 + 0.02 * i) * direction, -1.0 * direction));
  }
  WorldSettings settings;
  settings.restitution = restitution;
  settings.response = response;
  return {std::vector<BodyModel>(static_cast<std::size_t>(count), model), std::move(states),
          settings};
}

TEST(ResponseTogether, LeavesNoApproachAndGainsNoEnergyInAnImplosion) {
  for (const double restitution : {0.0, 0.5, 1.0}) {
    World world = imploding_balls(40, restitution, ResponseMethod::kTogether);
    double energy_J = total_energy(world);
    std::size_t most_contacts = 0;
    for (int step = 0; step < 400; ++step) {
      const StepReport report = step_whole(world);
      ASSERT_EQ(report.degradations & kApproachRemains, 0U) << "step " << step;
      ASSERT_LE(total_energy(world), energy_J * (1.0 + 1e-12)) << "step " << step;
      energy_J = total_energy(world);
      most_contacts = std::max(most_contacts, report.collisions.size());
    }
    EXPECT_GT(most_contacts, 4U) << "nothing to find together";
    EXPECT_LE(total_momentum(world).norm(),
              total_momentum(imploding_balls(40, 0.0, ResponseMethod::kInTurn)).norm() + 1e-12);
  }
}

TEST(ResponseTogether, ASingleContactMovesBodiesAsInTurn) {
  World together = imploding_balls(2, 0.7, ResponseMethod::kTogether);
  World in_turn = imploding_balls(2, 0.7, ResponseMethod::kInTurn);
  for (int step = 0; step < 400; ++step) {
    step_whole(together);
    step_whole(in_turn);
  }
  for (std::size_t body = 0; body < 2; ++body) {
    EXPECT_LE(
        (together.states()[body].linear_momentum - in_turn.states()[body].linear_momentum).norm(),
        1e-14);
  }
}

}  // namespace impetus::crowd_response_test
