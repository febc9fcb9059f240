// SPDX-License-Identifier: MIT
#include "experiments/viewers/viewer_screen.hpp"

namespace impetus::inline viewers {

void ViewerScreen::run() {
  canvas_.window.show_cursor(true);
  canvas_.gui.forget_input();
  canvas_.deadlines.restart();
  std::int64_t flipped_ns = draw_and_flip();
  canvas_.events.discard();
  while (!canvas_.events.closed() && !left_) {
    for (const StampedEvent& stamped : canvas_.events.take()) {
      canvas_.gui.feed(stamped.event);
      take(stamped.event);
    }
    const std::int64_t now_ns = draw_and_flip();
    go_on(static_cast<double>(now_ns - flipped_ns) / 1e9);
    flipped_ns = now_ns;
  }
  static_cast<void>(canvas_.events.take_pause_request());
}

std::int64_t ViewerScreen::draw_and_flip() {
  canvas_.fill_page();
  paint();
  canvas_.gui.begin();
  draw();
  canvas_.gui.end();
  end_frame();
  return canvas_.deadlines.flip().flipped_ns;
}

}  // namespace impetus::inline viewers
