// Whether every frame that was shown was the planned one, by the code on its photodiode patch.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace impetus::inline timing {

/// What one frame's patch was to show, and what the window system held after its flip.
struct PatchSighting {
  std::int64_t planned{0};
  std::optional<std::int64_t> seen{};  ///< none: it was no code, or could not be read
};

struct ContentCheck {
  std::int64_t frames{0};
  std::int64_t wrong{0};          ///< that showed another code than planned
  std::int64_t unreadable{0};     ///< of which nothing is known
  std::int64_t first_wrong{-1};   ///< number of the first wrong frame; −1: none
  std::int64_t longest_wrong{0};  ///< most wrong frames in a row
  [[nodiscard]] bool all_as_planned() const { return frames > 0 && wrong + unreadable == 0; }
};

/// The frames in the order they were shown.
ContentCheck check_content(const std::vector<PatchSighting>& frames);

}  // namespace impetus::inline timing
