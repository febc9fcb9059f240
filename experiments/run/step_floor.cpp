// SPDX-License-Identifier: MIT
#include "experiments/run/step_floor.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "experiments/run/scene_run.hpp"

namespace impetus::inline run {

double floor_ms(const StagedScene& scene, const WorkClock& clock) {
  constexpr std::size_t kSteps = 300;
  constexpr std::size_t kRuns = 3;
  WorkGrants nothing;
  nothing.units.fill(0);
  FixedWork meter(nothing);
  std::vector<std::array<std::int64_t, kRuns>> steps_ns(kSteps);
  for (std::size_t i = 0; i < kRuns; ++i) {
    SceneRun run(scene);
    for (std::array<std::int64_t, kRuns>& step_ns : steps_ns) {
      const auto region = run.next_region({});
      const std::int64_t began_ns = clock.now_ns();
      static_cast<void>(run.step({}, region, meter));
      step_ns[i] = clock.now_ns() - began_ns;
    }
  }
  std::int64_t longest_ns = 0;
  for (std::array<std::int64_t, kRuns>& step_ns : steps_ns) {
    std::sort(step_ns.begin(), step_ns.end());
    longest_ns = std::max(longest_ns, step_ns[kRuns / 2]);
  }
  return 1e-6 * static_cast<double>(longest_ns);
}

}  // namespace impetus::inline run
