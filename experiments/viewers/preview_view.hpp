// Shows a scene that runs on and on, with a panel that changes its schedule while it runs.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "experiments/record/ports.hpp"
#include "experiments/record/staged_scene.hpp"
#include "experiments/window/window.hpp"

namespace impetus::inline viewers {

/// How many frames were shown, and how long they took.
struct PreviewFrames {
  std::int64_t shown{0};
  double taken_s{0.0};
};

/// Runs the scene in real time until Esc or the window's close, and tells what was shown. `clock`
/// is the window's.
PreviewFrames view_preview(Window& window, StagedScene scene, const Clock& clock);

}  // namespace impetus::inline viewers
