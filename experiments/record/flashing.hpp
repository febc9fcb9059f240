// Bodies that flash while a stimulus is still, so that everybody knows which ones are meant.
//
//   colour   own | other | own | other | own      half a period each, from onset on
//
// It is drawing: no step of the world looks at it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "experiments/record/appearance.hpp"

namespace impetus::inline record {

/// Which bodies flash, how often, and until when.
struct Flashing {
  std::vector<std::size_t> bodies;
  double hz{1.0};       ///< times a second that the other colour is shown
  Colour colour{};      ///< that other colour
  double until_s{0.0};  ///< from onset

  /// Whether the other colour is shown.
  [[nodiscard]] bool is_lit_at(double time_s) const {
    constexpr double kOfAPeriod = 1e-9;  // a frame that falls on a change shows it
    const double periods = time_s * hz + kOfAPeriod;
    return time_s < until_s && periods - std::floor(periods) >= 0.5;
  }
};

/// Gives those of `shown`, a scene's bodies by their places, the colour that they have at the time.
template <typename ShownBodies>
void flash(const Flashing& flashing, double time_s, ShownBodies& shown) {
  if (flashing.is_lit_at(time_s)) {
    for (const std::size_t body : flashing.bodies) {
      shown[body].look.colour = flashing.colour;
    }
  }
}

}  // namespace impetus::inline record
