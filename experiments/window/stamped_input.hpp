// Takes events from the system and stamps them with our own clock.
//
//   pump          pump          pump
//   |..............|......x.......|      x arrived; it is stamped at the next pump,
//                   <-----------> uncertainty   and may be older by this much
//
// SPDX-License-Identifier: MIT
#pragma once

#include <SDL.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "experiments/record/ports.hpp"

namespace impetus::inline window {

/// An event and when it came.
struct StampedEvent {
  SDL_Event event{};
  std::int64_t arrived_ns{0};
  std::int64_t uncertainty_ns{0};  ///< the event may have arrived this much earlier
};

/// The events of the window.
class EventPump {
 public:
  /// `clock` must outlive the pump.
  explicit EventPump(const Clock& clock) : clock_(clock), looked_ns_(clock.now_ns()) {}

  /// Takes and stamps all that has arrived.
  void pump();

  /// What was pumped since the last take() or discard(), in order of arrival.
  std::vector<StampedEvent> take();

  /// Forgets what was pumped; a request to pause or close stays.
  void discard() { events_.clear(); }

  /// From now on `heard` is told of every event as it is pumped; {}: nobody is.
  void listen(std::function<void(const StampedEvent&)> heard) { heard_ = std::move(heard); }

  /// From now on a window of another size than this counts as closed, which is said: nothing in it
  /// would be seen under the angles that were measured.
  void close_when_resized(int width_px, int height_px) { kept_px_ = {width_px, height_px}; }

  /// Whether Esc was pressed since the last call.
  bool take_pause_request();

  /// The same without forgetting it.
  [[nodiscard]] bool pause_requested() const { return pause_requested_; }

  /// Whether the window was closed or the display is gone; stays so.
  [[nodiscard]] bool closed() const;

 private:
  void notice(const SDL_Event& event);
  void notice_size(std::uint32_t window);

  const Clock& clock_;
  std::int64_t looked_ns_;
  std::optional<std::pair<int, int>> kept_px_;  ///< none: of any size
  std::vector<StampedEvent> events_;
  std::function<void(const StampedEvent&)> heard_;
  bool pause_requested_{false};
  bool closed_{false};
};

/// The mouse during a stimulus: its pointer stands in for the gaze, its buttons (or the space bar)
/// are clicks. A mouse that rests sends nothing, so every call for samples adds one of where it is:
/// the newest sample is never older than a frame.
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
  const Clock& clock_;
  ScreenGeometry geometry_;
  std::vector<GazeSample> samples_;
  std::vector<ClickRecord> clicks_;
};

}  // namespace impetus::inline window
