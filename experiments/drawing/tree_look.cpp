// SPDX-License-Identifier: MIT
#include "experiments/drawing/tree_look.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace impetus::inline drawing {
namespace {

using Colour = std::array<float, 3>;

constexpr Colour kNoGroupColour{0.62F, 0.62F, 0.62F};

/// Neighbouring levels differ in hue and in lightness.
constexpr std::array<Colour, 9> kLevelColours{{{0.31F, 0.47F, 0.65F},
                                               {0.95F, 0.56F, 0.17F},
                                               {0.35F, 0.63F, 0.31F},
                                               {0.88F, 0.34F, 0.35F},
                                               {0.14F, 0.56F, 0.58F},
                                               {0.69F, 0.48F, 0.63F},
                                               {0.93F, 0.79F, 0.28F},
                                               {0.61F, 0.46F, 0.37F},
                                               {0.73F, 0.69F, 0.67F}}};

int level_of(const VolumeTree& tree, std::int32_t node) {
  int level = 0;
  while (node >= tree.level_end(level)) {
    ++level;
  }
  return level;
}

/// From nearly empty (violet) over half (green) to solid (yellow).
Colour occupancy_colour(float occupancy) {
  constexpr std::array<Colour, 3> kStops{
      {{0.27F, 0.00F, 0.33F}, {0.13F, 0.57F, 0.55F}, {0.99F, 0.91F, 0.14F}}};
  const float place = 2.0F * std::clamp(occupancy, 0.0F, 1.0F);
  const std::size_t stop = place < 1.0F ? 0 : 1;
  const float share = place - static_cast<float>(stop);
  Colour colour{};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    colour[channel] = (1.0F - share) * kStops[stop][channel] + share * kStops[stop + 1][channel];
  }
  return colour;
}

/// Hues a golden section apart: groups with numbers near each other look different.
Colour group_colour(std::int32_t group) {
  if (group == kNoGroup) {
    return kNoGroupColour;
  }
  constexpr double kGoldenSection = 0.6180339887498949;
  const double hue = 6.0 * std::fmod(group * kGoldenSection, 1.0);
  const double value = group % 2 == 0 ? 0.92 : 0.70;
  const auto channel = [&](double centre) {
    const double apart = std::abs(std::remainder(hue - centre, 6.0));
    return static_cast<float>(value * (0.25 + 0.75 * std::clamp(2.0 - apart, 0.0, 1.0)));
  };
  return {channel(0.0), channel(2.0), channel(4.0)};
}

std::string printed(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

double diagonal_m(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d bounds;
  for (const Vector3& vertex : mesh.vertices) {
    bounds.extend(vertex);
  }
  return bounds.isEmpty() ? 0.0 : bounds.diagonal().norm();
}

}  // namespace

Colour colour_of(const VolumeTree& tree, std::int32_t node, TreeColour colour) {
  switch (colour) {
    case TreeColour::kOccupancy:
      return occupancy_colour(tree.surface(node).occupancy);
    case TreeColour::kGroup:
      return group_colour(tree.surface(node).group);
    case TreeColour::kLevel:
      break;
  }
  return kLevelColours[static_cast<std::size_t>(level_of(tree, node)) % kLevelColours.size()];
}

std::vector<ColouredVolume> volumes_of(const VolumeTree& tree, const TreeLook& look) {
  std::vector<ColouredVolume> volumes;
  for (const std::int32_t node : tree.standing_at(look.level)) {
    volumes.push_back({rounded_box(tree.volume(node)), colour_of(tree, node, look.colour)});
  }
  return volumes;
}

std::vector<LegendLine> legend_of(const ShownTree& shown, int level) {
  const double percent = 100.0 / std::max(diagonal_m(shown.mesh), 1e-300);
  if (shown.quality.empty()) {
    return {{"nodes", std::to_string(shown.tree.standing_at(level).size())},
            {"protrusion, bound", printed("%.3g %%", percent * shown.tree.fit_error_m(level))}};
  }
  const LevelQuality& quality = shown.quality[static_cast<std::size_t>(level)];
  return {{"nodes", std::to_string(quality.nodes)},
          {"protrusion, worst", printed("%.3g %%", percent * quality.worst_protrusion_m)},
          {"protrusion, mean", printed("%.3g %%", percent * quality.mean_protrusion_m)},
          {"outside volume", printed("%.3g of the mesh", quality.outside_ratio)},
          {"largest node", printed("%.3g m", quality.largest_node_m)},
          {"memory", printed("%.1f kB", static_cast<double>(quality.bytes) / 1000.0)}};
}

}  // namespace impetus::inline drawing
