// A step of any scene allocates nothing after the scene's first second: every `new` is counted.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/engine/allocation/counted_new.hpp"
#include "tests/experiments/demand_scenes.hpp"

namespace impetus {
namespace {

TEST(SceneAllocation, NoStepAllocatesAfterTheFirstSecond) {
  ShapeLibrary library{TreeCache()};
  const auto stimuli = std::filesystem::path(IMPETUS_SOURCE_DIR) / "stimuli";
  for (const DemandScene& scene : scenes_of_growing_demand(stimuli, library)) {
    World world = scene.staged.world;
    FixedWork meter(scene.staged.budget.tests_per_step);
    constexpr double kLongest_s = 10.0;
    const auto most = static_cast<std::int64_t>(kLongest_s * scene.staged.step_hz);
    std::int64_t collisions = 0;
    for (std::int64_t step = 1; step <= std::min(most, steps_of_a_run(scene)); ++step) {
      const StepInput input = input_of_step(scene, step);
      const std::int64_t before = allocated().calls;
      const StepReport& report = world.step(input, meter);
      const double time_s = static_cast<double>(step) / scene.staged.step_hz;
      if (time_s > 1.0) {
        EXPECT_EQ(allocated().calls, before) << scene.name << " after " << time_s << " s";
      }
      collisions += static_cast<std::int64_t>(report.collisions.size());
    }
    EXPECT_GT(collisions, 0) << scene.name;
  }
}

}  // namespace
}  // namespace impetus
