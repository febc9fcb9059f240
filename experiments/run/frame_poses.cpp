// SPDX-License-Identifier: MIT
#include "experiments/run/frame_poses.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline run {

std::int64_t last_shown_step(const StagedScene& scene, double time_s) {
  // A frame that falls on a step needs no later one, whatever rounding made of its time.
  constexpr double kOfAStep = 1e-9;
  return static_cast<std::int64_t>(std::ceil(time_s * scene.step_hz - kOfAStep));
}

std::vector<Pose> shown_poses(const SceneRun& run, double time_s) {
  const double position = time_s * run.scene().step_hz;
  return run.poses(std::min(1.0, 1.0 - (static_cast<double>(run.number()) - position)));
}

}  // namespace impetus::inline run
