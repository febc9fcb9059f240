// Each phase of a step alone, on what the phases before it would have left; and all in turn.
// SPDX-License-Identifier: MIT
#include "engine/world/phases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/collision/broad_phase.hpp"
#include "tests/engine/crowds.hpp"

namespace impetus::phases_test {

/// A step of some bodies that nobody has made yet.
struct StepOf {
  StepOf(std::vector<BodyModel> models, std::vector<BodyState> states, WorldSettings with = {})
      : settings(std::move(with)), world(std::move(models), std::move(states), settings) {}

  [[nodiscard]] Step step() { return {settings, input, world, memory, meter}; }

  WorldSettings settings;
  StepInput input{step_of(kStep_s)};
  WorldState world;
  StepMemory memory;
  FixedWork meter{kUnlimitedTests};
};

/// Two balls of .1 m whose centres are `apart_m` from each other, approaching at 2 m/s.
StepOf two_balls(double apart_m, WorldSettings settings = {}) {
  const BodyModel model = ball(0.1, 1.0);
  return {{model, model},
          {moving(model, {-0.5 * apart_m, 0.0, 0.0}, {1.0, 0.0, 0.0}),
           moving(model, {0.5 * apart_m, 0.0, 0.0}, {-1.0, 0.0, 0.0})},
          std::move(settings)};
}

/// The two balls as a pair of which the first phases have told.
StepOf two_paired_balls(double apart_m, WorldSettings settings = {}) {
  StepOf balls = two_balls(apart_m, std::move(settings));
  for (std::size_t body = 0; body < 2; ++body) {
    balls.world.placed[body].move_to(balls.world.states[body].pose);
  }
  balls.memory.candidates = {{{0, 1},
                              {balls.world.states[0].pose.position, 0.1},
                              {balls.world.states[1].pose.position, 0.1}}};
  return balls;
}

TEST(Phases, MoveTakesBodiesWhereTheirMomentaDoAndKeepsHowFarTheyWent) {
  StepOf balls = two_balls(1.0);
  move_bodies(balls.step());
  ASSERT_EQ(balls.memory.bounds.size(), 2U);
  const MovedBound& moved = balls.memory.bounds[0];
  EXPECT_DOUBLE_EQ(balls.world.states[0].pose.position.x(), -0.5 + kStep_s);
  EXPECT_EQ(moved.bound.centre, balls.world.states[0].pose.position);
  EXPECT_DOUBLE_EQ(moved.travelled_m, kStep_s);
  EXPECT_TRUE(moved.movable);
}

TEST(Phases, PairFindsWhoseSweptBoundsTouchAndPlacesTheTrees) {
  StepOf balls = two_balls(0.25);
  const auto candidates = [&balls](double travelled_m) {
    balls.memory.bounds.clear();
    for (const BodyState& state : balls.world.states) {
      balls.memory.bounds.push_back({{state.pose.position, 0.1}, travelled_m, true});
    }
    pair_bodies(balls.step());
    return balls.memory.candidates.size();
  };
  EXPECT_EQ(candidates(0.02), 0U) << ".05 m between them, of which they went .04";
  EXPECT_EQ(candidates(0.03), 1U);
  EXPECT_EQ(balls.memory.candidates[0].pair, (BodyPair{0, 1}));
  EXPECT_EQ(bounding_sphere(balls.world.placed[1].world_volume(0)).centre,
            balls.world.states[1].pose.position);
}

TEST(Phases, PairFindsTheEnclosureToo) {
  WorldSettings settings;
  settings.enclosure = ClosedCube{0.55};
  StepOf balls = two_balls(1.0, settings);
  move_bodies(balls.step());
  pair_bodies(balls.step());
  ASSERT_EQ(balls.memory.candidates.size(), 2U);
  EXPECT_EQ(balls.memory.candidates[1].pair, (BodyPair{1, kEnclosure}));
}

TEST(Phases, PrioritiseGivesAPairTheListThatItsMetricSays) {
  WorldSettings settings;
  settings.schedule.lists = {{}, {}};
  for (const double threshold_m : {9.0, 11.0}) {  // the eye is 10 m away
    settings.schedule.limits = {threshold_m};
    StepOf balls = two_paired_balls(0.19, settings);
    prioritise_pairs(balls.step());
    ASSERT_EQ(balls.memory.order.pairs().size(), 1U);
    EXPECT_EQ(balls.memory.order.pairs()[0].scheduled.list, threshold_m > 10.0 ? 0 : 1);
  }
}

TEST(Phases, RefineGoesAsDeepAsWorkIsGrantedAndSaysWhatItSpent) {
  const BodyModel block = solid_body(small_l_block(), /*depth=*/3);
  for (const std::int64_t budget : {std::int64_t{0}, kUnlimitedTests}) {
    StepOf blocks({block, block}, {resting_at({-0.01, 0, 0}), resting_at({0.01, 0.01, 0})});
    move_bodies(blocks.step());
    pair_bodies(blocks.step());
    prioritise_pairs(blocks.step());
    blocks.meter = FixedWork(budget);
    refine_pairs(blocks.step());
    const std::span<RefinedPair> pairs = blocks.memory.refined.all();
    ASSERT_EQ(pairs.size(), 1U);
    EXPECT_EQ(pairs[0].refinement.level(), budget == 0 ? 0 : 3);
    EXPECT_EQ(blocks.memory.report.work_floor, 1) << "the roots";
    EXPECT_EQ(blocks.memory.report.work_spent > 1, budget > 0);
  }
}

TEST(Phases, ModelReportsAContactWhereNodesOverlapAndWhetherItBegan) {
  for (const bool touched : {false, true}) {
    StepOf balls = two_paired_balls(0.19);
    RefinedPair& pair = balls.memory.refined.add();
    pair.bodies = {0, 1};
    pair.list = 2;
    pair.refinement.begin(balls.world.placed[0], balls.world.placed[1]);
    if (touched) {
      balls.world.touching = {{{0, 1}}};
    }
    model_contacts(balls.step());
    ASSERT_EQ(balls.memory.report.collisions.size(), 1U);
    const CollisionReport& collision = balls.memory.report.collisions[0];
    EXPECT_EQ(collision.list, 2);
    EXPECT_EQ(collision.stop, StopReason::kFinest);
    EXPECT_EQ(collision.began, !touched);
    EXPECT_NEAR(collision.contact.touch.depth_m, 0.01, 1e-15);  // a rounding of each radius
    EXPECT_EQ(balls.memory.report.contacts.size(), 1U);
  }
}

/// The two balls with a contact between them that somebody modelled.
StepOf two_balls_in_contact(WorldSettings settings = {}) {
  StepOf balls = two_balls(0.19, std::move(settings));
  CollisionReport collision;
  collision.bodies = {0, 1};
  collision.level = 3;
  collision.contact = {{0, 1}, {Vector3::Zero(), -Vector3::UnitX(), 0.01}};
  collision.began = true;
  balls.memory.report.collisions = {collision};
  balls.memory.report.contacts = {{collision.contact.touch}};
  return balls;
}

TEST(Phases, RespondTurnsApproachIntoReboundAndReportsTheImpulse) {
  WorldSettings settings;
  settings.restitution = 0.5;
  settings.imposed_hold_s = 0.1;
  StepOf balls = two_balls_in_contact(settings);
  respond_to_contacts(balls.step());
  const CollisionReport& collision = balls.memory.report.collisions[0];
  EXPECT_DOUBLE_EQ(collision.approach_m_s, 2.0);
  // j = (1 + e) v / (1/m + 1/m)
  EXPECT_DOUBLE_EQ(collision.impulse_Ns, 1.5 * 2.0 / 2.0);
  EXPECT_DOUBLE_EQ(balls.world.states[1].linear_momentum.x(), 0.5);
  EXPECT_EQ(collision.imposed_hold_s, 0.1);
  EXPECT_EQ(balls.world.states[0].held_s, 0.1);
}

TEST(Phases, RememberKeepsWhoTouchesAndTellsWhoFellToACoarserLevel) {
  StepOf balls = two_balls_in_contact();
  const BodyModel block = solid_body(small_l_block(), /*depth=*/3);
  balls.world.models = {block, block};
  remember_contacts(balls.step());
  EXPECT_TRUE(balls.memory.report.pops.empty());
  ASSERT_NE(balls.world.touched_before({0, 1}), nullptr);
  EXPECT_EQ(balls.world.touched_before({0, 1})->level, 3);
  EXPECT_EQ(balls.world.touched_before({0, kEnclosure}), nullptr);
  EXPECT_NE(balls.memory.report.state.hash, 0U);
  balls.memory.report.collisions[0].level = 1;
  remember_contacts(balls.step());
  ASSERT_EQ(balls.memory.report.pops.size(), 1U);
  const LevelPop& pop = balls.memory.report.pops[0];
  EXPECT_EQ(pop.from, 3);
  EXPECT_EQ(pop.to, 1);
  // 2 atan(½ Δ / d) of both trees, 10 m from the eye.
  const double grown_m = 2.0 * (block.tree->fit_error_m(1) - block.tree->fit_error_m(3));
  EXPECT_NEAR(pop.size_deg, 2.0 * std::atan(0.05 * grown_m) * 180.0 / std::numbers::pi, 1e-12);
}

// Else a crowd that grows within a step moves all of them to memory never touched, which takes
// milliseconds.
TEST(RefinedPairs, StayWhereTheyAreUntilThereAreThirtyTwoABody) {
  constexpr std::size_t kBodies = 100;
  RefinedPairs pairs;
  pairs.expect(/*pairs=*/1, kBodies);
  const RefinedPair* first = &pairs.add();
  for (std::size_t i = 1; i < 32 * kBodies; ++i) {
    pairs.add();
  }
  pairs.expect(pairs.all().size(), kBodies);
  EXPECT_EQ(&pairs.all().front(), first);
}

TEST(Phases, AllSevenInTurnAreAStep) {
  RandomStream random(7, "phases");
  for (int trial = 0; trial < 10; ++trial) {
    const WorldSettings settings = random_settings(random);
    World world = squeezed_crowd(random, bodies_of_every_tree_kind(), 12, 0.16, settings);
    StepOf phases(world.models(), world.states(), world.settings());
    phases.input = looking_ahead();
    phases.meter = FixedWork(500);
    const std::uint64_t hash = world.step(phases.input, phases.meter).state.hash;
    move_bodies(phases.step());
    pair_bodies(phases.step());
    prioritise_pairs(phases.step());
    refine_pairs(phases.step());
    model_contacts(phases.step());
    respond_to_contacts(phases.step());
    remember_contacts(phases.step());
    EXPECT_EQ(phases.memory.report.state.hash, hash);
  }
}

}  // namespace impetus::phases_test
