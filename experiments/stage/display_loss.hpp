// What happens when the display server dies: the session ends in order instead of in Xlib's exit().
// SPDX-License-Identifier: MIT
#pragma once

#include <SDL.h>

namespace impetus {

/// From now on the loss of this window's X connection is noticed. Other systems are left alone.
void survive_display_loss(SDL_Window* window);

/// Whether the connection is gone. Nothing may be drawn or closed on it afterwards.
[[nodiscard]] bool display_lost();

}  // namespace impetus
