// A picture off the window with four samples per pixel, averaged onto the window when it is done.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/drawing/picture_map.hpp"
#include "experiments/drawing/shader_program.hpp"

namespace impetus::inline drawing {

/// Where a picture is drawn before it is averaged. Needs a current OpenGL 3.3 context, from its
/// beginning and for every call; takes no memory until begin().
class MultisampledTarget {
 public:
  /// Everything is drawn here from now on, at 0, 0 and in the given size (pixels). The memory is
  /// kept for the next picture of this size. Throws std::runtime_error when the driver refuses.
  void begin(int width, int height);

  /// Averages the picture onto the area of the window, or of another framebuffer of OpenGL's, which
  /// must have the size given to begin(), and draws to the window again.
  void end_onto(const PixelArea& area, unsigned framebuffer = 0);

 private:
  void allocate(int width, int height);

  GlName framebuffer_{GlName::Kind::kFramebuffer};
  GlName colour_{GlName::Kind::kRenderbuffer};
  GlName depth_{GlName::Kind::kRenderbuffer};
  int width_{0};
  int height_{0};
};

}  // namespace impetus::inline drawing
