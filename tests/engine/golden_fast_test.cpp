// The same bits from every compiler: a scene with everything that moves, stops and keeps bodies.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <tuple>

#include "tests/engine/shots.hpp"

namespace impetus::golden_fast_test {

/// Bullets of two materials among plates, one of them static, in the viewer's frustum.
World everything_fast(WorldSettings settings) {
  RandomStream random(2002, "everything fast");
  settings.restitution = 0.9;
  settings.materials = {{1, 2, 0.5}, {0, 3, 1.0}};
  settings.wall_material = 3;
  settings.enclosure = view_frustum(viewer_at({0.8, 0.6, 1280, 1024, 2.0}, 25.0), 0.4, 0.4);
  std::vector<BodyModel> models{plate("octree", false), plate("voxel"), plate("box")};
  std::vector<BodyState> states;
  for (int i = 0; i < 3; ++i) {
    states.push_back(moving(models[1], {0.0, 0.0, 0.15 * (i - 1)}, Vector3::Zero()));
  }
  states[0] = resting_at({0.0, 0.0, -0.15});
  states[1].linear_momentum = random_in_cube(random, 0.1);
  states[2].angular_momentum = random_in_cube(random, 1e-3);
  models[1].material = 2;
  for (int i = 0; i < 6; ++i) {
    models.push_back(bullet());
    models.back().material = 1 + i % 2;
    const Vector3 place(0.06 * (i % 3 - 1), 0.1 * (i / 3) - 0.05, 0.07);
    states.push_back(moving(models.back(), place, random_in_cube(random, 30.0)));
  }
  return {models, states, settings};
}

TEST(GoldenFast, TheSceneEndsInTheCommittedHash) {
  // Equal for GCC and Clang, -O0 and -O3, any instruction set; see TheGoldenScene.
  constexpr auto kInTurn = ResponseMethod::kInTurn;
  constexpr auto kTogether = ResponseMethod::kTogether;
  for (const auto& [format, rotation, response, expected] :
       {std::tuple(4, Rotation::kMidpoint, kInTurn, 0x8423d48116a3533eULL),
        std::tuple(4, Rotation::kEnergyKept, kTogether, 0x8d8fb7250cd7f4e3ULL),
        std::tuple(5, Rotation::kMidpoint, kInTurn, 0x4097933b1aaaaa1ULL),
        std::tuple(5, Rotation::kEnergyKept, kTogether, 0xb778feef10275b45ULL)}) {
    WorldSettings settings;
    settings.recording_format = format;
    settings.rotation = rotation;
    settings.response = response;
    World world = everything_fast(settings);
    std::uint64_t hash = 0;
    std::size_t stopped = 0;
    std::size_t at_walls = 0;
    for (int step = 0; step < 200; ++step) {
      const StepReport report = step_whole(world);
      hash = report.state.hash;
      stopped += report.stopped.size();
      for (const CollisionReport& collision : report.collisions) {
        at_walls += is_wall(collision.bodies.b) ? 1 : 0;
      }
    }
    EXPECT_EQ(hash, expected) << std::hex << hash;
    EXPECT_GT(stopped, 5U);
    EXPECT_GT(at_walls, 20U);
  }
}

TEST(GoldenFast, ACopyResumesBitForBit) {
  RandomStream random(67, "snapshot");
  for (int trial = 0; trial < 5; ++trial) {
    World whole = everything_fast({});
    const std::uint64_t copied_at = random.below(90);
    std::optional<World> copy;
    for (std::uint64_t step = 0; step < 100; ++step) {
      if (step == copied_at) {
        copy = whole;
      }
      const std::uint64_t hash = step_whole(whole).state.hash;
      if (copy) {
        ASSERT_EQ(step_whole(*copy).state.hash, hash) << copied_at << ", " << step;
      }
    }
  }
}

}  // namespace impetus::golden_fast_test
