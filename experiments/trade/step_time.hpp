// What a step of a scene takes, measured by running it.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/session/ports.hpp"
#include "experiments/session/staged_scene.hpp"

namespace impetus {

/// Milliseconds of each step in which bodies touch, all phases included, without budget: of the
/// whole scene, or of what can be run in `most_s` seconds. Empty when nothing touches.
std::vector<double> step_times_ms(const StagedScene& scene, const Clock& clock, double most_s);

}  // namespace impetus
