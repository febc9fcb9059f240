// One unit in the last place of one state variable, in one step: replay catches it there, and names
// trial, step, body and field.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "tests/experiments/golden_study.hpp"

namespace impetus::one_ulp_test {

constexpr std::size_t kVariables = 13;

/// A variable of a body's state, counted as in `kField`.
double& variable(BodyState& state, std::size_t index) {
  double* const values[kVariables] = {
      &state.pose.position.x(),    &state.pose.position.y(),    &state.pose.position.z(),
      &state.pose.orientation.w(), &state.pose.orientation.x(), &state.pose.orientation.y(),
      &state.pose.orientation.z(), &state.linear_momentum.x(),  &state.linear_momentum.y(),
      &state.linear_momentum.z(),  &state.angular_momentum.x(), &state.angular_momentum.y(),
      &state.angular_momentum.z()};
  return *values[index];
}

constexpr const char* kField[kVariables] = {
    "position",         "position",         "position",        "orientation",     "orientation",
    "orientation",      "orientation",      "linear momentum", "linear momentum", "linear momentum",
    "angular momentum", "angular momentum", "angular momentum"};

enum class Towards { kMore, kLess };

void change_by_one_ulp(double& value, Towards towards) {
  const double infinity = std::numeric_limits<double>::infinity();
  value = std::nextafter(value, towards == Towards::kMore ? infinity : -infinity);
}

/// Calls `act` for each body, variable and direction.
template <typename Act>
void for_every_change(std::size_t bodies, const Act& act) {
  for (std::size_t body = 0; body < bodies; ++body) {
    for (std::size_t index = 0; index < kVariables; ++index) {
      act(body, index, Towards::kMore);
      act(body, index, Towards::kLess);
    }
  }
}

std::string expected_words(const StoredAttempt& attempt, std::int64_t step, const World& world,
                           std::size_t body, std::size_t index) {
  return "trial " + std::to_string(attempt.trial_id) + ", step " + std::to_string(step) +
         ", body " + world.models()[body].name + ", " + kField[index];
}

/// The states after each step of a trial.
std::vector<std::vector<BodyState>> states_of(const StagedScene& scene,
                                              const std::vector<StepRecord>& steps) {
  std::vector<std::vector<BodyState>> states;
  replay(scene, steps, [&](std::int64_t, const World& world, const StepReport&) {
    states.push_back(world.states());
  });
  return states;
}

/// Recordings in which one variable of one body was another in step `at`: each has to be found to
/// differ there, and nowhere else.
void expect_every_change_named(Golden& golden, std::size_t trial, std::size_t at) {
  const StoredAttempt& attempt = golden.attempts[trial];
  const StagedScene scene = golden.stage(attempt);
  std::vector<StepRecord> steps = golden.steps(attempt);
  ASSERT_GT(steps.size(), at);
  steps.resize(at + 1);
  const std::vector<BodyState> then = states_of(scene, steps)[at];
  for_every_change(then.size(), [&](std::size_t body, std::size_t index, Towards towards) {
    std::vector<BodyState> changed = then;
    change_by_one_ulp(variable(changed[body], index), towards);
    steps[at].state = hash_state(changed);
    EXPECT_EQ(words(attempt, replay(scene, steps)),
              expected_words(attempt, steps[at].step, scene.world, body, index));
  });
}

// 13 variables of two or more bodies, up and down: before, in and after a collision.
TEST(OneUlp, OfAnyVariableOfARecordingIsCaughtAtItsStepAndNamed) {
  Golden causality("causality");
  for (const std::size_t at : {0U, 1U, 240U, 241U, 400U}) {
    expect_every_change_named(causality, 8, at);
  }
  Golden response("response");  // bodies that spin
  for (const std::size_t at : {100U, 300U}) {
    expect_every_change_named(response, 10, at);
  }
}

// Ten bodies and the walls.
TEST(OneUlp, OfAnyBodyOfACrowdIsCaughtAndNamed) {
  Golden golden("gaze-contingent");
  std::size_t crowd = 0;
  while (golden.attempts[crowd].trial.condition.find("10") == std::string::npos) {
    ++crowd;
  }
  ASSERT_EQ(golden.stage(golden.attempts[crowd]).world.states().size(), 10U);
  expect_every_change_named(golden, crowd, 2);
}

// The world itself begins one unit off.
TEST(OneUlp, OfAnyVariableOfTheWorldAtTheStartIsCaughtAndNamed) {
  Golden golden("response");
  const StoredAttempt& attempt = golden.attempts[10];
  const StagedScene scene = golden.stage(attempt);
  const std::vector<StepRecord> steps = golden.steps(attempt);
  for_every_change(2, [&](std::size_t body, std::size_t index, Towards towards) {
    StagedScene changed = scene;
    change_by_one_ulp(variable(changed.world.mutable_states()[body], index), towards);
    EXPECT_EQ(words(attempt, replay(std::move(changed), steps)),
              expected_words(attempt, 0, scene.world, body, index));
  });
}

/// A recording whose digests in step `at` are as they were, though its hash is not, as one change
/// in 65,536 leaves them.
std::vector<StepRecord> with_a_collision_of_digests(std::vector<StepRecord> steps, std::size_t at) {
  steps[at].state.hash ^= 1U;
  return steps;
}

TEST(OneUlp, WhereADigestStaysTheNextStepNamesBodyAndField) {
  Golden golden;
  const StoredAttempt& attempt = golden.attempts[8];
  std::vector<StepRecord> steps = with_a_collision_of_digests(golden.steps(attempt), 100);
  steps[101].state.hash ^= 1U;
  steps[101].state.bodies[1][0] ^= 1U;
  const ReplayResult result = replay(golden.stage(attempt), steps);
  EXPECT_EQ(words(attempt, result), "trial 9, step 100, body right, position");
  EXPECT_EQ(result.divergence->named_at, 101);
}

TEST(OneUlp, WhereNoDigestTellsTheHashStillDoes) {
  Golden golden;
  const StoredAttempt& attempt = golden.attempts[8];
  const ReplayResult result =
      replay(golden.stage(attempt), with_a_collision_of_digests(golden.steps(attempt), 100));
  EXPECT_EQ(words(attempt, result), "trial 9, step 100, body , ");
  EXPECT_EQ(result.divergence->named_at, 100);
}

}  // namespace impetus::one_ulp_test
