// Where the pictures of the viewer of replays lie: one, or two beside each other, between the words
// above and the buttons below.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/scheduling/viewer.hpp"
#include "experiments/drawing/picture_map.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline viewers {

/// Round everything.
[[nodiscard]] float screen_margin(const Gui& gui);

/// What is left between the margins.
[[nodiscard]] float content_width(const Gui& gui);

struct Panes {
  int count{1};
  float header_px{0.0F};
  float footer_px{0.0F};
};

/// The largest that fit, from left to right, with the shape of the recorded screen.
[[nodiscard]] std::vector<PixelArea> areas_of(const Panes& panes, const Gui& gui,
                                              const ScreenGeometry& screen);

}  // namespace impetus::inline viewers
