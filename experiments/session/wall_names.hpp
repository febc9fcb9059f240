// The enclosure's walls by name, as collisions are recorded with them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace impetus {

/// What a wall's name begins with; no body's name does.
inline constexpr const char* kWallPrefix = "wall ";

/// "wall +x", "wall -x", ...; `wall` as in BodyPair::b, is_wall(wall).
std::string wall_name(std::int32_t wall);

/// The wall called `name`, if it is one's.
std::optional<std::int32_t> wall_named(const std::string& name);

}  // namespace impetus
