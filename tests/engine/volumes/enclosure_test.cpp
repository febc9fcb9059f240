// The closed cube, bodies that may not spin, and bodies that touch before the start.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/dynamics/motion.hpp"
#include "engine/world/starting_overlaps.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::enclosure_test {

WorldSettings in_cube(double half_edge_m, double restitution = 1.0) {
  WorldSettings settings;
  settings.restitution = restitution;
  settings.enclosure = ClosedCube{half_edge_m};
  return settings;
}

TEST(ClosedCube, ABallBouncesOffEachWallAlongItsInwardNormal) {
  const BodyModel model = ball(0.1, 2.0);
  for (int wall = 0; wall < kWallCount; ++wall) {
    const Vector3 inward = inward_normal(wall);
    const Vector3 along(0.3 * inward.y(), 0.3 * inward.z(), 0.3 * inward.x());
    World world({model}, {moving(model, -0.899 * inward, -2.0 * inward + along)}, in_cube(1.0));
    const StepReport report = step_whole(world);
    ASSERT_EQ(report.collisions.size(), 1U) << wall;
    const CollisionReport& collision = report.collisions[0];
    EXPECT_EQ(collision.bodies, (BodyPair{0, wall_index(wall)}));
    EXPECT_EQ(collision.contact.touch.normal, inward);
    EXPECT_NEAR(collision.contact.touch.point.dot(inward), -1.0, 1e-15) << "on the wall";
    EXPECT_EQ(collision.approach_m_s, 2.0);
    EXPECT_NEAR(collision.impulse_Ns, 8.0, 1e-14) << "(1 + 1) m v";
    const Vector3 after = velocity(model, world.states()[0]);
    EXPECT_LT((after - (2.0 * inward + along)).norm(), 1e-14);
    EXPECT_EQ(report.work_spent, 1) << "one node against the cube is one test";
  }
}

TEST(ClosedCube, AnInelasticWallKeepsNothingOfTheApproach) {
  const BodyModel model = ball(0.1, 2.0);
  World world({model}, {moving(model, {0.899, 0.0, 0.0}, {2.0, 1.0, 0.0})}, in_cube(1.0, 0.0));
  step_whole(world);
  EXPECT_NEAR(velocity(model, world.states()[0]).x(), 0.0, 1e-15);
  EXPECT_EQ(velocity(model, world.states()[0]).y(), 1.0);
}

TEST(ClosedCube, InACornerThreeWallsAreThreeCollisions) {
  const BodyModel model = ball(0.1, 2.0);
  World world({model}, {moving(model, {0.899, -0.899, 0.899}, {2.0, -2.0, 2.0})}, in_cube(1.0));
  const StepReport report = step_whole(world);
  std::vector<BodyPair> pairs;
  for (const CollisionReport& collision : report.collisions) {
    pairs.push_back(collision.bodies);
  }
  EXPECT_EQ(pairs,
            (std::vector<BodyPair>{{0, wall_index(4)}, {0, wall_index(3)}, {0, wall_index(0)}}));
  EXPECT_EQ(velocity(model, world.states()[0]), Vector3(-2.0, 2.0, -2.0));
}

TEST(ClosedCube, IsRefinedLevelByLevelLikeAnyPair) {
  // The block's bounding sphere reaches through the wall, the block itself does not.
  const BodyModel model = solid_body(small_l_block(), 4);
  const double reach_m = model.tree->bounding_radius_m();
  const BodyState state = resting_at({1.0 - 0.95 * reach_m, 0.0, 0.0});
  World world({model}, {state}, in_cube(1.0));
  FixedWork roots_only(1);
  const StepReport rough = World(world).step(step_of(kStep_s), roots_only);
  ASSERT_EQ(rough.collisions.size(), 1U);
  EXPECT_EQ(rough.collisions[0].level, 0);
  EXPECT_EQ(rough.collisions[0].stop, StopReason::kBudgetSpent);
  const StepReport fine = step_whole(world);
  EXPECT_TRUE(fine.collisions.empty());
  EXPECT_GT(fine.work_spent, 1);
}

TEST(ClosedCube, TheFinestLevelMissesNoVertexBeyondAWall) {
  RandomStream random(9, "vertices beyond walls");
  const TriangleMesh mesh = small_l_block();
  const BodyModel model = solid_body(mesh, 4);
  int beyond = 0;
  for (int trial = 0; trial < 1'000; ++trial) {
    BodyState state = resting_at(random_in_cube(random, 0.5));
    state.pose.orientation = random_turn(random);
    double farthest = 0.0;
    for (const Vector3& vertex : mesh.vertices) {
      farthest = std::max(farthest, state.pose.transform(vertex).cwiseAbs().maxCoeff());
    }
    World world({model}, {state}, in_cube(0.5));
    const double finest_m = model.tree->fit_error_m(99);
    const bool touched = !step_whole(world).collisions.empty();
    ASSERT_TRUE(touched || farthest < 0.5) << trial;
    ASSERT_TRUE(!touched || farthest > 0.5 - finest_m) << "no farther than the fit error";
    beyond += farthest >= 0.5 ? 1 : 0;
  }
  EXPECT_GT(beyond, 100);
}

TEST(ClosedCube, AWorldRefusesOneWithoutRoom) {
  EXPECT_THROW(World({}, {}, in_cube(0.0)), std::invalid_argument);
  EXPECT_THROW(World({}, {}, in_cube(std::nan(""))), std::invalid_argument);
}

TEST(ClosedCube, AHoldAtAWallFreezesTheBody) {
  const BodyModel model = ball(0.1, 2.0);
  WorldSettings settings = in_cube(1.0);
  settings.imposed_hold_s = 0.1;
  World world({model}, {moving(model, {0.899, 0.0, 0.0}, {2.0, 0.0, 0.0})}, settings);
  EXPECT_EQ(step_whole(world).collisions[0].imposed_hold_s, 0.1);
  const Vector3 touched = world.states()[0].pose.position;
  for (int step = 0; step < 20; ++step) {
    const StepReport report = step_whole(world);
    EXPECT_FALSE(report.collisions[0].began);
    EXPECT_EQ(world.states()[0].pose.position, touched);
  }
}

TEST(ClosedCube, FifteenLBlocksGainNoEnergyInAnyImpactAndStayInside) {
  World world = enclosed_l_blocks(15, 3);
  const double start = total_energy(world);
  std::size_t with_walls = 0;
  std::size_t with_bodies = 0;
  for (int step = 0; step < 2'400; ++step) {
    const double before = energy_after_free_flight(world, kStep_s);
    for (const CollisionReport& collision : step_whole(world).collisions) {
      ++(is_wall(collision.bodies.b) ? with_walls : with_bodies);
    }
    ASSERT_LE(total_energy(world), before * (1.0 + 1e-13)) << step;
    for (const BodyState& state : world.states()) {
      ASSERT_LT(state.pose.position.cwiseAbs().maxCoeff(), 0.6) << step;
    }
  }
  // Rotation by the implicit midpoint drifts by 1e-5 (engine-notes).
  EXPECT_NEAR(total_energy(world) / start, 1.0, 1e-3);
  EXPECT_GT(with_walls, 100U);
  EXPECT_GT(with_bodies, 100U);
}

TEST(NoSpin, ABodyWithoutInverseInertiaIsPushedOffCentreAndNeverTurns) {
  const TriangleMesh mesh = small_l_block();
  BodyModel model = solid_body(mesh, 4);
  model.inverse_inertia.setZero();
  RandomStream random(11, "no spin");
  for (int trial = 0; trial < 20; ++trial) {
    BodyState left = moving(model, {-0.2, 0.03, 0.01}, {1.0, 0.0, 0.0});
    BodyState right = moving(model, {0.2, 0.0, 0.0}, {-1.0, 0.0, 0.0});
    left.pose.orientation = random_turn(random);
    right.pose.orientation = random_turn(random);
    World world({model, model}, {left, right}, {});
    const double energy = total_energy(world);
    std::size_t contacts = 0;
    for (int step = 0; step < 200; ++step) {
      contacts += step_whole(world).collisions.size();
    }
    ASSERT_GT(contacts, 0U);
    EXPECT_EQ(world.states()[0].pose.orientation.coeffs(), left.pose.orientation.coeffs());
    EXPECT_EQ(world.states()[1].pose.orientation.coeffs(), right.pose.orientation.coeffs());
    EXPECT_NEAR(total_energy(world), energy, 1e-13 * energy);
    EXPECT_LT(velocity(model, world.states()[0]).x(), 1.0) << "nothing was repelled";
  }
}

TEST(StartingOverlaps, AreThePairsThatTouchWhereTheyStand) {
  const BodyModel model = solid_body(small_l_block(), 4);
  const double reach_m = model.tree->bounding_radius_m();
  const World world({model, model, model, model},
                    {resting_at({0.0, 0.0, 0.0}), resting_at({0.02, 0.0, 0.0}),
                     resting_at({1.0, 0.0, 1.9 - 0.03}), resting_at({0.0, 0.0, 1.9 * reach_m})},
                    in_cube(1.9));
  EXPECT_EQ(overlapping_at_start(world), (std::vector<BodyPair>{{0, 1}, {2, kEnclosure}}))
      << "body 2's half thickness is 0.035 m";
  EXPECT_EQ(overlapping_at_start(world, /*level=*/0),
            (std::vector<BodyPair>{{0, 1}, {0, 3}, {1, 3}, {2, kEnclosure}}));
}

TEST(StartingOverlaps, OfAnEmptyOrWellSpacedWorldAreNone) {
  EXPECT_TRUE(overlapping_at_start(World({}, {}, {})).empty());
  EXPECT_TRUE(overlapping_at_start(enclosed_l_blocks(15, 4)).empty());
}

}  // namespace impetus::enclosure_test
