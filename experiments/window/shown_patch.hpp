// What the window system holds where the photodiode patch is: the frame as it was taken over, after
// the program and the driver have done with it.
//
// X11 can be asked; other systems do not tell what they show.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "experiments/window/window.hpp"

namespace impetus::inline window {

/// Whether shown_patch() can tell anything.
bool can_read_shown_patch(Window& window);

/// The code that three pixels of the patch agree on; none: they do not, are no code, or cannot be
/// read. Waits for the window system's answer. Precondition: the window shows a patch.
std::optional<std::int64_t> shown_patch(Window& window);

/// Whether a compositor stands between the window and the screen: "none", "running", "not known".
std::string compositor_of(Window& window);

}  // namespace impetus::inline window
