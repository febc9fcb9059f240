// SPDX-License-Identifier: MIT
#include "experiments/window/stamped_input.hpp"

#include <cstdio>

#include "experiments/record/lab_screen.hpp"
#include "experiments/window/display.hpp"

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
  const bool of_window = event.type == SDL_WINDOWEVENT;
  closed_ = closed_ || event.type == SDL_QUIT ||
            (of_window && event.window.event == SDL_WINDOWEVENT_CLOSE);
  if (of_window && event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED) {
    notice_size(event.window.windowID);
  }
  const bool escape =
      event.type == SDL_KEYDOWN && event.key.repeat == 0 && event.key.keysym.sym == SDLK_ESCAPE;
  pause_requested_ = pause_requested_ || escape;
}

/// As it is by now: while a window opens, its manager may try several sizes.
void EventPump::notice_size(std::uint32_t window) {
  int width_px = 0;
  int height_px = 0;
  SDL_GetWindowSize(SDL_GetWindowFromID(window), &width_px, &height_px);
  if (kept_px_ && *kept_px_ != std::pair(width_px, height_px) && !closed_) {
    closed_ = true;
    std::fprintf(stderr,
                 "impetus: the window changed from %d × %d px to %d × %d px, so that nothing in it "
                 "would be as large as was measured; everything answered before is saved\n",
                 kept_px_->first, kept_px_->second, width_px, height_px);
  }
}

std::vector<StampedEvent> EventPump::take() { return std::exchange(events_, {}); }

bool EventPump::take_pause_request() { return std::exchange(pause_requested_, false); }

bool EventPump::closed() const { return closed_ || display_lost(); }

void MouseInput::take(const std::vector<StampedEvent>& events) {
  for (const StampedEvent& stamped : events) {
    const SDL_Event& event = stamped.event;
    const bool space =
        event.type == SDL_KEYDOWN && event.key.repeat == 0 && event.key.keysym.sym == SDLK_SPACE;
    if (event.type == SDL_MOUSEMOTION) {
      samples_.push_back({stamped.arrived_ns, on_glass(geometry_, event.motion.x, event.motion.y),
                          GazeLoss::kNone});
    } else if (event.type == SDL_MOUSEBUTTONDOWN || space) {
      clicks_.push_back({space ? "key" : "mouse", stamped.arrived_ns, stamped.uncertainty_ns});
    }
  }
}

std::vector<GazeSample> MouseInput::take_samples() {
  GazeSample now{clock_.now_ns(), {}, GazeLoss::kOffScreen};
  if (SDL_GetMouseFocus() != nullptr) {
    int x_px = 0;
    int y_px = 0;
    SDL_GetMouseState(&x_px, &y_px);
    now.at = on_glass(geometry_, x_px, y_px);
    now.loss = GazeLoss::kNone;
  }
  samples_.push_back(now);
  return std::exchange(samples_, {});
}

std::vector<ClickRecord> MouseInput::take_clicks() { return std::exchange(clicks_, {}); }

}  // namespace impetus::inline window
