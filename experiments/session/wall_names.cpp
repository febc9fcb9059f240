// SPDX-License-Identifier: MIT
#include "experiments/session/wall_names.hpp"

#include <array>

#include "engine/scheduling/priority.hpp"
#include "engine/volumes/closed_cube.hpp"

namespace impetus {
namespace {

constexpr std::array<const char*, kWallCount> kSides{"+x", "-x", "+y", "-y", "+z", "-z"};

}  // namespace

std::string wall_name(std::int32_t wall) {
  return kWallPrefix + std::string(kSides.at(static_cast<std::size_t>(kEnclosure - wall)));
}

std::optional<std::int32_t> wall_named(const std::string& name) {
  for (int wall = 0; wall < kWallCount; ++wall) {
    if (name == wall_name(wall_index(wall))) {
      return wall_index(wall);
    }
  }
  return std::nullopt;
}

}  // namespace impetus
