// The controls of what a preview does with collisions: contacts, response, fast bodies, budget.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/run/preview_settings.hpp"

namespace impetus::inline viewers {

/// Each draws into the panel; true when something changed.
bool draw_contact_controls(PreviewSettings& settings);
bool draw_budget_controls(PreviewSettings& settings);

}  // namespace impetus::inline viewers
