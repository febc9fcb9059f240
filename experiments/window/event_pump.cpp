// SPDX-License-Identifier: MIT
#include "experiments/window/event_pump.hpp"

#include <utility>

#include "experiments/window/display_loss.hpp"

namespace impetus::inline window {

void EventPump::pump() {
  if (display_lost()) {
    return;
  }
  const std::int64_t looking_ns = clock_.now_ns();
  SDL_PumpEvents();
  SDL_Event event;
  while (SDL_PeepEvents(&event, 1, SDL_GETEVENT, SDL_FIRSTEVENT, SDL_LASTEVENT) == 1) {
    const std::int64_t now_ns = clock_.now_ns();
    notice(event);
    events_.push_back({event, now_ns, now_ns - looked_ns_});
    if (heard_) {
      heard_(events_.back());
    }
  }
  looked_ns_ = looking_ns;
}

void EventPump::notice(const SDL_Event& event) {
  const bool window_closed =
      event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_CLOSE;
  closed_ = closed_ || event.type == SDL_QUIT || window_closed;
  const bool escape =
      event.type == SDL_KEYDOWN && event.key.repeat == 0 && event.key.keysym.sym == SDLK_ESCAPE;
  pause_requested_ = pause_requested_ || escape;
}

std::vector<StampedEvent> EventPump::take() { return std::exchange(events_, {}); }

bool EventPump::take_pause_request() { return std::exchange(pause_requested_, false); }

bool EventPump::closed() const { return closed_ || display_lost(); }

}  // namespace impetus::inline window
