// SPDX-License-Identifier: MIT
#include "experiments/window/display.hpp"

#include <SDL.h>
#ifdef IMPETUS_HAS_X11
#include <SDL_syswm.h>
#include <X11/Xlib.h>
#endif

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace impetus::inline window {
namespace {

/// Thrown when the connection is found to be gone.
struct DisplayLost {};

std::atomic<bool> lost{false};
thread_local int expecting = 0;  // depth of while_display_lasts() on this thread

/// While it lives, somebody expects the loss.
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

void open_video() {
  const bool chosen = SDL_getenv("SDL_VIDEODRIVER") != nullptr;
  if (!chosen && SDL_getenv("WAYLAND_DISPLAY") == nullptr) {
    // Asked for nothing, Wayland's library complains on its own; and where there is no display SDL
    // would fall back on one that nobody sees.
    SDL_SetHint(SDL_HINT_VIDEODRIVER, "x11,KMSDRM");
  }
  if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) {
    refuse_display(chosen ? SDL_GetError() : "neither X11 nor Wayland answered");
  }
  const std::string driver = SDL_GetCurrentVideoDriver();
  if (!chosen && driver == "offscreen") {
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    refuse_display("neither X11 nor Wayland answered");
  }
}

void open_unseen_video() {
  const bool wayland = SDL_getenv("WAYLAND_DISPLAY") != nullptr;
  // SDL would take Ctrl-C for a window that is closed, of which there is none.
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
  SDL_SetHint(SDL_HINT_VIDEODRIVER, wayland ? "wayland,x11,offscreen" : "x11,offscreen");
  if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) {
    throw std::runtime_error(std::string("no picture can be drawn: ") + SDL_GetError());
  }
}

void refuse_display(const std::string& why) {
  throw std::runtime_error("no display could be opened: " + why);
}

DisplayMode display_mode() {
  constexpr double kAssumedHz = 60.0;
  open_video();
  SDL_DisplayMode mode{};
  const bool known = SDL_GetCurrentDisplayMode(0, &mode) == 0 && mode.refresh_rate > 0;
  SDL_QuitSubSystem(SDL_INIT_VIDEO);
  return {known ? mode.refresh_rate : kAssumedHz, mode.w, mode.h};
}

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
