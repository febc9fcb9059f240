// SPDX-License-Identifier: MIT
#include "experiments/window/mouse_input.hpp"

#include <utility>

namespace impetus::inline window {

void MouseInput::take(const std::vector<StampedEvent>& events) {
  for (const StampedEvent& stamped : events) {
    const SDL_Event& event = stamped.event;
    const bool space =
        event.type == SDL_KEYDOWN && event.key.repeat == 0 && event.key.keysym.sym == SDLK_SPACE;
    if (event.type == SDL_MOUSEMOTION) {
      samples_.push_back(
          {stamped.arrived_ns, on_glass(event.motion.x, event.motion.y), GazeLoss::kNone});
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
    now.at = on_glass(x_px, y_px);
    now.loss = GazeLoss::kNone;
  }
  samples_.push_back(now);
  return std::exchange(samples_, {});
}

std::vector<ClickRecord> MouseInput::take_clicks() { return std::exchange(clicks_, {}); }

ScreenPoint MouseInput::on_glass(int x_px, int y_px) const {
  // Pixel centres; y of the screen points up.
  return {((x_px + 0.5) / geometry_.width_px - 0.5) * geometry_.width_m,
          (0.5 - (y_px + 0.5) / geometry_.height_px) * geometry_.height_m};
}

}  // namespace impetus::inline window
