// SPDX-License-Identifier: MIT
#include "experiments/viewers/replays/film_painter.hpp"

#include "experiments/viewers/replays/replay_picture.hpp"
#include "experiments/window/canvas.hpp"
#include "experiments/window/shown_patch.hpp"

namespace impetus::inline viewers {

/// The window that nobody sees, and what draws into it.
struct FilmPainter::Parts {
  Parts(const PictureSize& size, const Clock& clock) : canvas(unseen_window(size), clock) {}

  Canvas canvas;
  ReplayPicture over{canvas};
  ReplayLook look;
};

FilmPainter::FilmPainter(const PictureSize& size, const FilmOverlays& overlays, const Clock& clock)
    : parts_(std::make_unique<Parts>(size, clock)) {
  parts_->look.gaze = overlays.gaze;
  parts_->look.contacts = overlays.contacts;
  parts_->look.volumes = overlays.volumes;
}

FilmPainter::~FilmPainter() = default;

void FilmPainter::show_patch(ScreenCorner corner, const ScreenGeometry& screen) {
  Canvas& canvas = parts_->canvas;
  canvas.patch = patch_area(corner, screen, canvas.window.width_px(), canvas.window.height_px());
}

Pixels FilmPainter::paint(const Picture& picture) {
  paint_picture(parts_->canvas, picture, picture.viewer.screen);
  return window_pixels(parts_->canvas.whole());
}

Pixels FilmPainter::paint_over(const Picture& picture, const ReplayView& replay, double time_s) {
  Canvas& canvas = parts_->canvas;
  const ReplayMoment moment{&replay, time_s, canvas.whole(), ""};
  parts_->over.paint(moment, parts_->look);
  canvas.gui.begin();
  parts_->over.draw_over(moment, parts_->look);
  canvas.gui.end();
  canvas.paint_patch(picture.patch_code);
  return window_pixels(canvas.whole());
}

}  // namespace impetus::inline viewers
