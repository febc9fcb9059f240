// A simulated participant in a real window: answers like the headless one, at a pace one can watch.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/observers/causality_observer.hpp"
#include "experiments/protocol/observer_file.hpp"
#include "experiments/stage/window.hpp"

namespace impetus {

class ShownObserver final : public Input {
 public:
  /// `window` and `clock` must outlive this.
  ShownObserver(const ObserverFile& observer, std::uint64_t seed, const std::string& participant,
                Window& window, const Clock& clock);

  Answer ask(const Page& page) override;
  Interruption interruption() override { return window_.interruption(); }
  void witnessed(const AttemptRecord& shown) override { observer_.witnessed(shown); }

 private:
  VirtualClock own_time_;  ///< of the model's reaction times; the record takes the real clock's
  CausalityObserver observer_;
  Window& window_;
  const Clock& clock_;
};

}  // namespace impetus
