// The photodiode patch as pixels: where it lies in the window, drawn over all else, and what of it
// the window system has taken over.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "experiments/drawing/picture_map.hpp"
#include "experiments/drawing/scene_painter.hpp"
#include "experiments/record/photodiode_patch.hpp"

namespace impetus::inline drawing {

/// The square of kPatchSide_m in the corner of a window of this size that fills the screen.
PixelArea patch_area(ScreenCorner corner, const ScreenGeometry& screen, int width_px,
                     int height_px);

/// The code whose grey is nearest to this red, green and blue (0–255); none: it is no grey, or
/// lies more than 8 from all of them.
std::optional<std::int64_t> code_of_pixel(int red, int green, int blue);

class PatchPainter {
 public:
  /// From now on there is a patch, in this area.
  void lie_in(const PixelArea& area) { area_ = area; }

  [[nodiscard]] const std::optional<PixelArea>& area() const { return area_; }

  /// Draws the code; nothing where there is no patch.
  void paint(ScenePainter& painter, std::int64_t code) const {
    if (area_) {
      painter.fill(*area_, patch_grey(code));
    }
  }

 private:
  std::optional<PixelArea> area_;
};

}  // namespace impetus::inline drawing
