// Pictures as PNG files.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace impetus::inline window {

/// Three bytes (red, green, blue; sRGB) a pixel, row by row from the top.
struct Pixels {
  int width{0};
  int height{0};
  std::vector<std::uint8_t> rgb;
};

/// Pictures of one height, from left to right.
Pixels beside_each_other(const std::vector<Pixels>& pictures);

/// Pictures of one width, from the top down.
Pixels below_each_other(const std::vector<Pixels>& pictures);

/// Writes the file or replaces it. Throws std::runtime_error, in one sentence that names it, when
/// it cannot be written.
void write_png(const Pixels& pixels, const std::string& file);

}  // namespace impetus::inline window
