// SPDX-License-Identifier: MIT
#include "experiments/scenes/plane/plane_rows.hpp"

namespace impetus::inline scenes {

Kind<PlaneSettings> plane_kind() {
  using P = PlaneSettings;
  return object<P>(
      "The plane of the screen, seen from above like a table, in pixels of its own: what ends in "
      "_px counts in them, to the right and up. It stands on the screen in degrees, whatever the "
      "screen's own pixels are.",
      {required("px_per_deg", &P::px_per_deg, number(above(0, 1000))),
       required("origin_px", &P::origin_px, several<2>(number({-1e5, 1e5})),
                "Of the plane, the point at the screen's centre.")});
}

Kind<GoalSettings> goal_kind() {
  using G = GoalSettings;
  return object<G>(
      "A body is through when its centre has crossed a line of the plane. The stimulus ends "
      "follow_s after that, or after what keeps it from the line has sent it back, and when its "
      "time is over.",
      {required("body", &G::body, text()),
       required("side", &G::side,
                choice<G::Side>({{"left", G::Side::kLeft},
                                 {"right", G::Side::kRight},
                                 {"below", G::Side::kBelow},
                                 {"above", G::Side::kAbove}}),
                "Where it is when it is through."),
       required("line_px", &G::line_px, number({-1e5, 1e5}),
                "The line's place along x (left, right) or y."),
       row("missed_at", &G::missed_at, list(text(), {1, 100, true}),
           "Bodies that end it, too, once one of them is touched and sends it back; none when left "
           "out."),
       required("follow_s", &G::follow_s, number({0, 60}))});
}

Kind<LaunchSettings> launch_kind() {
  using L = LaunchSettings;
  return object<L>(
      "A launch that is imposed, whatever the bodies are: one moves towards another that rests and "
      "stops before it, at it or over it; after /imposed/contact_hold_ms the other moves off. Both "
      "pass through all bodies.",
      {required("first", &L::first, text(), "Who moves: a disc, a prism or a box."),
       required("second", &L::second, text(), "Who rests where its position_px says, another."),
       required("speed_px_s", &L::speed_px_s, number(above(0, 1e5))),
       row("direction_deg", &L::direction_deg, number({-360, 360}),
           "Where both move to: 0, when left out, to the right, 90 up."),
       required(
           "gap_px", &L::gap_px, number({-1e5, 1e5}),
           "Between their outlines along the way where the first stops; below 0, so far does it "
           "move on from where they touch."),
       row("second_speed_px_s", &L::second_speed_px_s, number({0, 1e5}),
           "As speed_px_s when left out."),
       row("appears_px", &L::appears_px, number({0, 1e5}),
           "The second is not there until the gap is so small; from onset when left out."),
       required("lead_s", &L::lead_s, number(above(0, 60)),
                "From onset until the first stops: a whole number of steps and of frames."),
       required("follow_s", &L::follow_s, number({0, 60}),
                "From when the second moves off to the end of the stimulus.")});
}

}  // namespace impetus::inline scenes
