// SPDX-License-Identifier: MIT
#include "experiments/gaze/region_source.hpp"

namespace impetus::inline gaze {

RegionSource::RegionSource(const StagedScene& scene, std::uint64_t seed)
    : rule_(scene.region),
      recorded_gaze_(scene.recorded_gaze),
      enclosure_(scene.world.settings().enclosure),
      viewer_(scene.viewer),
      turn_(scene.turn),
      step_hz_(scene.step_hz),
      image_(scene.world.settings().enclosure, scene.viewer),
      places_(seed, "random region") {}

std::optional<GazeRegion> RegionSource::at(std::int64_t step, const Fixation& fixation) {
  switch (rule_.kind) {
    case RegionKind::kAllGood:
      return GazeRegion{{}, kWholeView_deg};
    case RegionKind::kTracked:
      return fixation ? std::optional(GazeRegion{*fixation, rule_.radius_deg}) : std::nullopt;
    case RegionKind::kRandom:
      if ((step - 1) % rule_.renewal_steps == 0) {
        if (turn_.rate_deg_s != 0.0) {
          const double time_s = static_cast<double>(step) / step_hz_;
          image_ = EnclosureImage(enclosure_, turned_viewer(viewer_, turn_, time_s));
        }
        place_ = image_.uniform_point(places_);
      }
      return GazeRegion{place_, rule_.radius_deg};
    case RegionKind::kRecorded: {
      const Fixation then = recorded_gaze_ ? recorded_gaze_->at(step) : std::nullopt;
      return then ? std::optional(GazeRegion{*then, rule_.radius_deg}) : std::nullopt;
    }
    case RegionKind::kFixed:
      return GazeRegion{rule_.point, rule_.radius_deg};
    default:
      return std::nullopt;
  }
}

}  // namespace impetus::inline gaze
