// SPDX-License-Identifier: MIT
#include "experiments/gaze/region_coverage.hpp"

#include "experiments/gaze/region_source.hpp"
#include "experiments/record/enclosure_image.hpp"

namespace impetus::inline gaze {

std::optional<double> mean_covered_share(const StagedScene& scene,
                                         const std::vector<StepRecord>& steps) {
  EnclosureImage image(scene.world.settings().enclosure, scene.viewer);
  const bool turns = scene.turn.rate_deg_s != 0.0;
  double sum = 0.0;
  std::int64_t count = 0;
  double share = 0.0;
  const StepRecord* measured = nullptr;
  for (const StepRecord& step : steps) {
    if (!step.gaze.region || step.gaze.region->radius_deg >= kWholeView_deg) {
      continue;
    }
    if (turns) {
      const double time_s = static_cast<double>(step.step) / scene.step_hz;
      image = EnclosureImage(scene.world.settings().enclosure, scene.viewer_at_time(time_s));
    }
    if (turns || measured == nullptr ||
        !(measured->gaze.region->centre == step.gaze.region->centre)) {
      share = image.covered_share(*step.gaze.region);
      measured = &step;
    }
    sum += share;
    ++count;
  }
  return count > 0 ? std::optional(sum / static_cast<double>(count)) : std::nullopt;
}

}  // namespace impetus::inline gaze
