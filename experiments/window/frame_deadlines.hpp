// When each frame is due, and whether it came late: flips on an absolute grid. Waits for the slot,
// pumping events, then swaps and stamps; the grid (record/frame_grid.hpp) says what was missed.
//
//   timer            |pump.pump.pump.pump.pump|swap, finish, stamp     stamp anchored to nothing
//   blocking swap    |pump.pump.pump.pump|swap ........ refresh|stamp  stamp anchored
//                                         3 ms before due          to the refresh
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "experiments/record/frame_grid.hpp"
#include "experiments/session/timing_check.hpp"
#include "experiments/window/gl_window.hpp"
#include "experiments/window/stamped_input.hpp"

namespace impetus::inline window {

/// Paces the flips of one window.
class FrameDeadlines {
 public:
  /// Paces by the timer until a sync test has passed. All three must outlive this.
  FrameDeadlines(GlWindow& window, EventPump& events, const Clock& clock);

  /// Starts the grid anew: at the last flip when it was within a period, otherwise at a slot's
  /// distance from it (blocking swap, which keeps the display's phase) or now (timer).
  void restart();

  /// Waits for the next slot and flips what was drawn.
  Flip flip();

  /// `draw` draws any frame. Sets how flip() paces from then on.
  SyncTest sync_test(const std::function<void()>& draw);

  /// What a flip's stamp is anchored to, in words.
  [[nodiscard]] std::string anchor() const;

 private:
  void wait_until(std::int64_t due_ns);

  GlWindow& window_;
  EventPump& events_;
  const Clock& clock_;
  FrameGrid grid_;
  bool swap_blocks_{false};
  std::int64_t last_flip_ns_{0};
};

}  // namespace impetus::inline window
