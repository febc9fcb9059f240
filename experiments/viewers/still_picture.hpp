// One moment of a scene as a picture, as a participant has it before the eyes: for looking at how a
// scene is painted, and for a paper's figure of its stimuli.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/record/ports.hpp"
#include "experiments/window/pixels.hpp"

namespace impetus::inline viewers {

/// The scene `time_s` after its onset, unattended. Budgets in milliseconds go by `clock`. Throws
/// std::runtime_error with one sentence when no OpenGL 3.3 can be had.
Pixels still_picture(StagedScene scene, double time_s, const PictureSize& size, const Clock& clock);

}  // namespace impetus::inline viewers
