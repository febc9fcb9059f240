// SPDX-License-Identifier: MIT
#include "experiments/window/pixels.hpp"

#include <epoxy/gl.h>
#include <png.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace impetus::inline window {
namespace {

constexpr std::size_t kChannels = 3;

/// Of the framebuffer that is bound for reading.
Pixels read_area(const PixelArea& area) {
  Pixels pixels{area.width, area.height, {}};
  const std::size_t row_bytes = kChannels * static_cast<std::size_t>(area.width);
  pixels.rgb.resize(row_bytes * static_cast<std::size_t>(area.height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  for (int row = 0; row < area.height; ++row) {  // OpenGL counts them from the bottom
    glReadPixels(area.left, area.bottom + area.height - 1 - row, area.width, 1, GL_RGB,
                 GL_UNSIGNED_BYTE, pixels.rgb.data() + static_cast<std::size_t>(row) * row_bytes);
  }
  return pixels;
}

}  // namespace

Pixels beside_each_other(const std::vector<Pixels>& pictures) {
  Pixels all;
  for (const Pixels& picture : pictures) {
    all.width += picture.width;
    all.height = picture.height;
  }
  all.rgb.resize(kChannels * static_cast<std::size_t>(all.width) *
                 static_cast<std::size_t>(all.height));
  auto place = all.rgb.begin();
  for (int row = 0; row < all.height; ++row) {
    for (const Pixels& picture : pictures) {
      const auto bytes = static_cast<std::ptrdiff_t>(kChannels) * picture.width;
      place = std::copy_n(picture.rgb.begin() + row * bytes, bytes, place);
    }
  }
  return all;
}

Pixels below_each_other(const std::vector<Pixels>& pictures) {
  Pixels all;
  for (const Pixels& picture : pictures) {
    all.width = picture.width;
    all.height += picture.height;
    all.rgb.insert(all.rgb.end(), picture.rgb.begin(), picture.rgb.end());
  }
  return all;
}

void write_png(const Pixels& pixels, const std::string& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(pixels.width);
  image.height = static_cast<png_uint_32>(pixels.height);
  image.format = PNG_FORMAT_RGB;
  const bool written =
      png_image_write_to_file(&image, file.c_str(), 0, pixels.rgb.data(), 0, nullptr) != 0;
  const std::string reason = image.message;
  png_image_free(&image);
  if (!written) {
    throw std::runtime_error(file + ": cannot be written (" + reason + ")");
  }
}

WindowOptions unseen_window(const PictureSize& size) {
  return {
      .fullscreen = false, .width_px = size.width_px, .height_px = size.height_px, .seen = false};
}

ReadableTarget::ReadableTarget(const PictureSize& size) : size_(size) {
  glBindRenderbuffer(GL_RENDERBUFFER, colour_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.width_px, size.height_px);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void ReadableTarget::draw_here() const { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_); }

Pixels ReadableTarget::read() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  Pixels pixels = read_area({0, 0, size_.width_px, size_.height_px});
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  return pixels;
}

Pixels window_pixels(const PixelArea& area) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glReadBuffer(GL_BACK);
  return read_area(area);
}

}  // namespace impetus::inline window
