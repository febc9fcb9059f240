// The one set of colours: dark on grey. Participants' pages have the pictures' mid-grey, so that
// eyes need not adapt between them, or, as the researcher's viewers, a lighter one; words can be
// read on both (4.4 to 1 at least, WCAG's contrast).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace impetus::inline drawing::palette {

/// A colour in 32 bits: red in the lowest byte, then green and blue, and nothing shines through.
constexpr std::uint32_t opaque(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
  return red | green << 8U | blue << 16U | 0xff000000U;
}

inline constexpr float kLightGrey = 202.0F / 255.0F;  ///< sRGB
inline constexpr float kPictureGrey = 0.5F;
inline constexpr std::uint32_t kLight = opaque(202, 202, 202);
inline constexpr std::uint32_t kPicture = opaque(128, 128, 128);
inline constexpr std::uint32_t kText = opaque(12, 12, 12);
inline constexpr std::uint32_t kQuietText = opaque(24, 24, 26);
inline constexpr std::uint32_t kSurface = opaque(226, 226, 226);  ///< buttons, fields
inline constexpr std::uint32_t kSurfaceHovered = opaque(238, 238, 238);
inline constexpr std::uint32_t kLine = opaque(146, 146, 148);
inline constexpr std::uint32_t kAccent = opaque(12, 44, 80);  ///< focus, what is chosen
inline constexpr std::uint32_t kOnAccent = opaque(245, 245, 245);
inline constexpr std::uint32_t kWarning = opaque(64, 0, 0);

inline constexpr std::uint32_t kContact = opaque(160, 40, 32);
inline constexpr std::uint32_t kHold = opaque(196, 142, 42);
inline constexpr std::uint32_t kFineCollision = opaque(40, 96, 168);
inline constexpr std::uint32_t kCoarseCollision = opaque(204, 92, 20);
inline constexpr std::uint32_t kClick = opaque(28, 28, 30);
inline constexpr std::uint32_t kResponse = opaque(30, 110, 62);
inline constexpr std::uint32_t kLateFrame = opaque(106, 62, 136);
inline constexpr std::uint32_t kGazeLost = opaque(120, 120, 124);
inline constexpr std::uint32_t kParting = opaque(200, 30, 120);

}  // namespace impetus::inline drawing::palette
