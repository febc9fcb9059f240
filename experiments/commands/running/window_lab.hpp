// The lab's window as a timing report needs it.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/record/ports.hpp"
#include "experiments/timing/timing_run.hpp"
#include "experiments/window/input_self_test.hpp"
#include "experiments/window/shown_patch.hpp"
#include "experiments/window/window.hpp"

namespace impetus::inline commands {

class WindowLab final : public TimingLab {
 public:
  /// Opens the window, with the pointer in its middle. Throws what Window throws.
  WindowLab(const WindowOptions& options, const ScreenGeometry& screen) : window_(options, clock_) {
    window_.set_geometry(screen);
    centre_pointer(window_);
  }

  Display& display() override { return window_; }
  Input& input() override { return window_; }
  Gaze& gaze() override { return window_.mouse_gaze(); }
  [[nodiscard]] const Clock& clock() const override { return clock_; }
  SyncTest sync_test() override { return window_.sync_test(); }
  InputTrace try_input(const std::function<bool()>& show) override {
    return impetus::try_input(window_, clock_, show);
  }
  void show_patch(ScreenCorner corner) override { window_.show_patch(corner); }
  [[nodiscard]] bool can_read_patch() override { return can_read_shown_patch(window_); }
  std::optional<std::int64_t> read_patch() override { return shown_patch(window_); }

  Window& window() { return window_; }

 private:
  SteadyClock clock_;
  Window window_;
};

}  // namespace impetus::inline commands
