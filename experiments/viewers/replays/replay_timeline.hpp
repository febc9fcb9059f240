// The bar under a replay: contacts, holds, collisions, clicks, answers, late frames and lost gaze
// over time, to be scrubbed.
//
//    contact      response                       labels
//         ╷  ╷  ╷   ╷                            clicks: from above, to the middle of the track
//   ────┃█████──────┃───▀▀▀────────┃────         track, with the hold as a band, lost gaze as one
//                                                along its upper edge
//         ╵╵  ╵ ╵                                collisions: along the track's lower edge
//            ' '                                 late frames
//
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "experiments/viewing/replay_view.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline viewers {

struct TimelineFrame {
  ImVec2 origin;  ///< upper left corner, pixels
  float width_px{0.0F};
  double span_s{1.0};
  double time_s{0.0};
};

/// What the bar with labels and key takes, in pixels.
[[nodiscard]] float timeline_height(const Gui& gui);

/// Draws it. Returns the time under the mouse while its button is held on the track.
std::optional<double> draw_timeline(const Gui& gui, const std::vector<TimelineMark>& marks,
                                    const TimelineFrame& frame);

}  // namespace impetus::inline viewers
