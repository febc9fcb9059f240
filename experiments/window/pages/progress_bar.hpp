// How far the session has come, along the bottom edge of every frame.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/record/page.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline window {

/// What is under the bar: its colours must stay quiet on it.
enum class Ground { kPage, kPicture };

/// Height at the bottom that the bar and its label take.
[[nodiscard]] float progress_height(const Gui& gui);

/// Draws within the present frame; nothing when there is neither total nor label.
void draw_progress(const Gui& gui, const SessionProgress& progress, Ground ground);

}  // namespace impetus::inline window
