// A simulated participant in a real window: answers like the headless one, at a pace one can watch.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "experiments/protocol/observer_file.hpp"
#include "experiments/window/window.hpp"

namespace impetus::inline commands {

/// Gives a simulated participant's answers in a window, once a person could have read the page.
class ShownObserver final : public Input {
 public:
  /// `window` and `clock` must outlive this.
  ShownObserver(const ObserverFile& observer, std::uint64_t seed, const std::string& participant,
                Window& window, const Clock& clock);

  Answer ask(const Page& page) override;
  Interruption interruption() override { return window_.interruption(); }
  void witnessed(const AttemptRecord& shown, const StagedScene& scene) override {
    observer_->witnessed(shown, scene);
  }
  std::vector<ClickRecord> take_clicks() override { return observer_->take_clicks(); }

  /// The participant's eye, looking at the window; null when it has none.
  Gaze* eye() { return observer_->eye(); }

 private:
  VirtualClock own_time_;  ///< of the model's reaction times; the record takes the real clock's
  std::unique_ptr<RatingObserver> observer_;
  Window& window_;
  const Clock& clock_;
};

}  // namespace impetus::inline commands
