// SPDX-License-Identifier: MIT
#include "experiments/scenes/showing/showing_settings.hpp"

#include "experiments/scenes/appearance_settings.hpp"

namespace impetus::inline scenes {
namespace {

Kind<FlashingSettings> flashing_kind() {
  using Flash = FlashingSettings;
  return object<Flash>(
      "While the scene is still, these bodies change between their own colour and another.",
      {required("bodies", &Flash::bodies, list(text(), {1, 100, true}), "Their names."),
       required("hz", &Flash::hz, number(above(0, 3)),
                "Flashes a second; more than 3 may harm people who are photosensitive."),
       row("colour", &Flash::colour, colour_kind(), "The other colour; white when left out.")});
}

}  // namespace

RowList<ShowingSettings> showing_rows() {
  using Showing = ShowingSettings;
  return {row("still_s", &Showing::still_s, number({0, 60}),
              "At its begin the scene is shown for so long before anything moves, as a whole "
              "number of steps and of frames; 0 when left out."),
          row("flashing", &Showing::flashing, flashing_kind()),
          row("hidden_after_s", &Showing::hidden_after_s, number(above(0, 3600)),
              "The stimulus ends so long after things began to move, though the scene would go on; "
              "left out: it is shown to its end.")};
}

}  // namespace impetus::inline scenes
