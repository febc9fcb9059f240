// `impetus screen`: the lab's screen, entered once and checked with a ruler or a bank card.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <optional>

#include "experiments/commands/commands.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/settings/input_error.hpp"

#ifdef IMPETUS_WINDOW
#include "experiments/commands/window_size.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/tables/number_text.hpp"
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
  std::optional<double> black_cd_m2;
  std::optional<double> white_cd_m2;
  std::optional<double> gamma;
  std::string file;
  std::string window_size;
};

LabScreen ask_in_window(std::optional<LabScreen> initial, const std::string& window_size) {
#ifdef IMPETUS_WINDOW
  const SteadyClock clock;
  Window window(window_options(window_size), clock);
  if (!initial) {
    initial = {assumed_screen(window.width_px(), window.height_px())};
  }
  if (const auto entered = ask_screen(window, *initial)) {
    return *entered;
  }
  throw InputError("the screen's size and distance were left as they were");
#else
  static_cast<void>(initial);
  static_cast<void>(window_size);
  throw InputError("this build has no window; give --width-cm, --height-cm and --distance-cm");
#endif
}

/// What was measured of the screen's light; none: nothing was given. Throws InputError.
std::optional<ScreenLight> given_light(const ScreenOptions& options) {
  if (!options.white_cd_m2) {
    return std::nullopt;
  }
  if (*options.white_cd_m2 <= *options.black_cd_m2) {
    throw InputError(printed("--white-cd-m2: expected more than black, %g cd/m², got %g",
                             *options.black_cd_m2, *options.white_cd_m2));
  }
  return ScreenLight{*options.black_cd_m2, *options.white_cd_m2, *options.gamma};
}

LabScreen given_size(const ScreenOptions& options) {
  LabScreen lab;
  lab.geometry.width_m = options.width_cm / 100.0;
  lab.geometry.height_m = options.height_cm / 100.0;
  lab.geometry.viewing_distance_m = options.distance_cm / 100.0;
  lab.square_pixels = !options.pixels_not_square;
  return lab;
}

/// Of light alone, the size stays; of a size alone, the light.
LabScreen entered_screen(const std::filesystem::path& file, const ScreenOptions& options) {
  const bool sized = options.width_cm > 0.0 && options.height_cm > 0.0 && options.distance_cm > 0.0;
  const std::optional<ScreenLight> light = given_light(options);
  std::optional<LabScreen> before;
  if (std::filesystem::exists(file)) {
    before = load_screen(file);
  }
  LabScreen lab = sized             ? given_size(options)
                  : light && before ? *before
                                    : ask_in_window(before, options.window_size);
  lab.light = light ? light : before ? before->light : std::nullopt;
  return lab;
}

void print_light(const ScreenLight& light) {
  constexpr float kGround = 128.0F / 255.0F;  // as a screen shows the painters' mid-grey
  std::printf("%s: the ground of pages and stimuli has %.1f cd/m²\n", light_words(light).c_str(),
              luminance_cd_m2(light, {kGround, kGround, kGround}));
}

int screen(const ScreenOptions& options) {
  const std::filesystem::path file =
      options.file.empty() ? default_screen_file() : std::filesystem::path(options.file);
  const LabScreen lab = entered_screen(file, options);
  save_screen(lab, file);
  const ScreenGeometry& size = lab.geometry;
  std::printf("%.2f cm x %.2f cm seen from %.1f cm%s, saved in %s\n", size.width_m * 100.0,
              size.height_m * 100.0, size.viewing_distance_m * 100.0,
              lab.square_pixels ? "" : ", of pixels that are not square", file.c_str());
  if (lab.light) {
    print_light(*lab.light);
  }
  return kDone;
}

}  // namespace

void add_screen(CLI::App& app, Command& chosen) {
  const auto [command, options] =
      add_command<ScreenOptions>(app, chosen, screen, "screen",
                                 "Enter the screen's size and distance, and what a photometer "
                                 "says of its light, once per lab");
  command->add_option("--width-cm", options->width_cm, "Width of the visible picture")
      ->check(number_from(10.0, 300.0));
  command->add_option("--height-cm", options->height_cm, "Height of the visible picture")
      ->check(number_from(10.0, 200.0));
  command->add_option("--distance-cm", options->distance_cm, "From the eye to the screen")
      ->check(number_from(20.0, 300.0));
  command->add_flag("--pixels-not-square", options->pixels_not_square,
                    "Keep with these numbers that this screen's pixels really are not square");
  CLI::Option* black = command->add_option("--black-cd-m2", options->black_cd_m2,
                                           "Luminance of black, where it was measured");
  CLI::Option* white =
      command->add_option("--white-cd-m2", options->white_cd_m2, "Luminance of white");
  CLI::Option* gamma = command->add_option("--gamma", options->gamma,
                                           "Exponent of the greys between: 2.2 on most screens");
  black->check(number_from(0.0, 1000.0))->needs(white)->needs(gamma);
  white->check(number_from(0.001, 10000.0))->needs(black)->needs(gamma);
  gamma->check(number_from(0.5, 5.0))->needs(black)->needs(white);
  command->add_option("--file", options->file, "Where to keep it instead of the user's settings");
  command->add_option("--window", options->window_size,
                      "WIDTHxHEIGHT instead of fullscreen: measure this window");
}

}  // namespace impetus::inline commands
