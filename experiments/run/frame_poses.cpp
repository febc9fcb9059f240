// SPDX-License-Identifier: MIT
#include "experiments/run/frame_poses.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline run {

std::int64_t steps_until(double time_s, double step_hz) {
  constexpr double kOfAStep = 1e-9;
  return static_cast<std::int64_t>(std::ceil(time_s * step_hz - kOfAStep));
}

std::int64_t last_shown_step(const StagedScene& scene, double time_s) {
  return steps_until(time_s, scene.step_hz);
}

std::vector<Pose> shown_poses(const SceneRun& run, double time_s) {
  const double position = time_s * run.scene().step_hz;
  return run.poses(std::min(1.0, 1.0 - (static_cast<double>(run.number()) - position)));
}

}  // namespace impetus::inline run
