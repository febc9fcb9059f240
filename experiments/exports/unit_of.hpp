// The unit that a column's name states.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace impetus::inline exports {

/// "ms" of "delay_ms", "deg/s" of "speed_deg_s"; "" when the name states none.
std::string unit_of(std::string_view column);

}  // namespace impetus::inline exports
