// SPDX-License-Identifier: MIT
#include "experiments/commands/chosen_screen.hpp"

#include <cstdio>
#include <filesystem>

#include "experiments/protocol/screen_file.hpp"

namespace impetus {

ScreenGeometry chosen_screen(const std::string& file) {
  if (!file.empty()) {
    return load_screen(file);
  }
  if (std::filesystem::exists(default_screen_file())) {
    return load_screen(default_screen_file());
  }
  ScreenGeometry screen = assumed_screen();
  std::fprintf(
      stderr,
      "No screen was entered: %.1f cm x %.1f cm seen from %.0f cm is assumed; `impetus screen` "
      "asks.\n",
      screen.width_m * 100.0, screen.height_m * 100.0, screen.viewing_distance_m * 100.0);
  screen.width_px = screen.height_px = 0;
  return screen;
}

}  // namespace impetus
