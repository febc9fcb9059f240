// `impetus screen`: the lab's screen, entered once and checked with a ruler or a bank card.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>

#include "experiments/commands/commands.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/session/input_error.hpp"

#ifdef IMPETUS_WINDOW
#include "experiments/commands/window_size.hpp"
#include "experiments/session/steady_clock.hpp"
#include "experiments/stage/screen_setup.hpp"
#endif

namespace impetus {
namespace {

struct ScreenOptions {
  double width_cm{0.0};
  double height_cm{0.0};
  double distance_cm{0.0};
  std::string file;
  std::string window_size;
};

ScreenGeometry ask_in_window(const ScreenGeometry& initial, const ScreenOptions& options) {
#ifdef IMPETUS_WINDOW
  const SteadyClock clock;
  Window window(window_options(options.window_size), clock);
  if (const auto entered = ask_screen_geometry(window, initial)) {
    return *entered;
  }
  throw InputError("the screen's size and distance were left as they were");
#else
  static_cast<void>(initial);
  static_cast<void>(options);
  throw InputError("this build has no window; give --width-cm, --height-cm and --distance-cm");
#endif
}

int screen(const ScreenOptions& options) {
  const std::filesystem::path file =
      options.file.empty() ? default_screen_file() : std::filesystem::path(options.file);
  const bool given = options.width_cm > 0.0 && options.height_cm > 0.0 && options.distance_cm > 0.0;
  ScreenGeometry geometry;
  if (given) {
    geometry.width_m = options.width_cm / 100.0;
    geometry.height_m = options.height_cm / 100.0;
    geometry.viewing_distance_m = options.distance_cm / 100.0;
  } else {
    geometry = ask_in_window(std::filesystem::exists(file) ? load_screen(file) : assumed_screen(),
                             options);
  }
  save_screen(geometry, file);
  std::printf("%.2f cm x %.2f cm seen from %.1f cm, saved in %s\n", geometry.width_m * 100.0,
              geometry.height_m * 100.0, geometry.viewing_distance_m * 100.0, file.c_str());
  return kDone;
}

}  // namespace

void add_screen(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<ScreenOptions>();
  CLI::App* command =
      app.add_subcommand("screen", "Enter the screen's size and distance, once per lab");
  command->add_option("--width-cm", options->width_cm, "Width of the visible picture")
      ->check(CLI::Range(10.0, 300.0));
  command->add_option("--height-cm", options->height_cm, "Height of the visible picture")
      ->check(CLI::Range(10.0, 200.0));
  command->add_option("--distance-cm", options->distance_cm, "From the eye to the screen")
      ->check(CLI::Range(20.0, 300.0));
  command->add_option("--file", options->file, "Where to keep it instead of the user's settings");
  command->add_option("--window", options->window_size, "WIDTHxHEIGHT instead of fullscreen");
  command->callback([options, &chosen] { chosen = [options] { return screen(*options); }; });
}

}  // namespace impetus
