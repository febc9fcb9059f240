// SPDX-License-Identifier: MIT
#include "experiments/run/step_floor.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "experiments/run/scene_run.hpp"

namespace impetus::inline run {

double floor_ms(const StagedScene& scene, const WorkClock& clock) {
  constexpr std::size_t kSteps = 120;
  constexpr int kRuns = 3;
  WorkGrants nothing;
  nothing.units.fill(0);
  FixedWork meter(nothing);
  std::vector<double> steps_ms(kSteps, std::numeric_limits<double>::infinity());
  for (int i = 0; i < kRuns; ++i) {
    SceneRun run(scene);
    for (double& step_ms : steps_ms) {
      const auto region = run.next_region({});
      const std::int64_t began_ns = clock.now_ns();
      static_cast<void>(run.step({}, region, meter));
      step_ms = std::min(step_ms, 1e-6 * static_cast<double>(clock.now_ns() - began_ns));
    }
  }
  return *std::max_element(steps_ms.begin(), steps_ms.end());
}

}  // namespace impetus::inline run
