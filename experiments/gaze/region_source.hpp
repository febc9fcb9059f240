// The region of high priority, step by step: about the gaze, at random or about a point, everywhere
// or nowhere; and how much of what is on show it covered.
//
//   all good   a region that holds all the view       all bad   none
//   tracked    about the fixation                     random    about a place within the
//                                                               enclosure's image, renewed
//   fixed      about a point of the screen    recorded  about another's recorded gaze (yoked)
//
// All of them are the same schedule with another region. (Dingliana 2002, sec. 6.3.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/numerics/random_stream.hpp"
#include "engine/scheduling/priority_lists.hpp"
#include "engine/volumes/enclosure.hpp"
#include "experiments/record/record.hpp"
#include "experiments/record/staged_scene.hpp"

namespace impetus::inline gaze {

/// The enclosure as the viewer sees it: the outline of its eight corners on the screen.
class EnclosureImage {
 public:
  /// The whole screen when there is no enclosure, or when the eye is not before all of it.
  EnclosureImage(const std::optional<Enclosure>& enclosure, const Viewer& viewer);

  [[nodiscard]] bool contains(const ScreenPoint& point) const;

  /// A point of the image, all equally likely.
  ScreenPoint uniform_point(RandomStream& stream) const;

  /// The share of the image that lies inside the region, from 0 to 1, found on a grid: right to
  /// about .01. For the record alone.
  [[nodiscard]] double covered_share(const GazeRegion& region) const;

 private:
  [[nodiscard]] ScreenPoint in_frame(double across, double up) const;

  Viewer viewer_;
  std::vector<ScreenPoint> outline_;  ///< convex, anticlockwise
  ScreenPoint least_{};               ///< of the rectangle that frames it
  ScreenPoint greatest_{};
};

/// The radius of a region that holds all the view.
inline constexpr double kWholeView_deg = 180.0;

/// Says the region of each step.
class RegionSource {
 public:
  /// Random places follow from `seed`, the trial's. A recorded region without a recording is none.
  RegionSource(const StagedScene& scene, std::uint64_t seed);

  /// Another rule from the next step on; random places go on as they were drawn.
  void set_rule(const RegionRule& rule) { rule_ = rule; }

  /// The region of a step. Steps come in order, from 1; none may be left out.
  std::optional<GazeRegion> at(std::int64_t step, const Fixation& fixation);

 private:
  RegionRule rule_;
  std::shared_ptr<const GazePath> recorded_gaze_;
  std::optional<Enclosure> enclosure_;
  Viewer viewer_;
  ViewerTurn turn_;
  double step_hz_;
  EnclosureImage image_;
  RandomStream places_;
  ScreenPoint place_{};
};

/// Of the enclosure's image, the share inside the region; mean over the steps that had a region
/// with an edge, none without such a step.
std::optional<double> mean_covered_share(const StagedScene& scene,
                                         const std::vector<StepRecord>& steps);

}  // namespace impetus::inline gaze
