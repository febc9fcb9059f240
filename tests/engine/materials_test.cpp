// Restitution by pair of materials, and bodies that nothing moves.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/builders.hpp"

namespace impetus::materials_test {

constexpr std::uint64_t kSeed = 64;
constexpr ResponseMethod kMethods[] = {ResponseMethod::kInTurn, ResponseMethod::kTogether};

BodyModel of_material(BodyModel model, int material) {
  model.material = material;
  return model;
}

/// Two balls of 1 kg about to meet at 1 m/s each.
double restitution_seen(int material_a, int material_b, const WorldSettings& settings) {
  const BodyModel a = of_material(ball(0.1, 1.0), material_a);
  const BodyModel b = of_material(ball(0.1, 1.0), material_b);
  World world({a, b},
              {moving(a, {-0.101, 0.0, 0.0}, {1.0, 0.0, 0.0}),
               moving(b, {0.101, 0.0, 0.0}, {-1.0, 0.0, 0.0})},
              settings);
  EXPECT_EQ(step_whole(world).collisions.size(), 1U);
  return velocity(b, world.states()[1]).x();
}

TEST(Materials, EachPairHasItsRestitutionInEitherOrderAndTheRestTheWorlds) {
  for (const ResponseMethod method : kMethods) {
    WorldSettings settings;
    settings.response = method;
    settings.restitution = 0.75;
    settings.materials = {{1, 2, 0.25}, {2, 2, 0.0}};
    EXPECT_NEAR(restitution_seen(1, 2, settings), 0.25, 1e-15);
    EXPECT_NEAR(restitution_seen(2, 1, settings), 0.25, 1e-15);
    EXPECT_NEAR(restitution_seen(2, 2, settings), 0.0, 1e-15);
    EXPECT_NEAR(restitution_seen(1, 1, settings), 0.75, 1e-15);
    EXPECT_NEAR(restitution_seen(0, 2, settings), 0.75, 1e-15);
  }
}

TEST(Materials, WallsAreOfAMaterialToo) {
  for (const ResponseMethod method : kMethods) {
    WorldSettings settings;
    settings.response = method;
    settings.enclosure = ClosedCube{1.0};
    settings.wall_material = 7;
    settings.materials = {{7, 3, 0.5}};
    for (const auto& [material, expected] : {std::pair(3, -1.0), std::pair(7, -2.0)}) {
      const BodyModel model = of_material(ball(0.1, 1.0), material);
      World world({model}, {moving(model, {0.899, 0.0, 0.0}, {2.0, 0.0, 0.0})}, settings);
      step_whole(world);
      EXPECT_NEAR(velocity(model, world.states()[0]).x(), expected, 1e-15);
    }
  }
}

TEST(Materials, StatingTheWorldsOwnRestitutionChangesNoBit) {
  for (const ResponseMethod method : kMethods) {
    WorldSettings plain;
    plain.restitution = 0.9;
    plain.response = method;
    WorldSettings stated = plain;
    stated.materials = {{0, 0, 0.9}};
    World one = random_tree_world(3, 4, plain);
    World other = random_tree_world(3, 4, stated);
    for (int step = 0; step < 150; ++step) {
      ASSERT_EQ(step_whole(one).state.hash, step_whole(other).state.hash) << step;
    }
  }
}

TEST(Materials, AListThatMakesNoSenseIsRefused) {
  const auto refusal = [](std::vector<PairRestitution> materials) -> std::string {
    WorldSettings settings;
    settings.materials = std::move(materials);
    try {
      const World world({}, {}, settings);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refusal({{0, 1, 0.0}, {0, 0, 1.0}, {1, 1, 0.5}}), "accepted");
  EXPECT_EQ(refusal({{0, 1, 0.5}, {2, 1, 1.5}}),
            "world: the restitution of materials 2 and 1 must lie in [0, 1], got 1.500000");
  EXPECT_EQ(refusal({{0, 1, std::nan("")}}).substr(0, 65),
            "world: the restitution of materials 0 and 1 must lie in [0, 1], g");
  EXPECT_EQ(refusal({{0, 1, 0.5}, {1, 0, 0.5}}),
            "world: expected one restitution for materials 1 and 0, got two");
}

/// A static box of one node, about `centre`.
BodyModel slab(const Vector3& half_extents_m) {
  BodyModel model;
  model.name = "slab";
  model.tree = std::make_shared<VolumeTree>(
      single_node_tree(Box{Vector3::Zero(), half_extents_m, Quaternion::Identity()}));
  return model;
}

TEST(StaticBodies, BallsBounceOffAFloorThatNothingMoves) {
  RandomStream random(kSeed, "floor");
  for (const ResponseMethod method : kMethods) {
    WorldSettings settings;
    settings.response = method;
    const BodyModel floor = slab({5.0, 5.0, 0.1});
    const BodyModel model = ball(0.05, 0.3);
    std::vector<BodyModel> models{floor};
    std::vector<BodyState> states(1);
    for (int i = 0; i < 9; ++i) {
      models.push_back(model);
      const Vector3 place(0.3 * (i % 3), 0.3 * (i / 3), uniform_in(random, 0.2, 0.4));
      Vector3 velocity_m_s = random_in_cube(random, 0.1);
      velocity_m_s.z() = -uniform_in(random, 0.5, 3.0);
      states.push_back(moving(model, place, velocity_m_s));
    }
    World world(models, states, settings);
    const BodyState still = world.states()[0];
    const double energy = total_energy(world);
    std::size_t bounces = 0;
    for (int step = 0; step < 200; ++step) {
      bounces += step_whole(world).collisions.size();
    }
    EXPECT_GE(bounces, 9U);
    EXPECT_EQ(world.states()[0].pose.position, still.pose.position);
    EXPECT_EQ(world.states()[0].linear_momentum, Vector3(Vector3::Zero()));
    EXPECT_EQ(world.states()[0].angular_momentum, Vector3(Vector3::Zero()));
    for (std::size_t body = 1; body < states.size(); ++body) {
      // A floor turns what comes down to going up, and leaves the rest.
      const Vector3& before = states[body].linear_momentum;
      const Vector3& after = world.states()[body].linear_momentum;
      EXPECT_LT((after - Vector3(before.x(), before.y(), -before.z())).norm(), 1e-14);
    }
    EXPECT_NEAR(total_energy(world), energy, 1e-13 * energy);
  }
}

TEST(StaticBodies, ABallBetweenTwoPlatesGoesToAndFro) {
  for (const ResponseMethod method : kMethods) {
    WorldSettings settings;
    settings.response = method;
    const BodyModel model = ball(0.05, 0.3);
    World world({slab({1.0, 1.0, 0.1}), model, slab({1.0, 1.0, 0.1})},
                {resting_at({0.0, 0.0, -0.5}), moving(model, Vector3::Zero(), {0.0, 0.0, 2.0}),
                 resting_at({0.0, 0.0, 0.5})},
                settings);
    int turns = 0;
    double direction = 1.0;
    for (int step = 0; step < 2'400; ++step) {
      step_whole(world);
      const Vector3 now = velocity(model, world.states()[1]);
      ASSERT_NEAR(std::abs(now.z()), 2.0, 1e-13);
      ASSERT_LT(std::abs(world.states()[1].pose.position.z()), 0.5) << "between the plates";
      turns += now.z() * direction < 0.0 ? 1 : 0;
      direction = now.z();
    }
    EXPECT_NEAR(turns, 10.0 * 2.0 / 0.7, 2.0) << "20 m of way, .7 m apart";
  }
}

TEST(StaticBodies, TwoThatOverlapAreNoCollision) {
  World world({slab({1.0, 1.0, 0.1}), slab({1.0, 1.0, 0.1})}, {{}, {}}, {});
  const StepReport report = step_whole(world);
  EXPECT_TRUE(report.collisions.empty());
  EXPECT_EQ(report.work_spent, 0);
}

TEST(StaticBodies, AreNotMovedByMomentaOrInertiaTheyWereGiven) {
  BodyModel model = ball(0.1, 1.0);
  model.inverse_mass = 0.0;
  BodyState state;
  state.linear_momentum = Vector3(1.0, 2.0, 3.0);
  state.angular_momentum = Vector3(1.0, 2.0, 3.0);
  const BodyModel mover = ball(0.1, 1.0);
  for (const ResponseMethod method : kMethods) {
    WorldSettings settings;
    settings.response = method;
    World world({model, mover}, {state, moving(mover, {0.0, 0.05, 0.25}, {0.0, 0.0, -2.0})},
                settings);
    const double energy = total_energy(world);
    for (int step = 0; step < 50; ++step) {
      step_whole(world);
    }
    EXPECT_EQ(world.states()[0].pose.position, state.pose.position);
    EXPECT_EQ(world.states()[0].pose.orientation.coeffs(), state.pose.orientation.coeffs());
    EXPECT_GT(velocity(mover, world.states()[1]).z(), 1.0);
    EXPECT_NEAR(total_energy(world), energy, 1e-13 * energy);
  }
}

TEST(StaticBodies, ABodyOfNegativeMassIsRefused) {
  BodyModel model = ball(0.1, 1.0);
  model.inverse_mass = -1.0;
  try {
    const World world({model}, {BodyState{}}, {});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "world: body 0 \"ball\": expected an inverse mass of 0 or more, a finite number, "
                 "got -1.000000 1/kg");
  }
}

}  // namespace impetus::materials_test
