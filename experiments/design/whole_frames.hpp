// Durations as frames of a display.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

namespace impetus::inline design {

/// The frames that cover a duration; whole for every duration that a protocol's check passed.
inline std::int64_t whole_frames(double duration_s, double refresh_hz) {
  constexpr double kOfAFrame = 1e-6;  // what rounding may make of a whole number
  return static_cast<std::int64_t>(std::ceil(duration_s * refresh_hz - kOfAFrame));
}

}  // namespace impetus::inline design
