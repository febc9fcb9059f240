// SPDX-License-Identifier: MIT
#include "experiments/record/wall_names.hpp"

#include <array>

#include "engine/scheduling/priority.hpp"

namespace impetus::inline record {
namespace {

using Sides = std::array<const char*, kWallCount>;

constexpr Sides kAxes{"+x", "-x", "+y", "-y", "+z", "-z"};
constexpr Sides kView{"right", "left", "above", "below", "near", "far"};

}  // namespace

WallNaming wall_naming(const std::optional<Enclosure>& enclosure) {
  return view_frustum(enclosure) != nullptr ? WallNaming::kView : WallNaming::kAxes;
}

std::string wall_name(std::int32_t wall, WallNaming naming) {
  const Sides& sides = naming == WallNaming::kView ? kView : kAxes;
  return kWallPrefix + std::string(sides.at(static_cast<std::size_t>(kEnclosure - wall)));
}

std::string body_or_wall_name(std::int32_t body, const std::vector<std::string>& bodies,
                              WallNaming walls) {
  return is_wall(body) ? wall_name(body, walls) : bodies[static_cast<std::size_t>(body)];
}

std::optional<std::int32_t> wall_named(const std::string& name) {
  for (int wall = 0; wall < kWallCount; ++wall) {
    for (const WallNaming naming : {WallNaming::kAxes, WallNaming::kView}) {
      if (name == wall_name(wall_index(wall), naming)) {
        return wall_index(wall);
      }
    }
  }
  return std::nullopt;
}

}  // namespace impetus::inline record
