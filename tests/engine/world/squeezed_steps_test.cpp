// Whatever is cut of a step, and wherever: the answer is valid, and the log replays it.
// SPDX-License-Identifier: MIT
#include "tests/engine/squeezed_steps.hpp"

namespace impetus::squeezed_steps_test {

constexpr std::uint64_t kSeed = 27;

/// Of the energy, in a step: bodies of 5 rad/s by the midpoint rule.
constexpr double kSwing = 1e-3;

TEST(SqueezedSteps, GainNoEnergyLetNobodyOutAndReplayFromTheirLog) {
  RandomStream random(kSeed, "grants");
  const std::vector<BodyModel> kinds = bodies_of_every_tree_kind();
  SqueezedSteps seen;
  for (int crowd = 0; crowd < 30; ++crowd) {
    WorldSettings settings = random_settings(random);
    settings.rotation = crowd % 2 == 0 ? Rotation::kMidpoint : Rotation::kEnergyKept;
    SqueezedSteps of_crowd;
    expect_squeezed_steps_hold(random, squeezed_crowd(random, kinds, 14, 0.13, settings), 60,
                               crowd % 2 == 0 ? kSwing : 1e-9, of_crowd);
    ASSERT_FALSE(HasFatalFailure()) << "crowd " << crowd;
    seen.steps_cut += of_crowd.steps_cut;
    seen.degradations |= of_crowd.degradations;
  }
  EXPECT_GT(seen.steps_cut, 1'500);
  const std::uint32_t each = kPairsLeft | kContactsLeft | kResponseCut | kEntryTestsSpent;
  EXPECT_EQ(seen.degradations & each, each) << "not every kind of cut occurred";
}

TEST(SqueezedSteps, KeepMomentumWhereThereAreNoWalls) {
  RandomStream random(kSeed, "momentum");
  const std::vector<BodyModel> kinds = bodies_of_every_tree_kind();
  World boxed = squeezed_crowd(random, kinds, 14, 0.1, random_settings(random));
  WorldSettings settings = boxed.settings();
  settings.enclosure.reset();
  World world(boxed.models(), boxed.states(), settings);
  const auto momentum = [&world] {
    Vector3 sum = Vector3::Zero();
    for (const BodyState& state : world.states()) {
      sum += state.linear_momentum;
    }
    return sum;
  };
  double scale = 0.0;
  for (const BodyState& state : world.states()) {
    scale += state.linear_momentum.norm();
  }
  const Vector3 before = momentum();
  for (int step = 0; step < 100; ++step) {
    FixedWork meter(random_grants(random));
    world.step(looking_ahead(), meter);
    ASSERT_LE((momentum() - before).norm(), 1e-13 * scale) << "step " << step;
  }
}

TEST(SqueezedSteps, AllThatIsGrantedIsTheStepWithoutAMeter) {
  RandomStream random(kSeed, "plenty");
  const std::vector<BodyModel> kinds = bodies_of_every_tree_kind();
  World metered = squeezed_crowd(random, kinds, 14, 0.13, random_settings(random));
  World free = metered;
  WorkGrants plenty;
  plenty.units.fill(1'000'000'000);
  for (int step = 0; step < 100; ++step) {
    FixedWork meter(plenty);
    FixedWork all(kUnlimitedTests);
    ASSERT_EQ(metered.step(looking_ahead(), meter).state.hash,
              free.step(looking_ahead(), all).state.hash);
  }
}

TEST(SqueezedSteps, ContactsThatAreAnsweredAreTheMostVisible) {
  // Two pairs of balls meet, one at the fixation and one aside: of one look at a contact each, and
  // then of one more for the most visible, the one that is looked at is answered.
  const BodyModel model = ball(0.1, 1.0);
  WorldSettings settings;
  settings.schedule.metric = make_metric("eccentricity");
  World world({model, model, model, model},
              {moving(model, {2.0, 0.0, 0.0}, {1.0, 0.0, 0.0}),
               moving(model, {2.19, 0.0, 0.0}, {-1.0, 0.0, 0.0}),
               moving(model, {-0.095, 0.0, 0.0}, {1.0, 0.0, 0.0}),
               moving(model, {0.095, 0.0, 0.0}, {-1.0, 0.0, 0.0})},
              settings);
  StepInput input = step_of(1e-6);
  input.viewer.eye = {0.0, 0.0, 10.0};
  WorkGrants grants;
  grants.of(WorkPhase::kResponse) = 0;
  grants.of(WorkPhase::kVisible) = 3;  // two to rank them, one to look at
  FixedWork meter(grants);
  const StepReport& report = world.step(input, meter);
  ASSERT_EQ(report.collisions.size(), 2U);
  EXPECT_EQ(report.collisions[0].impulse_Ns, 0.0) << "aside";
  EXPECT_GT(report.collisions[1].impulse_Ns, 0.0) << "where one looks";
  EXPECT_NE(report.degradations & kResponseCut, 0U);
  EXPECT_NE(report.degradations & kApproachRemains, 0U);
}

TEST(SqueezedSteps, PairsThatAreLeftAreThoseThatReachLeastIntoEachOther) {
  const BodyModel model = ball(0.1, 1.0);
  World world({model, model, model, model},
              {resting_at({0.0, 0.0, 0.0}), resting_at({0.19, 0.0, 0.0}),
               resting_at({5.0, 0.0, 0.0}), resting_at({5.05, 0.0, 0.0})},
              {});
  WorkGrants grants;
  grants.of(WorkPhase::kPairs) = 1;
  FixedWork meter(grants);
  const StepReport& report = world.step(step_of(1e-6), meter);
  EXPECT_EQ(report.pairs_left, 1);
  ASSERT_EQ(report.collisions.size(), 1U);
  EXPECT_EQ(report.collisions[0].bodies, (BodyPair{2, 3}));
  EXPECT_NE(report.degradations & kPairsLeft, 0U);
}

/// Before format 9 it cost what the pair does that stood in its place before: nothing that a copy
/// could know.
TEST(SqueezedSteps, APairThatIsNotLookedAtCostsNothing) {
  const BodyModel model = ball(0.1, 1.0);
  const auto floors = [&](int recording_format) {
    WorldSettings settings;
    settings.costs = kAllPhases;
    settings.recording_format = recording_format;
    World world({model, model}, {resting_at({0.0, 0.0, 0.0}), resting_at({0.19, 0.0, 0.0})},
                settings);
    FixedWork all(kUnlimitedTests);
    world.step(step_of(1e-6), all);
    World copy = world;
    WorkGrants grants;
    grants.of(WorkPhase::kRoots) = 0;
    FixedWork meter(grants);
    FixedWork same(grants);
    return std::pair(world.step(step_of(1e-6), meter).work_floor,
                     copy.step(step_of(1e-6), same).work_floor);
  };
  using Floors = std::pair<std::int64_t, std::int64_t>;
  EXPECT_EQ(floors(9), (Floors{0, 0}));
  EXPECT_EQ(floors(8), (Floors{kAllPhases.sphere_test, kAllPhases.volume_test}));
}

TEST(SqueezedSteps, PairsThatAStepCouldNotLookAtAreFirstInLineInTheNext) {
  const BodyModel model = ball(0.1, 1.0);
  std::vector<BodyState> states;
  for (const double x_m : {0.0, 1.0, 2.0, 3.0, 4.0}) {
    states.push_back(resting_at({x_m, 0.0, 0.0}));
    states.push_back(resting_at({x_m + 0.1, 0.0, 0.0}));
  }
  World world(std::vector<BodyModel>(states.size(), model), states, {});
  WorkGrants grants;
  grants.of(WorkPhase::kRoots) = 2;
  std::vector<std::int32_t> looked_at;
  for (int step = 0; step < 5; ++step) {
    FixedWork meter(grants);
    const StepReport& report = world.step(step_of(1e-6), meter);
    EXPECT_EQ(report.pairs_left, 3);
    for (const CollisionReport& collision : report.collisions) {
      looked_at.push_back(collision.bodies.a / 2);
    }
  }
  EXPECT_EQ(looked_at, (std::vector<std::int32_t>{0, 1, 2, 3, 0, 4, 1, 2, 3, 4}));
}

}  // namespace impetus::squeezed_steps_test
