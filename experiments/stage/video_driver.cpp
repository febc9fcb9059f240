// SPDX-License-Identifier: MIT
#include "experiments/stage/video_driver.hpp"

#include <SDL.h>

#include <stdexcept>

namespace impetus {

void open_video() {
  if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) {
    refuse_display(SDL_GetError());
  }
  // Where there is no display SDL falls back on one that nobody sees; it must have been asked for.
  const std::string driver = SDL_GetCurrentVideoDriver();
  if (driver == "offscreen" && SDL_getenv("SDL_VIDEODRIVER") == nullptr) {
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    refuse_display("neither X11 nor Wayland answered");
  }
}

void refuse_display(const std::string& why) {
  throw std::runtime_error("no display could be opened: " + why +
                           "; run with --observer to go on without a window");
}

}  // namespace impetus
