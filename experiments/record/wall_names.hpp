// The enclosure's walls by name, as collisions are recorded with them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/volumes/enclosure.hpp"

namespace impetus::inline record {

/// What a wall's name begins with; no body's name does.
inline constexpr const char* kWallPrefix = "wall ";

/// What walls are named by: axes, or how the viewer sees them.
enum class WallNaming { kAxes, kView };

WallNaming wall_naming(const std::optional<Enclosure>& enclosure);

/// "wall +x", "wall -x", ..., or "wall right", "wall left", "wall above", "wall below", "wall
/// near", "wall far"; `wall` as in BodyPair::b, is_wall(wall).
std::string wall_name(std::int32_t wall, WallNaming naming = WallNaming::kAxes);

/// A body of these names, or a wall, as in BodyPair.
std::string body_or_wall_name(std::int32_t body, const std::vector<std::string>& bodies,
                              WallNaming walls);

/// The wall called `name`, if it is one's.
std::optional<std::int32_t> wall_named(const std::string& name);

}  // namespace impetus::inline record
