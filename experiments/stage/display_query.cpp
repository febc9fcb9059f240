// SPDX-License-Identifier: MIT
#include "experiments/stage/display_query.hpp"

#include <SDL.h>

#include <stdexcept>
#include <string>

namespace impetus {

double display_refresh_hz() {
  constexpr double kAssumedHz = 60.0;
  if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) {
    throw std::runtime_error(std::string("no display could be opened: ") + SDL_GetError() +
                             "; run with --observer to go on without a window");
  }
  SDL_DisplayMode mode{};
  const bool known = SDL_GetCurrentDisplayMode(0, &mode) == 0 && mode.refresh_rate > 0;
  SDL_QuitSubSystem(SDL_INIT_VIDEO);
  return known ? mode.refresh_rate : kAssumedHz;
}

}  // namespace impetus
