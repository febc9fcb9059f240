// What the window is made of, for the screens of this room and of the viewers alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "experiments/drawing/palette.hpp"
#include "experiments/drawing/scene_painter.hpp"
#include "experiments/record/photodiode_patch.hpp"
#include "experiments/window/frame_deadlines.hpp"
#include "experiments/window/gl_window.hpp"
#include "experiments/window/gui.hpp"
#include "experiments/window/stamped_input.hpp"

namespace impetus::inline window {

/// The window with all that draws into it and listens to it.
struct Canvas {
  Canvas(const WindowOptions& options, const Clock& clock)
      : window(options),
        events(clock),
        deadlines(window, events, clock),
        gui(window, options.letters),
        mouse(clock) {}

  [[nodiscard]] PixelArea whole() const { return {0, 0, window.width_px(), window.height_px()}; }

  /// The ground of a page; light where it is a researcher's.
  void fill_page(bool light = true) {
    painter.fill(whole(), light ? palette::kLightGrey : palette::kPictureGrey);
  }

  /// Draws the photodiode patch's code over all else; nothing where there is no patch.
  void paint_patch(std::int64_t code) {
    if (patch) {
      painter.fill(*patch, patch_grey(code));
    }
  }

  GlWindow window;
  EventPump events;
  FrameDeadlines deadlines;
  Gui gui;
  ScenePainter painter;
  MouseInput mouse;
  std::optional<PixelArea> patch;  ///< where it lies
};

/// All that a participant sees of a picture, patch included; not yet flipped.
void paint_picture(Canvas& canvas, const Picture& picture, const ScreenGeometry& screen);

}  // namespace impetus::inline window
