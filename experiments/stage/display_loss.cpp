// SPDX-License-Identifier: MIT
#include "experiments/stage/display_loss.hpp"

#include <atomic>
#include <cstdio>

#ifdef IMPETUS_HAS_X11
#include <SDL_syswm.h>
#include <X11/Xlib.h>
#endif

namespace impetus {
namespace {

std::atomic<bool> lost{false};

#ifdef IMPETUS_HAS_X11
// Xlib allows this one to return; it then answers every later request with nothing.
void note_loss(Display* /*connection*/, void* /*unused*/) {
  if (!lost.exchange(true)) {
    std::fputs("the display closed\n", stderr);
  }
}
#endif

}  // namespace

void survive_display_loss(SDL_Window* window) {
  lost = false;
#ifdef IMPETUS_HAS_X11
  SDL_SysWMinfo system;
  SDL_VERSION(&system.version);
  if (SDL_GetWindowWMInfo(window, &system) == SDL_TRUE && system.subsystem == SDL_SYSWM_X11) {
    XSetIOErrorExitHandler(system.info.x11.display, note_loss, nullptr);
  }
#else
  static_cast<void>(window);
#endif
}

bool display_lost() { return lost; }

}  // namespace impetus
