// SPDX-License-Identifier: MIT
#include "experiments/stage/input_self_test.hpp"

#include <algorithm>

#include "experiments/stage/canvas.hpp"
#include "experiments/stage/display_loss.hpp"
#include "experiments/stage/input_sender.hpp"

namespace impetus {
namespace {

constexpr std::int64_t kTimeToArrive_ns = 100'000'000;

}  // namespace

InputTrace try_input(Window& window, const Clock& clock, const std::function<bool()>& show) {
  InputTrace trace;
  EventPump& events = window.canvas().events;
  events.listen([&trace](const StampedEvent& event) {
    if (auto arrived = as_sent_input(event.event)) {
      arrived->arrived_ns = event.arrived_ns;
      arrived->uncertainty_ns = event.uncertainty_ns;
      trace.arrived.push_back(*arrived);
    }
  });
  InputSender sender(clock);
  while (show()) {
  }
  const std::int64_t until_ns = clock.now_ns() - kTimeToArrive_ns;
  trace.sent = sender.stop();
  events.listen({});
  std::erase_if(trace.sent, [until_ns](const SentInput& sent) { return sent.sent_ns > until_ns; });
  return trace;
}

void centre_pointer(Window& window) {
  while_display_lasts([&] {
    SDL_WarpMouseInWindow(window.canvas().window.handle(), window.width_px() / 2,
                          window.height_px() / 2);
    window.canvas().events.pump();
  });
}

}  // namespace impetus
