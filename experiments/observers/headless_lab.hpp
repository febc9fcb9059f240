// A laboratory without a window: time is virtual, every flip happens exactly when it is due.
//
// The same session code runs here as before a person, thousands of times faster than real time.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/record/ports.hpp"

namespace impetus::inline observers {

/// Frames per second of a laboratory without a window.
inline constexpr double kHeadlessHz = 60.0;

/// A clock that moves only when it is told to.
class VirtualClock final : public Clock {
 public:
  [[nodiscard]] std::int64_t now_ns() const override { return now_ns_; }
  void advance_to(std::int64_t instant_ns) { now_ns_ = std::max(now_ns_, instant_ns); }
  void advance_by(std::int64_t duration_ns) { now_ns_ += duration_ns; }

 private:
  std::int64_t now_ns_{0};
};

/// A display whose every frame is in time, and which nobody sees.
class HeadlessDisplay final : public Display {
 public:
  HeadlessDisplay(VirtualClock& clock, double refresh_hz, ScreenGeometry geometry)
      : clock_(&clock), refresh_hz_(refresh_hz), geometry_(geometry), grid_(refresh_hz) {}

  [[nodiscard]] double refresh_hz() const override { return refresh_hz_; }
  [[nodiscard]] const ScreenGeometry& geometry() const override { return geometry_; }
  void restart_grid() override { grid_.restart(clock_->now_ns()); }
  Flip show(const Picture& /*picture*/) override {
    const std::int64_t submitted_ns = clock_->now_ns();
    clock_->advance_to(grid_.next_due_ns());
    return grid_.flipped(submitted_ns, clock_->now_ns());
  }

 private:
  VirtualClock* clock_;
  double refresh_hz_;
  ScreenGeometry geometry_;
  FrameGrid grid_;
};

}  // namespace impetus::inline observers
