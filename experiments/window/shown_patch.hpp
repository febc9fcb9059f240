// The photodiode patch as pixels: where it lies in the window, and what of it the window system
// holds: the frame as it was taken over, after the program and the driver have done with it.
//
// X11 can be asked; other systems do not tell what they show.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "experiments/drawing/picture_map.hpp"
#include "experiments/record/photodiode_patch.hpp"
#include "experiments/window/window.hpp"

namespace impetus::inline window {

/// The square of kPatchSide_m in the corner of a window of this size that fills the screen.
PixelArea patch_area(ScreenCorner corner, const ScreenGeometry& screen, int width_px,
                     int height_px);

/// The code whose grey is nearest to this red, green and blue (0–255); none: it is no grey, or
/// lies more than 8 from all of them.
std::optional<std::int64_t> code_of_pixel(int red, int green, int blue);

/// Whether shown_patch() can tell anything.
bool can_read_shown_patch(Window& window);

/// The code that three pixels of the patch agree on; none: they do not, are no code, or cannot be
/// read. Waits for the window system's answer. Precondition: the window shows a patch.
std::optional<std::int64_t> shown_patch(Window& window);

/// Whether a compositor stands between the window and the screen: "none", "running", "not known".
std::string compositor_of(Window& window);

}  // namespace impetus::inline window
