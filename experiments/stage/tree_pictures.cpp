// SPDX-License-Identifier: MIT
#include "experiments/stage/tree_pictures.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>

#include "experiments/stage/gl_window.hpp"
#include "experiments/stage/tree_painter.hpp"

namespace impetus {
namespace {

constexpr float kWhite = 1.0F;

/// A target that can be read when it is done.
class ReadableTarget {
 public:
  explicit ReadableTarget(const PictureSize& size) : size_(size) {
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(1, &colour_);
    glBindRenderbuffer(GL_RENDERBUFFER, colour_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.width_px, size.height_px);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
  }
  ~ReadableTarget() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(1, &colour_);
  }
  ReadableTarget(const ReadableTarget&) = delete;
  ReadableTarget& operator=(const ReadableTarget&) = delete;

  [[nodiscard]] unsigned framebuffer() const { return framebuffer_; }

  [[nodiscard]] Pixels read() const {
    Pixels pixels{size_.width_px, size_.height_px, {}};
    const std::size_t row_bytes = 3 * static_cast<std::size_t>(size_.width_px);
    pixels.rgb.resize(row_bytes * static_cast<std::size_t>(size_.height_px));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (int row = 0; row < size_.height_px; ++row) {  // OpenGL counts them from the bottom
      glReadPixels(0, size_.height_px - 1 - row, size_.width_px, 1, GL_RGB, GL_UNSIGNED_BYTE,
                   pixels.rgb.data() + static_cast<std::size_t>(row) * row_bytes);
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    return pixels;
  }

 private:
  PictureSize size_;
  unsigned framebuffer_{0};
  unsigned colour_{0};
};

WindowOptions unseen() {
  WindowOptions options;
  options.fullscreen = false;
  options.seen = false;
  options.width_px = options.height_px = 64;
  return options;
}

}  // namespace

std::vector<Pixels> pictures_of(const ShownTree& shown, const std::vector<TreeLook>& looks,
                                const PictureSize& size) {
  const GlWindow window(unseen());
  TreePainter painter(shown);
  MultisampledTarget drawn;
  const ReadableTarget averaged(size);
  std::vector<Pixels> pictures;
  for (const TreeLook& look : looks) {
    drawn.begin(size.width_px, size.height_px);
    painter.paint_here(look, Orbit(), size.width_px, size.height_px, kWhite);
    drawn.end_onto({0, 0, size.width_px, size.height_px}, averaged.framebuffer());
    pictures.push_back(averaged.read());
  }
  return pictures;
}

}  // namespace impetus
