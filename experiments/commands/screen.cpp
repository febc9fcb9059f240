// `impetus screen`: the lab's screen, entered once and checked with a ruler or a bank card.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "experiments/commands/commands.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/settings/input_error.hpp"

#ifdef IMPETUS_WINDOW
#include "experiments/commands/window_size.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/viewers/screen_setup.hpp"
#endif

namespace impetus::inline commands {
namespace {

/// What `impetus screen` was asked for.
struct ScreenOptions {
  double width_cm{0.0};
  double height_cm{0.0};
  double distance_cm{0.0};
  bool pixels_not_square{false};
  std::string file;
  std::string window_size;
};

LabScreen ask_in_window(const std::filesystem::path& file, const ScreenOptions& options) {
#ifdef IMPETUS_WINDOW
  std::optional<LabScreen> initial;
  if (std::filesystem::exists(file)) {
    initial = load_screen(file);
  }
  const SteadyClock clock;
  Window window(window_options(options.window_size), clock);
  if (!initial) {
    initial = {assumed_screen(window.width_px(), window.height_px())};
  }
  if (const auto entered = ask_screen(window, *initial)) {
    return *entered;
  }
  throw InputError("the screen's size and distance were left as they were");
#else
  static_cast<void>(file);
  static_cast<void>(options);
  throw InputError("this build has no window; give --width-cm, --height-cm and --distance-cm");
#endif
}

int screen(const ScreenOptions& options) {
  const std::filesystem::path file =
      options.file.empty() ? default_screen_file() : std::filesystem::path(options.file);
  const bool given = options.width_cm > 0.0 && options.height_cm > 0.0 && options.distance_cm > 0.0;
  LabScreen lab;
  if (given) {
    lab.geometry.width_m = options.width_cm / 100.0;
    lab.geometry.height_m = options.height_cm / 100.0;
    lab.geometry.viewing_distance_m = options.distance_cm / 100.0;
    lab.square_pixels = !options.pixels_not_square;
  } else {
    lab = ask_in_window(file, options);
  }
  save_screen(lab, file);
  const ScreenGeometry& size = lab.geometry;
  std::printf("%.2f cm x %.2f cm seen from %.1f cm%s, saved in %s\n", size.width_m * 100.0,
              size.height_m * 100.0, size.viewing_distance_m * 100.0,
              lab.square_pixels ? "" : ", of pixels that are not square", file.c_str());
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
  command->add_flag("--pixels-not-square", options->pixels_not_square,
                    "Keep with these numbers that this screen's pixels really are not square");
  command->add_option("--file", options->file, "Where to keep it instead of the user's settings");
  command->add_option("--window", options->window_size, "WIDTHxHEIGHT instead of fullscreen");
  command->callback([options, &chosen] { chosen = [options] { return screen(*options); }; });
}

}  // namespace impetus::inline commands
