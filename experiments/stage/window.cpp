// SPDX-License-Identifier: MIT
#include "experiments/stage/window.hpp"

#include "experiments/stage/canvas.hpp"
#include "experiments/stage/page_turn.hpp"
#include "experiments/stage/palette.hpp"
#include "experiments/stage/progress_bar.hpp"

namespace impetus {

Window::Window(const WindowOptions& options, const Clock& clock)
    : canvas_(std::make_unique<Canvas>(options, clock)) {
  set_geometry({});
}

Window::~Window() = default;

double Window::refresh_hz() const { return canvas_->window.refresh_hz(); }
const ScreenGeometry& Window::geometry() const { return geometry_; }
int Window::width_px() const { return canvas_->window.width_px(); }
int Window::height_px() const { return canvas_->window.height_px(); }
void Window::restart_grid() { canvas_->pacer.restart(); }

void Window::set_geometry(const ScreenGeometry& geometry) {
  geometry_ = geometry;
  if (geometry_.width_px == 0) {
    geometry_.width_px = width_px();
  }
  if (geometry_.height_px == 0) {
    geometry_.height_px = height_px();
  }
}

Flip Window::show(const Picture& picture) {
  canvas_->window.show_cursor(false);
  canvas_->painter.paint(picture, canvas_->whole());
  canvas_->gui.begin();
  draw_progress(canvas_->gui, picture.progress, Ground::kPicture);
  canvas_->gui.end();
  const Flip flip = canvas_->pacer.flip();
  canvas_->events.discard();
  return flip;
}

Answer Window::ask(const Page& page) { return PageTurn(*canvas_, page).ask(); }

void Window::show_page_for(const Page& page, double seconds, std::size_t highlighted_choice) {
  PageTurn(*canvas_, page).show_for(seconds, highlighted_choice);
}

Interruption Window::interruption() {
  if (canvas_->events.closed()) {
    return Interruption::kDisplayClosed;
  }
  return canvas_->events.take_pause_request() ? Interruption::kPauseRequested : Interruption::kNone;
}

SyncTest Window::sync_test() {
  canvas_->window.show_cursor(false);
  return canvas_->pacer.sync_test(
      [this] { canvas_->painter.fill(canvas_->whole(), palette::kPictureGrey); });
}

std::string Window::description() const {
  return canvas_->window.description() + "; flip stamp: " + canvas_->pacer.anchor();
}

}  // namespace impetus
