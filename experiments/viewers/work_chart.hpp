// The work of the last few seconds' steps as a strip chart: spent, floor, budget.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/run/preview_run.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline viewers {

/// Draws it between the corners (pixels), title and key included.
void draw_work_chart(const Gui& gui, const PreviewRun& run, ImVec2 from, ImVec2 to);

}  // namespace impetus::inline viewers
