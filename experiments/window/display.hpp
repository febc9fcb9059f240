// The display: opened only where somebody can see it, asked what it is, and lost in order.
//
// When the display server dies, the session ends in order instead of in Xlib's exit():
//
//   Xlib finds the connection broken ─> our handler throws ─> while_display_lasts() catches
//
// Xlib's handler must not return, and what called it (SDL, OpenGL) does not expect it to. Unwinding
// leaves their locks held, so nothing of theirs may be called afterwards: display_lost() says so.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

struct SDL_Window;

namespace impetus::inline window {

/// Opens SDL's video once more; every call needs its SDL_QuitSubSystem(SDL_INIT_VIDEO). Throws
/// std::runtime_error with one sentence when there is no display.
void open_video();

/// The same without anybody to see it: with the display where there is one, without it elsewhere.
void open_unseen_video();

/// Throws the sentence that says so.
[[noreturn]] void refuse_display(const std::string& why);

/// How the display is driven.
struct DisplayMode {
  double refresh_hz{0.0};  ///< nominal; 60 when it does not say
  int width_px{0};
  int height_px{0};
};

/// Throws std::runtime_error with one sentence when there is no display.
DisplayMode display_mode();

/// From now on the loss of this window's X connection is noticed. Other systems are left alone.
void survive_display_loss(SDL_Window* window);

/// Does what may need the display; leaves it half done, and does nothing at all afterwards, when
/// the display is lost. A loss anywhere else ends the program with status 2 and one sentence.
void while_display_lasts(const std::function<void()>& doing);

/// Whether the connection is gone.
[[nodiscard]] bool display_lost();

}  // namespace impetus::inline window
