// Marks that overlays draw over a picture: contacts before and after their reduction, arrows.
// (Dingliana 2002, figure 6.3)
// SPDX-License-Identifier: MIT
#pragma once

#include <imgui.h>

#include "experiments/drawing/picture_map.hpp"

namespace impetus::inline drawing {

/// The length of a normal's arrow, as a share of the largest body's radius.
inline constexpr double kArrowShare = 0.7;

inline ImVec2 pixel(const WindowPoint& point) { return {point.x, point.y}; }

/// Red: the contact of two overlapping nodes. `opacity` from 0 to 1, here as below.
void mark_node_contact(ImDrawList& draw, const PictureMap& map, const Vector3& place,
                       double opacity);

/// Yellow, with its normal: a contact that the reduction left.
void mark_contact(ImDrawList& draw, const PictureMap& map, const Vector3& place, const Vector3& tip,
                  double opacity);

void mark_arrow(ImDrawList& draw, const PictureMap& map, const Vector3& from, const Vector3& to,
                ImU32 ink);

}  // namespace impetus::inline drawing
