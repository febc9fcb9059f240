// The photodiode patch: a square in a corner of the screen whose light says which frame it is, for
// a photodiode held against the glass.
//
//   frame of the stimulus   .  .  .  0  1  2  3  4  5      .: fixation, and all that is not timed
//   clock                   0  0  0  1  0  1  0  1  0      changes with every frame
//   data                    0  0  0  1  1  1  1  1  1      of a shift register that starts with
//   ones code                    0  0  0  3  1  3  1  3  1      2 · clock + data
//
//   code 0, 1, 2, 3 is shown with 0, 30, 70, 100 % of the light of white.
//
// A threshold at half of white sees the clock: the first rise is the stimulus's onset, then every
// frame is an edge, and a late frame a longer half-wave. Who records the light itself also reads
// the data: any 12 in a row are found once in 4,095 frames, so a frame that was dropped, repeated
// or shown out of turn is seen and named. (Maximum-length sequence of x^12 + x^6 + x^4 + x + 1;
// Golomb 1967)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace impetus::inline record {

/// The opening of a usual photodiode, and a margin. Screens have at least 10 cm a side, so it stays
/// away from their middle.
inline constexpr double kPatchSide_m = 0.015;

/// Frames after which the data come again.
inline constexpr std::int64_t kPatchPeriod = 4095;
/// Data bits in a row that tell the frame.
inline constexpr int kPatchWord = 12;

inline constexpr std::int64_t kPatchCodes = 4;
/// Of whatever is no frame of a stimulus.
inline constexpr std::int64_t kDarkPatch = 0;

/// The code of a frame of a stimulus, counted from its onset.
std::int64_t patch_code(std::int64_t frame);

/// What the square is drawn with, as an sRGB grey from 0 to 1. Precondition: 0 ≤ code ≤ 3.
float patch_grey(std::int64_t code);

/// Where the square is drawn.
enum class ScreenCorner { kTopLeft, kTopRight, kBottomLeft, kBottomRight };

/// "top left", "top right", "bottom left", "bottom right".
const char* name_of(ScreenCorner corner);

/// The corner of this name, hyphens being as good as blanks; none: there is none.
std::optional<ScreenCorner> corner_named(std::string name);

/// The same, as an option of the command line names it. Throws InputError, naming the option.
ScreenCorner patch_corner(const std::string& option, const std::string& name);

}  // namespace impetus::inline record
