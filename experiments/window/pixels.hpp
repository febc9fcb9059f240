// Pictures as pixels: read from where they were drawn, put together, written as PNG files.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/drawing/picture_map.hpp"
#include "experiments/drawing/gl_parts.hpp"
#include "experiments/window/window.hpp"

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

/// The size of a picture that goes to a file.
struct PictureSize {
  int width_px{1200};
  int height_px{1200};
};

inline constexpr int kLargestPicturePx = 8192;

/// A window of this size that nobody sees and that needs no display.
WindowOptions unseen_window(const PictureSize& size);

/// Where a picture is drawn without a window to be seen, to be read when it is done.
class ReadableTarget {
 public:
  /// Needs a current OpenGL 3.3 context, now and for every call.
  explicit ReadableTarget(const PictureSize& size);

  /// OpenGL's name of it, to draw onto.
  [[nodiscard]] unsigned framebuffer() const { return framebuffer_; }

  /// What follows is drawn here, until another target is chosen.
  void draw_here() const;

  [[nodiscard]] Pixels read() const;

 private:
  PictureSize size_;
  GlName framebuffer_{GlName::Kind::kFramebuffer};
  GlName colour_{GlName::Kind::kRenderbuffer};
};

/// What is drawn on this area of the window now, before its flip. Needs a current OpenGL 3.3
/// context.
Pixels window_pixels(const PixelArea& area);

}  // namespace impetus::inline window
