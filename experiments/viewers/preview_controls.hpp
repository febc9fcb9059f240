// The controls of a preview's settings: what orders pairs, their lists, the region; what is done
// with collisions: contacts, response, fast bodies, budget.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/run/preview_settings.hpp"

namespace impetus::inline viewers {

/// Each draws a part of the settings into the panel; true when something changed.
bool draw_scheduler_controls(PreviewSettings& settings, double step_hz);
bool draw_contact_controls(PreviewSettings& settings);
bool draw_budget_controls(PreviewSettings& settings);

}  // namespace impetus::inline viewers
