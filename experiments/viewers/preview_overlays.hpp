// What a preview draws over the scene: pairs by priority, contacts, and where the viewer looks.
//
//   red    pairs of list 0          ·     contacts of overlapping nodes, red, and
//   blue   pairs of lower lists     ●──▶  what the reduction leaves of them, yellow with normals
//                                   ◯     the gaze and, for schedules by region, the region
//
// Contacts fade for a quarter of a second. (Dingliana 2002, figure 6.3)
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/drawing/body_colours.hpp"
#include "experiments/drawing/picture_map.hpp"
#include "experiments/run/preview_run.hpp"

namespace impetus::inline viewers {

/// What is shown, as the panel's boxes say.
struct PreviewOverlays {
  bool shown{true};  ///< false: none of the marks
  bool pairs{true};
  bool volumes{false};
  bool contacts{true};
  bool gaze{true};
  int volume_level{-1};                         ///< −1: the level in use
  BodyColours colours{BodyColours::kPriority};  ///< whatever else is shown
};

/// What is shown at first: of a crowd no lines and contacts, which would hide it.
[[nodiscard]] PreviewOverlays overlays_for(const StagedScene& scene);

/// Draws into the current ImGui window, within the picture.
void draw_overlays(const PreviewRun& run, const PreviewOverlays& overlays, const PictureMap& map,
                   const std::vector<PosedBody>& bodies);

}  // namespace impetus::inline viewers
