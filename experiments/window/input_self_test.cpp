// SPDX-License-Identifier: MIT
#include "experiments/window/input_self_test.hpp"

#include "experiments/window/canvas.hpp"
#include "experiments/window/display_loss.hpp"
#include "experiments/window/input_sender.hpp"

namespace impetus::inline window {

InputTrace try_input(Window& window, const Clock& clock, const std::function<bool()>& show) {
  InputTrace trace;
  EventPump& events = window.canvas().events;
  InputSender sender(clock);
  events.listen([&trace, &sender](const StampedEvent& event) {
    if (auto arrived = as_sent_input(event.event)) {
      arrived->arrived_ns = event.arrived_ns;
      arrived->uncertainty_ns = event.uncertainty_ns;
      trace.arrived.push_back(*arrived);
      sender.tell(*arrived);
    }
  });
  while (show()) {
  }
  trace.sent = sender.stop();
  events.listen({});
  return trace;
}

void centre_pointer(Window& window) {
  while_display_lasts([&] {
    SDL_WarpMouseInWindow(window.canvas().window.handle(), window.width_px() / 2,
                          window.height_px() / 2);
    window.canvas().events.pump();
  });
}

}  // namespace impetus::inline window
