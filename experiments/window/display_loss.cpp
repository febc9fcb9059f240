// SPDX-License-Identifier: MIT
#include "experiments/window/display_loss.hpp"

#include <atomic>
#include <cstdio>
#include <cstdlib>

#ifdef IMPETUS_HAS_X11
#include <SDL_syswm.h>
#include <X11/Xlib.h>
#endif

namespace impetus::inline window {
namespace {

struct DisplayLost {};

std::atomic<bool> lost{false};
thread_local int expecting = 0;  // depth of while_display_lasts() on this thread

struct Expecting {
  Expecting() { ++expecting; }
  ~Expecting() { --expecting; }
};

#ifdef IMPETUS_HAS_X11

::Window watched{0};

// When the program ends, the OpenGL libraries say goodbye to the display and would fall over the
// state that we unwound from.
void skip_farewells(int status, void* /*unused*/) {
  std::fflush(nullptr);
  std::_Exit(status);
}

[[noreturn]] void leave() {
  if (!lost.exchange(true)) {
    on_exit(skip_farewells, nullptr);
  }
  if (expecting == 0) {
    std::fputs("impetus: the display closed; everything answered before is saved\n", stderr);
    std::_Exit(2);
  }
  throw DisplayLost();
}

int on_broken_connection(::Display* /*connection*/) { leave(); }

int on_refused_request(::Display* connection, XErrorEvent* error) {
  if (error->resourceid == watched) {
    leave();
  }
  char text[200] = "";
  XGetErrorText(connection, error->error_code, text, sizeof text);
  std::fprintf(stderr, "the display refused a request: %s\n", text);
  return 0;
}

#endif

}  // namespace

void survive_display_loss(SDL_Window* window) {
  lost = false;
#ifdef IMPETUS_HAS_X11
  SDL_SysWMinfo system;
  SDL_VERSION(&system.version);
  if (SDL_GetWindowWMInfo(window, &system) == SDL_TRUE && system.subsystem == SDL_SYSWM_X11) {
    watched = system.info.x11.window;
    XSetErrorHandler(on_refused_request);
    XSetIOErrorHandler(on_broken_connection);
  }
#else
  static_cast<void>(window);
#endif
}

void while_display_lasts(const std::function<void()>& doing) {
  if (lost) {
    return;
  }
  const Expecting here;
  try {
    doing();
  } catch (const DisplayLost&) {
    return;  // lost is set
  }
}

bool display_lost() { return lost; }

}  // namespace impetus::inline window
