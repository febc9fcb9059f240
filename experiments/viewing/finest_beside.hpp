// The same trial at the finest level, simulated a little in every frame once it is asked for.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "experiments/record/ports.hpp"
#include "experiments/viewing/replay_simulation.hpp"

namespace impetus::inline viewing {

class FinestBeside {
 public:
  /// All must outlive this.
  FinestBeside(const StagedScene& scene, const std::vector<StepRecord>& steps, const Clock& clock)
      : scene_(scene), steps_(steps), clock_(clock) {}

  /// Simulates for a part of a frame. Whether it has just been done.
  bool go_on();

  /// From 0 to 1.
  [[nodiscard]] double share() const;
  /// Null until it is done.
  [[nodiscard]] const ReplayView* view() const { return view_ ? &*view_ : nullptr; }

 private:
  const StagedScene& scene_;
  const std::vector<StepRecord>& steps_;
  const Clock& clock_;
  std::unique_ptr<ReplaySimulation> running_;
  std::optional<ReplayView> view_;
};

}  // namespace impetus::inline viewing
