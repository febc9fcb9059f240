// SPDX-License-Identifier: MIT
#include "experiments/window/window_pixels.hpp"

#include <epoxy/gl.h>

#include <cstddef>

namespace impetus::inline window {

Pixels window_pixels(const PixelArea& area) {
  Pixels pixels{area.width, area.height, {}};
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(area.width);
  pixels.rgb.resize(row_bytes * static_cast<std::size_t>(area.height));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glReadBuffer(GL_BACK);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  for (int row = 0; row < area.height; ++row) {  // OpenGL counts them from the bottom
    glReadPixels(area.left, area.bottom + area.height - 1 - row, area.width, 1, GL_RGB,
                 GL_UNSIGNED_BYTE, pixels.rgb.data() + static_cast<std::size_t>(row) * row_bytes);
  }
  return pixels;
}

}  // namespace impetus::inline window
