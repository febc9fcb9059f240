// Which poses a frame shows: those between the two steps around its time. A live trial and a film
// of its recording ask the same, so that both show the same picture, bit for bit.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "experiments/run/scene_run.hpp"

namespace impetus::inline run {

/// How many steps so long a time needs. What falls on a step needs no later one, whatever rounding
/// made of its time.
std::int64_t steps_until(double time_s, double step_hz);

/// The last step that a frame at `time_s` from onset needs.
std::int64_t last_shown_step(const StagedScene& scene, double time_s);

/// The poses of all bodies at `time_s`, within the last step of `run`, which is the one that
/// last_shown_step() names or one after it.
std::vector<Pose> shown_poses(const SceneRun& run, double time_s);

}  // namespace impetus::inline run
