// The panel beside a preview: its controls, each with a unit or a tooltip, and its numbers.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/run/preview_run.hpp"
#include "experiments/viewers/preview_overlays.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline viewers {

/// Where the panel stands, and what it tells of the pictures beside it.
struct PanelFrame {
  float left_px{0.0F};        ///< from here to the window's right edge
  double picture_share{1.0};  ///< size of the picture as a share of life size
  double frames_per_s{0.0};
};

[[nodiscard]] float panel_width(const Gui& gui);

/// Draws it, and does with the run and the overlays what was clicked.
void draw_preview_panel(const Gui& gui, PreviewRun& run, PreviewOverlays& overlays,
                        const PanelFrame& frame);

}  // namespace impetus::inline viewers
