// The mouse during a stimulus: its pointer stands in for the gaze, its buttons (or the space bar)
// are clicks.
//
// A mouse that rests sends nothing, so every call for samples adds one of where it is: the newest
// sample is never older than a frame.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/record/ports.hpp"
#include "experiments/window/event_pump.hpp"

namespace impetus::inline window {

class MouseInput final : public Gaze {
 public:
  /// `clock` stamps what is sampled and must outlive this.
  explicit MouseInput(const Clock& clock) : clock_(clock) {}

  /// The lab's measures; pixels are the window's own.
  void set_geometry(const ScreenGeometry& geometry) { geometry_ = geometry; }

  /// Looks through events that arrived during a frame.
  void take(const std::vector<StampedEvent>& events);

  [[nodiscard]] std::string source() const override { return "mouse"; }
  [[nodiscard]] bool is_pointer() const override { return true; }
  std::vector<GazeSample> take_samples() override;
  std::vector<ClickRecord> take_clicks();

 private:
  [[nodiscard]] ScreenPoint on_glass(int x_px, int y_px) const;

  const Clock& clock_;
  ScreenGeometry geometry_;
  std::vector<GazeSample> samples_;
  std::vector<ClickRecord> clicks_;
};

}  // namespace impetus::inline window
