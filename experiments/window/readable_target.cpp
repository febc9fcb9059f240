// SPDX-License-Identifier: MIT
#include "experiments/window/readable_target.hpp"

#include <epoxy/gl.h>

#include <cstddef>

namespace impetus::inline window {

WindowOptions unseen_window(const PictureSize& size) {
  WindowOptions options;
  options.fullscreen = false;
  options.seen = false;
  options.width_px = size.width_px;
  options.height_px = size.height_px;
  return options;
}

ReadableTarget::ReadableTarget(const PictureSize& size) : size_(size) {
  glGenFramebuffers(1, &framebuffer_);
  glGenRenderbuffers(1, &colour_);
  glBindRenderbuffer(GL_RENDERBUFFER, colour_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.width_px, size.height_px);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

ReadableTarget::~ReadableTarget() {
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteRenderbuffers(1, &colour_);
}

void ReadableTarget::draw_here() const { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_); }

Pixels ReadableTarget::read() const {
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

}  // namespace impetus::inline window
