// How much of what is on show the region of high priority covered.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "experiments/record/record.hpp"
#include "experiments/record/staged_scene.hpp"

namespace impetus::inline gaze {

/// Of the enclosure's image, the share inside the region; mean over the steps that had a region
/// with an edge, none without such a step.
std::optional<double> mean_covered_share(const StagedScene& scene,
                                         const std::vector<StepRecord>& steps);

}  // namespace impetus::inline gaze
