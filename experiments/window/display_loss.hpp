// What happens when the display server dies: the session ends in order instead of in Xlib's exit().
//
//   Xlib finds the connection broken ─> our handler throws ─> while_display_lasts() catches
//
// Xlib's handler must not return, and what called it (SDL, OpenGL) does not expect it to. Unwinding
// leaves their locks held, so nothing of theirs may be called afterwards: display_lost() says so.
// SPDX-License-Identifier: MIT
#pragma once

#include <SDL.h>

#include <functional>

namespace impetus::inline window {

/// From now on the loss of this window's X connection is noticed. Other systems are left alone.
void survive_display_loss(SDL_Window* window);

/// Does what may need the display; leaves it half done, and does nothing at all afterwards, when
/// the display is lost. A loss anywhere else ends the program with status 2 and one sentence.
void while_display_lasts(const std::function<void()>& doing);

/// Whether the connection is gone.
[[nodiscard]] bool display_lost();

}  // namespace impetus::inline window
