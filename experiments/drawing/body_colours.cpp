// SPDX-License-Identifier: MIT
#include "experiments/drawing/body_colours.hpp"

#include <algorithm>

namespace impetus::inline drawing {
namespace {

constexpr float kPaleShare = 0.65F;
constexpr BodyColour kPaleGrey{0.62F, 0.62F, 0.62F};
constexpr float kTintShare = 0.85F;

/// Even in lightness for any eye, from the coarsest level on (viridis, Smith and van der Walt
/// 2015).
constexpr std::array<BodyColour, 5> kLevelStops{{{0.27F, 0.00F, 0.33F},
                                                 {0.23F, 0.32F, 0.55F},
                                                 {0.13F, 0.57F, 0.55F},
                                                 {0.37F, 0.79F, 0.38F},
                                                 {0.99F, 0.91F, 0.14F}}};

BodyColour mixed(const BodyColour& from, const BodyColour& to, float share) {
  BodyColour result{};
  for (std::size_t channel = 0; channel < result.size(); ++channel) {
    result[channel] = from[channel] + share * (to[channel] - from[channel]);
  }
  return result;
}

}  // namespace

BodyColours next_colours(BodyColours colours) {
  return colours == BodyColours::kOwn        ? BodyColours::kPriority
         : colours == BodyColours::kPriority ? BodyColours::kLevel
                                             : BodyColours::kOwn;
}

BodyColour colour_of_list(int list) {
  constexpr BodyColour kHigh{0.86F, 0.10F, 0.08F};
  constexpr BodyColour kLow{0.08F, 0.28F, 0.88F};
  return list == 0 ? kHigh : kLow;
}

BodyColour colour_of_level(int level, int finest) {
  const float share =
      finest > 0 ? static_cast<float>(std::clamp(level, 0, finest)) / static_cast<float>(finest)
                 : 1.0F;
  const float place = share * static_cast<float>(kLevelStops.size() - 1);
  const auto stop = std::min(static_cast<std::size_t>(place), kLevelStops.size() - 2);
  return mixed(kLevelStops[stop], kLevelStops[stop + 1], place - static_cast<float>(stop));
}

void colour_bodies(std::vector<PosedBody>& bodies, const std::vector<BodyDetail>& details,
                   BodyColours colours, int finest) {
  if (colours == BodyColours::kOwn) {
    return;
  }
  const bool by_level = colours == BodyColours::kLevel;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    BodyColour& look = bodies[body].look.colour;
    const int value = by_level ? details[body].level : details[body].list;
    look = value < 0  ? mixed(look, kPaleGrey, kPaleShare)
           : by_level ? mixed(look, colour_of_level(value, finest), kTintShare)
                      : mixed(look, colour_of_list(value), kTintShare);
  }
}

std::vector<ColourMeaning> meanings_of(BodyColours colours, int finest) {
  std::vector<ColourMeaning> meanings;
  if (colours == BodyColours::kPriority) {
    meanings = {{colour_of_list(0), "high priority"},
                {colour_of_list(1), "low priority"},
                {kPaleGrey, "pale: apart"}};
  } else if (colours == BodyColours::kLevel) {
    for (int level = 0; level <= finest; ++level) {
      meanings.push_back({colour_of_level(level, finest), "level " + std::to_string(level)});
    }
    meanings.front().meaning += ", coarsest";
    meanings.back().meaning = "level " + std::to_string(finest) + ", finest";
    meanings.push_back({kPaleGrey, "pale: apart"});
  }
  return meanings;
}

}  // namespace impetus::inline drawing
