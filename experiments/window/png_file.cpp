// SPDX-License-Identifier: MIT
#include "experiments/window/png_file.hpp"

#include <png.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace impetus::inline window {
namespace {

constexpr std::size_t kChannels = 3;

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

}  // namespace impetus::inline window
