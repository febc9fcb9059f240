// The controls of a preview's schedule: what orders pairs, their lists, the region.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/run/preview_settings.hpp"

namespace impetus::inline viewers {

/// Draws them into the panel; true when something changed.
bool draw_scheduler_controls(PreviewSettings& settings, double step_hz);

}  // namespace impetus::inline viewers
