// SPDX-License-Identifier: MIT
#include "experiments/drawing/multisampled_target.hpp"

#include <epoxy/gl.h>

#include <stdexcept>

namespace impetus::inline drawing {
namespace {

constexpr int kSamples = 4;  // every OpenGL 3.3 has them
constexpr int kUsualBits = 8;

// Drivers may refuse to average into another format than the picture's own.
GLenum format_of_window() {
  int red_bits = 0;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, GL_BACK_LEFT,
                                        GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, &red_bits);
  return red_bits > kUsualBits ? GL_RGB10_A2 : GL_RGBA8;
}

void reserve(unsigned buffer, GLenum format, int width, int height) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, format, width, height);
}

}  // namespace

void MultisampledTarget::allocate(int width, int height) {
  reserve(colour_, format_of_window(), width, height);
  reserve(depth_, GL_DEPTH_COMPONENT24, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (!complete) {
    throw std::runtime_error("the driver refused a picture with four samples per pixel");
  }
  width_ = width;
  height_ = height;
}

void MultisampledTarget::begin(int width, int height) {
  if (width != width_ || height != height_) {
    allocate(width, height);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
}

void MultisampledTarget::end_onto(const PixelArea& area, unsigned framebuffer) {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glBlitFramebuffer(0, 0, width_, height_, area.left, area.bottom, area.left + area.width,
                    area.bottom + area.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace impetus::inline drawing
