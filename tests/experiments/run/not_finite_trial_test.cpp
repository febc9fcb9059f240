// A trial in which a body outgrows all numbers: recorded as such, and replayed to the same end.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/run/live_run.hpp"
#include "experiments/run/replay.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::not_finite_trial_test {

/// The free scene without walls, whose ball flies away so fast that its place is soon no number.
StagedScene flying_away() {
  json scene = free_scene();
  scene.erase("enclosure");
  StagedScene staged = built(scene);
  World& world = staged.world;
  constexpr double kStepsToLeave = 20.5;
  const double speed_m_s = 1e100 / (kStepsToLeave / staged.step_hz);
  world.mutable_states()[0].linear_momentum =
      Vector3(0.0, 0.0, speed_m_s / world.models()[0].inverse_mass);
  return staged;
}

TEST(NotFiniteTrial, TheStepNamesTheBodyAndAReplayTakesItOutInTheSameStep) {
  const StagedScene staged = flying_away();
  LiveRun live(staged, /*seed=*/1);
  live.poses_at(1.0);
  const std::vector<StepRecord> steps = live.take_steps();
  const auto found = std::find_if(steps.begin(), steps.end(),
                                  [](const StepRecord& step) { return !step.not_finite.empty(); });
  ASSERT_NE(found, steps.end());
  EXPECT_EQ(found->step, 21);
  EXPECT_EQ(found->not_finite, (std::vector<NotFiniteBody>{{0, StateField::kPosition}}));
  EXPECT_NE(found->degradations & kNotFinite, 0U);
  EXPECT_NE(steps.back().degradations & kNotFinite, 0U) << "it stays out";
  EXPECT_EQ((found - 1)->degradations & kNotFinite, 0U);

  const ReplayResult result = replay(staged, steps);
  EXPECT_FALSE(result.divergence);
  ASSERT_EQ(result.taken_out.size(), 1U);
  EXPECT_EQ(result.taken_out[0].step, 21);
  EXPECT_EQ(result.taken_out[0].body, "ball");
  EXPECT_EQ(result.taken_out[0].field, "position");
}

}  // namespace impetus::not_finite_trial_test
