// A moment of a replay as a picture, with what was asked to be seen over it.
//
//   words          in the upper left corner: what it is
//   own view       as the participant saw it; the gaze and the region lie on the glass, so from
//                  elsewhere they are seen where the glass was
//
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/viewers/replays/replay_keys.hpp"
#include "experiments/viewers/volume_levels.hpp"
#include "experiments/viewing/replay_view.hpp"
#include "experiments/window/canvas.hpp"

namespace impetus::inline viewers {

/// What is left of the window's width between the margins, and the margin round everything.
[[nodiscard]] float content_width(const Gui& gui);
[[nodiscard]] float screen_margin(const Gui& gui);

/// How many pictures lie beside each other, between the words above and the buttons below.
struct Panes {
  int count{1};
  float header_px{0.0F};
  float footer_px{0.0F};
};

/// The largest that fit, from left to right, with the shape of the recorded screen.
[[nodiscard]] std::vector<PixelArea> pane_areas(const Panes& panes, const Gui& gui,
                                                const ScreenGeometry& screen);

/// What a picture is of, and where it lies.
struct ReplayMoment {
  const ReplayView* replay{nullptr};
  double time_s{0.0};
  PixelArea area;  ///< of the window, with the shape of the recorded screen
  std::string words;
};

/// The pictures of one pane.
class ReplayPicture {
 public:
  explicit ReplayPicture(Canvas& canvas) : canvas_(canvas) {}

  /// Bodies and volumes. Before the frame of ImGui that draw_over() draws into.
  void paint(const ReplayMoment& moment, const ReplayLook& look);

  /// Contacts, gaze, legend and words.
  void draw_over(const ReplayMoment& moment, const ReplayLook& look) const;

 private:
  Canvas& canvas_;
  VolumeLevels volumes_;
};

}  // namespace impetus::inline viewers
