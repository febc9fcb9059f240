// SPDX-License-Identifier: MIT
#include "experiments/window/display_query.hpp"

#include <SDL.h>

#include "experiments/window/video_driver.hpp"

namespace impetus::inline window {

DisplayMode display_mode() {
  constexpr double kAssumedHz = 60.0;
  open_video();
  SDL_DisplayMode mode{};
  const bool known = SDL_GetCurrentDisplayMode(0, &mode) == 0 && mode.refresh_rate > 0;
  SDL_QuitSubSystem(SDL_INIT_VIDEO);
  return {known ? mode.refresh_rate : kAssumedHz, mode.w, mode.h};
}

}  // namespace impetus::inline window
