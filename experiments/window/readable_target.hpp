// Pictures that go to a file: drawn without a window to be seen, read when they are done.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/window/png_file.hpp"
#include "experiments/window/window.hpp"

namespace impetus::inline window {

struct PictureSize {
  int width_px{1200};
  int height_px{1200};
};

inline constexpr int kLargestPicturePx = 8192;

/// A window of this size that nobody sees and that needs no display.
WindowOptions unseen_window(const PictureSize& size);

class ReadableTarget {
 public:
  /// Needs a current OpenGL 3.3 context, now and for every call.
  explicit ReadableTarget(const PictureSize& size);
  ~ReadableTarget();
  ReadableTarget(const ReadableTarget&) = delete;
  ReadableTarget& operator=(const ReadableTarget&) = delete;

  /// OpenGL's name of it, to draw onto.
  [[nodiscard]] unsigned framebuffer() const { return framebuffer_; }

  /// What follows is drawn here, until another target is chosen.
  void draw_here() const;

  [[nodiscard]] Pixels read() const;

 private:
  PictureSize size_;
  unsigned framebuffer_{0};
  unsigned colour_{0};
};

}  // namespace impetus::inline window
