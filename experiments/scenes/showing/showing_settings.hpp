// What of a scene is shown: it may begin still, with bodies that flash, and be hidden before its
// time is over.
//
//   onset ── still ──> moves ── hidden_after_s ──> the questions follow     (nobody sees the rest)
//
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/record/appearance.hpp"
#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline scenes {

/// Which bodies flash while the scene is still.
struct FlashingSettings {
  std::vector<std::string> bodies;
  double hz{2.0};
  Colour colour{1.0F, 1.0F, 1.0F};  ///< between their own
};

/// How a scene begins and ends for who sees it.
struct ShowingSettings {
  double still_s{0.0};
  std::optional<FlashingSettings> flashing;
  std::optional<double> hidden_after_s;
};

/// Its rows in a scene's file.
RowList<ShowingSettings> showing_rows();

}  // namespace impetus::inline scenes
