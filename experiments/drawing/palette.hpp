// The one set of colours: dark on grey. Participants' pages have the pictures' mid-grey, so that
// eyes need not adapt between them, or, as the researcher's viewers, a lighter one; words can be
// read on both (4.4 to 1 at least, WCAG's contrast).
// SPDX-License-Identifier: MIT
#pragma once

#include <imgui.h>

namespace impetus::inline drawing::palette {

inline constexpr float kLightGrey = 202.0F / 255.0F;  ///< sRGB
inline constexpr float kPictureGrey = 0.5F;
inline constexpr ImU32 kLight = IM_COL32(202, 202, 202, 255);
inline constexpr ImU32 kPicture = IM_COL32(128, 128, 128, 255);
inline constexpr ImU32 kText = IM_COL32(12, 12, 12, 255);
inline constexpr ImU32 kQuietText = IM_COL32(24, 24, 26, 255);
inline constexpr ImU32 kSurface = IM_COL32(226, 226, 226, 255);  ///< buttons, fields
inline constexpr ImU32 kSurfaceHovered = IM_COL32(238, 238, 238, 255);
inline constexpr ImU32 kLine = IM_COL32(146, 146, 148, 255);
inline constexpr ImU32 kAccent = IM_COL32(12, 44, 80, 255);  ///< focus, what is chosen
inline constexpr ImU32 kOnAccent = IM_COL32(245, 245, 245, 255);
inline constexpr ImU32 kWarning = IM_COL32(64, 0, 0, 255);

inline constexpr ImU32 kContact = IM_COL32(160, 40, 32, 255);
inline constexpr ImU32 kHold = IM_COL32(196, 142, 42, 255);
inline constexpr ImU32 kFineCollision = IM_COL32(40, 96, 168, 255);
inline constexpr ImU32 kCoarseCollision = IM_COL32(204, 92, 20, 255);
inline constexpr ImU32 kClick = IM_COL32(28, 28, 30, 255);
inline constexpr ImU32 kResponse = IM_COL32(30, 110, 62, 255);
inline constexpr ImU32 kLateFrame = IM_COL32(106, 62, 136, 255);
inline constexpr ImU32 kGazeLost = IM_COL32(120, 120, 124, 255);
inline constexpr ImU32 kParting = IM_COL32(200, 30, 120, 255);

}  // namespace impetus::inline drawing::palette
