// What a replay is steered by with the mouse: its buttons, each with its key, one row that moves
// and one that shows; and below them its timeline, to be scrubbed.
//
//    contact      response                       labels
//         ╷  ╷  ╷   ╷                            clicks: from above, to the middle of the track
//   ────┃█████──────┃───▀▀▀────────┃────         track, with the hold as a band, lost gaze as one
//                                                along its upper edge
//         ╵╵  ╵ ╵                                collisions: along the track's lower edge
//            ' '                                 late frames
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "experiments/viewers/replays/replay_keys.hpp"
#include "experiments/viewing/replay_playback.hpp"
#include "experiments/viewing/replay_view.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline viewers {

/// Draws the buttons from the cursor down, in as many rows as `width_px` asks for, and leaves the
/// cursor below them. Jumps that `marks` have no aim
/// for are left out. Returns the command that was clicked.
std::optional<ReplayCommand> draw_toolbar(const Gui& gui, const ReplayPlayback& playback,
                                          const std::vector<TimelineMark>& marks,
                                          const ReplayLook& look, float width_px);

/// Where the timeline lies, and what it spans.
struct TimelineFrame {
  ImVec2 origin;  ///< upper left corner, pixels
  float width_px{0.0F};
  double span_s{1.0};
  double time_s{0.0};
};

/// What the timeline with labels and key takes, in pixels.
[[nodiscard]] float timeline_height(const Gui& gui);

/// Draws the timeline. Returns the time under the mouse while its button is held on the track.
std::optional<double> draw_timeline(const Gui& gui, const std::vector<TimelineMark>& marks,
                                    const TimelineFrame& frame);

}  // namespace impetus::inline viewers
