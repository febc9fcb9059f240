// The scenes that a timing report shows: shipped ones, at their own step rate.
//
//   up to 100 bodies   L-blocks bounce in a cube, detailed about the gaze
//   more               creatures crowd a cube, by their own schedule and budget
//
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/record/ports.hpp"
#include "experiments/scenes/shape_library.hpp"

namespace impetus::inline timing {

/// The trial that shows so many bodies.
PlannedTrial timing_trial(int bodies);

class TimingScenes final : public Scenes {
 public:
  /// Every scene lasts so long. `shapes` must outlive this.
  TimingScenes(double duration_s, ShapeLibrary& shapes)
      : duration_s_(duration_s), shapes_(&shapes) {}

  /// The scene of a timing_trial().
  [[nodiscard]] StagedScene stage(const PlannedTrial& trial,
                                  const ScreenGeometry& screen) const override;
  /// There are none: throws std::logic_error.
  [[nodiscard]] StagedScene stage_demonstration(const std::string& id,
                                                const ScreenGeometry& screen) const override;

 private:
  double duration_s_;
  ShapeLibrary* shapes_;
};

}  // namespace impetus::inline timing
