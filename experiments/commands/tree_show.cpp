// `impetus tree show`: a tree file in a window, or as pictures.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/models/tree_file.hpp"
#include "experiments/settings/input_error.hpp"

#ifdef IMPETUS_WINDOW
#include "experiments/commands/new_file.hpp"
#include "experiments/commands/window_size.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/viewers/tree_view.hpp"
#endif

namespace impetus::inline commands {
namespace {

/// What `impetus tree show` was asked for.
struct ShowOptions {
  std::string file;
  std::optional<int> level;
  std::string colour{"level"};
  bool no_mesh{false};
  bool no_volumes{false};
  std::string png;
  std::string strip;
  int width_px{0};
  int height_px{0};
  std::string window_size;
};

#ifdef IMPETUS_WINDOW

constexpr int kUsualPicturePx = 1200;
constexpr int kUsualStripPx = 480;

ShownTree shown_from(StoredTree stored) {
  const TreeSettings& settings = stored.settings;
  const std::string title = stored.name + " · " + name_of(settings.kind) + ", depth " +
                            std::to_string(settings.depth) + ", branching " +
                            std::to_string(settings.branching);
  return {title, std::move(stored.mesh), std::move(stored.tree), std::move(stored.quality)};
}

TreeColour colour_named(const std::string& name) {
  if (name == "level") {
    return TreeColour::kLevel;
  }
  if (name == "occupancy") {
    return TreeColour::kOccupancy;
  }
  if (name == "group") {
    return TreeColour::kGroup;
  }
  throw InputError("--colour: expected one of level, occupancy, group, got " + name);
}

TreeLook look_of(const ShowOptions& options, const VolumeTree& tree) {
  const int finest = tree.level_count() - 1;
  TreeLook look;
  look.level = options.level.value_or(finest);
  if (look.level < 0 || look.level > finest) {
    throw InputError("--level: expected a level from 0 to " + std::to_string(finest) + ", got " +
                     std::to_string(look.level));
  }
  look.colour = colour_named(options.colour);
  look.mesh = !options.no_mesh;
  look.volumes = !options.no_volumes;
  return look;
}

PictureSize size_of(const ShowOptions& options, int usual_px) {
  return {picture_px("--width", options.width_px, usual_px),
          picture_px("--height", options.height_px, usual_px)};
}

void write_pictures(const ShowOptions& options, const ShownTree& shown, const TreeLook& look) {
  if (!options.png.empty()) {
    const PictureSize size = size_of(options, kUsualPicturePx);
    write_png(pictures_of(shown, {look}, size).front(), options.png);
    std::printf("written to %s\n", options.png.c_str());
  }
  if (!options.strip.empty()) {
    std::vector<TreeLook> looks(static_cast<std::size_t>(shown.tree.level_count()), look);
    for (std::size_t level = 0; level < looks.size(); ++level) {
      looks[level].level = static_cast<int>(level);
    }
    const PictureSize size = size_of(options, kUsualStripPx);
    write_png(beside_each_other(pictures_of(shown, looks, size)), options.strip);
    std::printf("written to %s, levels 0 to %zu\n", options.strip.c_str(), looks.size() - 1);
  }
}

int show(const ShowOptions& options) {
  require_new_pictures({{"--png", options.png}, {"--strip", options.strip}});
  const ShownTree shown = shown_from(load_tree(options.file));
  const TreeLook look = look_of(options, shown.tree);
  if (!options.png.empty() || !options.strip.empty()) {
    write_pictures(options, shown, look);
    return kDone;
  }
  require_picture_of_size(options.width_px, options.height_px, "--png or --strip");
  const WindowOptions asked = window_options(options.window_size);
  const SteadyClock clock;
  Window window(asked, clock);
  view_tree(window, shown, look);
  return kDone;
}

#else

int show(const ShowOptions& options) {
  load_tree(options.file);
  throw InputError("this build has no window; " + options.file + " can be read, but not shown");
}

#endif

}  // namespace

void add_tree_show(CLI::App& tree, Command& chosen) {
  const auto [command, options] = add_command<ShowOptions>(
      tree, chosen, show, "show", "Show a tree's levels in a window, or as pictures");
  command->add_option("tree", options->file, "Tree file")->required();
  command->add_option("--level", options->level, "The level to show; the finest when left out");
  command->add_option("--colour", options->colour, "What colours mean: level, occupancy or group")
      ->capture_default_str();
  command->add_flag("--no-mesh", options->no_mesh, "The volumes alone, solid");
  command->add_flag("--no-volumes", options->no_volumes, "The mesh alone");
  command->add_option("--window", options->window_size, "WIDTHxHEIGHT instead of fullscreen");
  command->add_option("--png", options->png, "Write a picture instead")->excludes("--window");
  command
      ->add_option("--strip", options->strip,
                   "Write a picture with all levels side by side instead")
      ->excludes("--window");
  command->add_option("--width", options->width_px, "Of a picture, or of each level's, in pixels");
  command->add_option("--height", options->height_px, "The same");
}

void add_tree(CLI::App& app, Command& chosen) {
  CLI::App* tree = app.add_subcommand("tree", "Build volume trees and look at them");
  tree->require_subcommand(1);
  add_tree_build(*tree, chosen);
  add_tree_show(*tree, chosen);
}

}  // namespace impetus::inline commands
