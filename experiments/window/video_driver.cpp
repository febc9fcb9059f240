// SPDX-License-Identifier: MIT
#include "experiments/window/video_driver.hpp"

#include <SDL.h>

#include <stdexcept>

namespace impetus::inline window {

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
  SDL_SetHint(SDL_HINT_VIDEODRIVER, wayland ? "wayland,x11,offscreen" : "x11,offscreen");
  if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) {
    throw std::runtime_error(std::string("no picture can be drawn: ") + SDL_GetError());
  }
}

void refuse_display(const std::string& why) {
  throw std::runtime_error("no display could be opened: " + why);
}

}  // namespace impetus::inline window
