// `impetus preview`: a scene runs in a window, beside a panel that changes its schedule; or one
// moment of it becomes a picture, or its first collision, level by level.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/files/scene_files.hpp"
#include "experiments/protocol/checked_scene.hpp"

#ifdef IMPETUS_WINDOW
#include "experiments/commands/new_file.hpp"
#include "experiments/commands/running/chosen_screen.hpp"
#include "experiments/commands/shipped_file.hpp"
#include "experiments/commands/window_size.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/run/level_collision.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/tables/number_text.hpp"
#include "experiments/viewers/collision_strip.hpp"
#include "experiments/viewers/preview_view.hpp"
#include "experiments/viewers/still_picture.hpp"
#endif

namespace impetus::inline commands {
namespace {

/// What `impetus preview` was asked for.
struct PreviewOptions {
  std::string scene;
  std::string screen_file;
  std::string window_size;
  std::string strip;
  std::string picture;
  double at_s{0.0};
  int width_px{0};
  int height_px{0};
};

#ifdef IMPETUS_WINDOW

void write_strip(const JsonDocument& scene, const PreviewOptions& options) {
  const PictureSize size{picture_px("--width", options.width_px, 480),
                         picture_px("--height", options.height_px, 360)};
  ShapeLibrary shapes;
  const StagedScene staged =
      build_scene(scene.value, chosen_screen(options.screen_file), kUnroundedHold, shapes);
  try {
    const CollisionByLevel collision = collision_by_level(staged);
    write_png(strip_of(collision, staged, size), options.strip);
    std::printf("written to %s, levels 0 to %zu\n", options.strip.c_str(),
                collision.levels.size() - 1);
  } catch (const InputError& error) {
    throw InputError(scene.name + ": " + error.what());
  }
}

void print_luminance(const ScreenLight& light, const Pixels& picture) {
  double darkest = light.white_cd_m2;
  double brightest = light.black_cd_m2;
  double sum = 0.0;
  for (std::size_t at = 0; at + 2 < picture.rgb.size(); at += 3) {
    const auto value = [&](std::size_t primary) {
      return static_cast<float>(picture.rgb[at + primary]) / 255.0F;
    };
    const double here = luminance_cd_m2(light, {value(0), value(1), value(2)});
    darkest = std::min(darkest, here);
    brightest = std::max(brightest, here);
    sum += here;
  }
  std::printf("on this screen from %.4g to %.4g cd/m², %.4g on average\n", darkest, brightest,
              3.0 * sum / static_cast<double>(picture.rgb.size()));
}

void write_picture(const JsonDocument& scene, const PreviewOptions& options) {
  const ScreenGeometry screen = chosen_screen(options.screen_file);
  const PictureSize size = picture_size(options.width_px, options.height_px, screen);
  ShapeLibrary shapes;
  StagedScene staged = build_scene(scene.value, screen, kUnroundedHold, shapes);
  if (!(options.at_s >= 0.0 && options.at_s <= staged.duration_s)) {
    throw InputError(printed("--at: expected from 0 to the %g s that the scene lasts, got %g",
                             staged.duration_s, options.at_s));
  }
  const SteadyClock clock;
  const Pixels picture = still_picture(std::move(staged), options.at_s, size, clock);
  write_png(picture, options.picture);
  std::printf("written to %s\n", options.picture.c_str());
  if (const auto light = chosen_light(options.screen_file)) {
    print_luminance(*light, picture);
  }
}

/// What takes long, before a window opens.
void build_shapes(const nlohmann::json& scene, const ScreenGeometry& screen, ShapeLibrary& shapes) {
  ProgressLine line("building the bodies");
  shapes.tell([&line](double share) { line.tell(share); });
  static_cast<void>(build_scene(scene, screen, kUnroundedHold, shapes));
  shapes.tell({});
}

void tell(const PreviewFrames& frames) {
  if (frames.taken_s > 0.0) {
    std::printf("%lld frames in %.1f s, %.1f a second\n", static_cast<long long>(frames.shown),
                frames.taken_s, static_cast<double>(frames.shown) / frames.taken_s);
  }
}

void show(const JsonDocument& scene, const PreviewOptions& options) {
  require_new_pictures({{"--picture", options.picture}, {"--strip", options.strip}});
  if (!options.strip.empty()) {
    write_strip(scene, options);
    return;
  }
  if (!options.picture.empty()) {
    write_picture(scene, options);
    return;
  }
  require_picture_of_size(options.width_px, options.height_px, "--picture or --strip");
  const WindowOptions asked = window_options(options.window_size);
  const ScreenGeometry screen = chosen_screen(options.screen_file, asked);
  ShapeLibrary shapes;
  build_shapes(scene.value, screen, shapes);
  const SteadyClock clock;
  Window window(asked, clock);
  window.set_geometry(screen);
  tell(view_preview(window, build_scene(scene.value, window.geometry(), kUnroundedHold, shapes),
                    clock));
}

#else

void show(const JsonDocument& scene, const PreviewOptions& /*options*/) {
  throw InputError("this build has no window; " + scene.name + " can be checked, but not shown");
}

#endif

/// A region that follows a recording needs a session, which knows whose.
void require_no_recording(const JsonDocument& scene) {
  const nlohmann::json::json_pointer kind("/engine/region/kind");
  if (scene.value.contains(kind) && scene.value[kind] == nlohmann::json("recorded")) {
    refuse(scene, kind.to_string(),
           "expected a region that can be previewed, which \"recorded\" is not: only a session "
           "has a recording");
  }
}

int preview(const PreviewOptions& options) {
  const BuildingLine told;
  const JsonDocument scene = load_scene(options.scene);
  require_no_recording(scene);
  return staged_from(scene, [&] {
    show(scene, options);
    return kDone;
  });
}

}  // namespace

void add_preview(CLI::App& app, Command& chosen) {
  const auto [command, options] =
      add_command<PreviewOptions>(app, chosen, preview, "preview",
                                  "Run a scene in a window, and change its schedule while it runs");
  command->add_option("scene", options->scene, "Scene file")
      ->required()
      ->transform([](const std::string& name) { return shipped_file(name); });
  command->add_option("--screen", options->screen_file,
                      "Screen file instead of the user's settings");
  command->add_option("--window", options->window_size, "WIDTHxHEIGHT instead of fullscreen");
  command
      ->add_option("--strip", options->strip,
                   "Write a picture of the first collision at each level instead")
      ->excludes("--window");
  command
      ->add_option("--picture", options->picture,
                   "Write a picture of one moment instead, as a participant sees it")
      ->excludes("--strip")
      ->excludes("--window");
  command
      ->add_option("--at", options->at_s, "That moment, in seconds from the onset; 0 if left out")
      ->needs("--picture");
  command->add_option("--width", options->width_px,
                      "Of the picture, or each in the strip, in pixels");
  command->add_option("--height", options->height_px, "The same");
}

}  // namespace impetus::inline commands
