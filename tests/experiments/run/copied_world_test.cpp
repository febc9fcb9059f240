// Copies of worlds under way, with all that scenes can have in them: trees of every kind, figures,
// gravity, walls, a plane.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "experiments/protocol/checked_scene.hpp"
#include "tests/engine/squeezed_steps.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::copied_world_test {

/// Every third step begins with a new copy, which takes the step from what the world's own logs.
void expect_copies_go_on(const StagedScene& scene) {
  constexpr int kSteps = 40;
  RandomStream random(7, "grants");
  StepInput input = step_of(1.0 / scene.step_hz);
  input.viewer = scene.viewer;
  input.region = GazeRegion{{}, 1.0};
  World world = scene.world;
  std::optional<World> copy(world);
  for (int step = 0; step < kSteps; ++step) {
    if (step % 3 == 2) {
      copy.emplace(world);
    }
    WorkGrants grants;
    grants.units.fill(kUnlimitedTests);
    FixedWork meter(step % 2 == 0 ? grants : random_grants(random));
    const StepReport told = world.step(input, meter);
    FixedWork logged(grants_of(told));
    const StepReport& again = copy->step(input, logged);
    ASSERT_EQ(again.state.hash, told.state.hash) << "step " << step;
    ASSERT_EQ(again.work_spent, told.work_spent) << "step " << step;
    ASSERT_EQ(again.grants, told.grants) << "step " << step;
  }
}

TEST(CopiedWorld, GoesOnAsTheWorldDoesInEveryScene) {
  int scenes = 0;
  for (const char* folder : {"stimuli", "tests/builds"}) {
    for (const auto& entry : std::filesystem::directory_iterator(source_file(folder))) {
      const std::string name = entry.path().filename().string();
      if (entry.path().extension() != ".json" || !is_scene(read_json(entry.path()))) {
        continue;
      }
      SCOPED_TRACE(name);
      expect_copies_go_on(built(load_scene(entry.path()).value));
      ++scenes;
    }
  }
  EXPECT_GE(scenes, 25);
}

}  // namespace impetus::copied_world_test
