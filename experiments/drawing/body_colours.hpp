// Bodies in the colours of their priority or their level of detail, and what the colours mean.
//
//   own ──C──> priority: red list 0, blue lower ones ──C──> level: violet coarse … yellow fine
//   ──C─┐
//    ^─────────────────────────────────────────────────────────────────────────────────────────────┘
//
// Levels differ in lightness as well as in hue, each lighter than the one before, so that no kind
// of colour blindness takes their order away. (Priority: Dingliana 2002, figures 6.20 to 6.22)
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "experiments/record/ports.hpp"
#include "experiments/run/body_detail.hpp"

namespace impetus::inline drawing {

using BodyColour = std::array<float, 3>;  ///< sRGB, 0–1

/// What the colour of a body tells: nothing, for it is its own, or its priority, or its level.
enum class BodyColours { kOwn, kPriority, kLevel };

/// The next of them, and after the last the first.
[[nodiscard]] BodyColours next_colours(BodyColours colours);

/// Red for list 0, blue for the others.
[[nodiscard]] BodyColour colour_of_list(int list);

/// Of a level from 0 to `finest`.
[[nodiscard]] BodyColour colour_of_level(int level, int finest);

/// Gives each body the colour of its detail; paler, in its own, where it has none. One detail per
/// body.
void colour_bodies(std::vector<PosedBody>& bodies, const std::vector<BodyDetail>& details,
                   BodyColours colours, int finest);

/// A colour and what it tells.
struct ColourMeaning {
  BodyColour colour;
  std::string meaning;
};

/// What is seen in these colours; nothing for bodies' own.
[[nodiscard]] std::vector<ColourMeaning> meanings_of(BodyColours colours, int finest);

}  // namespace impetus::inline drawing
