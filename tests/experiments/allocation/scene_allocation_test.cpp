// A step of any scene allocates nothing once the scene has been as full as it gets: every `new` is
// counted.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/allocation/counted_new.hpp"
#include "tests/experiments/demand_scenes.hpp"
#include "tests/places/places.hpp"

namespace impetus::scene_allocation_test {

struct Run {
  std::int64_t allocations{0};
  std::int64_t collisions{0};
};

/// The first seconds of the scene, from where its bodies start.
Run run(const DemandScene& scene, World& world) {
  constexpr double kLongest_s = 10.0;
  std::ranges::copy(scene.staged.world.states(), world.mutable_states().begin());
  FixedWork meter(scene.staged.budget.tests_per_step);
  const auto most = static_cast<std::int64_t>(kLongest_s * scene.staged.step_hz);
  Run run;
  for (std::int64_t step = 1; step <= std::min(most, steps_of_a_run(scene)); ++step) {
    const StepInput input = input_of_step(scene, step);
    const std::int64_t before = allocated().calls;
    const StepReport& report = world.step(input, meter);
    run.allocations += allocated().calls - before;
    run.collisions += static_cast<std::int64_t>(report.collisions.size());
  }
  return run;
}

TEST(SceneAllocation, NoStepAllocatesInASecondRunOfAnyScene) {
  ShapeLibrary library{TreeCache()};
  const auto stimuli = std::filesystem::path(source_folder()) / "stimuli";
  for (const DemandScene& scene : scenes_of_growing_demand(stimuli, library)) {
    World world = scene.staged.world;
    EXPECT_GT(run(scene, world).collisions, 0) << scene.name;
    // What touched at the end of a run goes on into the next: the first may differ from the others.
    run(scene, world);
    EXPECT_EQ(run(scene, world).allocations, 0) << scene.name;
  }
}

}  // namespace impetus::scene_allocation_test
