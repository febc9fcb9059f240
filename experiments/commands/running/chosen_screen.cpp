// SPDX-License-Identifier: MIT
#include "experiments/commands/running/chosen_screen.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "experiments/protocol/screen_file.hpp"
#ifdef IMPETUS_WINDOW
#include "experiments/commands/window_size.hpp"
#endif

namespace impetus::inline commands {
namespace {

/// None where none was entered.
std::optional<std::filesystem::path> screen_file(const std::string& file) {
  if (!file.empty()) {
    return file;
  }
  const bool entered = std::filesystem::exists(default_screen_file());
  return entered ? std::optional(default_screen_file()) : std::nullopt;
}

ScreenGeometry without_pixels(ScreenGeometry screen) {
  screen.width_px = screen.height_px = 0;
  return screen;
}

ScreenGeometry told(const ScreenGeometry& assumed) {
  std::fprintf(
      stderr,
      "No screen was entered: %.1f cm x %.1f cm seen from %.0f cm is assumed; `impetus screen` "
      "asks.\n",
      assumed.width_m * 100.0, assumed.height_m * 100.0, assumed.viewing_distance_m * 100.0);
  return without_pixels(assumed);
}

}  // namespace

ScreenGeometry chosen_screen(const std::string& file) {
  const auto entered = screen_file(file);
  return entered ? load_screen(*entered).geometry : told(assumed_screen());
}

#ifdef IMPETUS_WINDOW
ScreenGeometry chosen_screen(const std::string& file, const WindowOptions& window) {
  const auto entered = screen_file(file);
  if (entered) {
    load_screen(*entered);  // what is wrong with it needs no display to be told
  }
  const DisplayMode shown = shown_mode(window);
  return entered ? without_pixels(load_screen_of(*entered, shown.width_px, shown.height_px))
                 : told(assumed_screen(shown.width_px, shown.height_px));
}
#endif

ScreenGeometry screen_without_window(const std::string& file) {
  const ScreenGeometry assumed = assumed_screen();
  if (file.empty()) {
    return assumed;
  }
  const ScreenGeometry entered = load_screen(file).geometry;
  const double px_per_m = assumed.height_px / entered.height_m;
  return load_screen_of(file, static_cast<int>(std::lround(px_per_m * entered.width_m)),
                        assumed.height_px);
}

std::optional<ScreenLight> chosen_light(const std::string& file) {
  const auto entered = screen_file(file);
  return entered ? load_screen(*entered).light : std::nullopt;
}

}  // namespace impetus::inline commands
