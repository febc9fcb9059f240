// SPDX-License-Identifier: MIT
#include "experiments/scenes/colours_apart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace impetus::inline scenes {
namespace {

/// What gets one colour: a body, or a crowd's figure with all its parts.
struct ColouredThing {
  std::size_t first_body{0};
  std::size_t bodies{1};
  Vector3 place{Vector3::Zero()};
};

std::vector<ColouredThing> coloured_things(const Scene& scene, const StagedScene& staged) {
  std::vector<ColouredThing> things;
  const auto place = [&](std::size_t body) { return staged.world.states()[body].pose.position; };
  if (scene.figure_crowd) {
    for (const Figure& figure : staged.world.settings().figures) {
      const auto root = static_cast<std::size_t>(figure.first_part);
      things.push_back({root, static_cast<std::size_t>(figure.part_count), place(root)});
    }
    return things;
  }
  const std::size_t parts_begin =
      staged.world.settings().figures.empty() ? staged.looks.size() : scene.named_bodies().size();
  for (std::size_t body = 0; body < parts_begin; ++body) {
    things.push_back({body, 1, place(body)});
  }
  return things;
}

bool are_alike(const Colour& one, const Colour& other) {
  constexpr float kSame = 0.12F;  // in each channel
  return std::abs(one[0] - other[0]) < kSame && std::abs(one[1] - other[1]) < kSame &&
         std::abs(one[2] - other[2]) < kSame;
}

/// The colours of the things, no two alike, and where they are few the shipped scenes' own.
std::vector<Colour> palette_of(const std::vector<ColouredThing>& things,
                               const std::vector<DrawnBody>& looks) {
  constexpr std::size_t kFew = 6;
  constexpr std::array<Colour, kFew> kMore{{{0.85F, 0.51F, 0.23F},
                                            {0.23F, 0.50F, 0.77F},
                                            {0.35F, 0.64F, 0.41F},
                                            {0.71F, 0.37F, 0.65F},
                                            {0.83F, 0.71F, 0.24F},
                                            {0.29F, 0.66F, 0.66F}}};
  std::vector<Colour> palette;
  const auto add = [&](const Colour& colour) {
    if (std::none_of(palette.begin(), palette.end(),
                     [&](const Colour& known) { return are_alike(known, colour); })) {
      palette.push_back(colour);
    }
  };
  for (const ColouredThing& thing : things) {
    add(looks[thing.first_body].colour);
  }
  for (std::size_t more = 0; more < kFew && palette.size() < kFew; ++more) {
    add(kMore[more]);
  }
  return palette;
}

}  // namespace

void colour_apart(const Scene& scene, StagedScene& staged) {
  const std::vector<ColouredThing> things = coloured_things(scene, staged);
  const std::vector<Colour> palette = palette_of(things, staged.looks);
  std::vector<std::vector<Vector3>> bearers(palette.size());
  for (const ColouredThing& thing : things) {
    const auto nearest_bearer_m = [&](std::size_t colour) {
      double nearest_m = std::numeric_limits<double>::infinity();
      for (const Vector3& place : bearers[colour]) {
        nearest_m = std::min(nearest_m, (place - thing.place).norm());
      }
      return nearest_m;
    };
    std::size_t chosen = 0;
    while (!are_alike(palette[chosen], staged.looks[thing.first_body].colour)) {
      ++chosen;  // its own is in the palette, or one like it
    }
    for (std::size_t colour = 0; colour < palette.size(); ++colour) {
      if (nearest_bearer_m(colour) > nearest_bearer_m(chosen)) {
        chosen = colour;
      }
    }
    bearers[chosen].push_back(thing.place);
    for (std::size_t part = 0; part < thing.bodies; ++part) {
      staged.looks[thing.first_body + part].colour = palette[chosen];
    }
  }
}

}  // namespace impetus::inline scenes
