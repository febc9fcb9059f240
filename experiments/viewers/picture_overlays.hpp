// What is drawn over a picture: contacts, where somebody looks, what colours mean, words.
//
//   ·      the contact of two overlapping nodes, red       ___
//   ●──▶   a contact that the reduction left, yellow,     / | \    the cross is the fixation; the
//          with its normal                               | -+- |   circle is where the cone of the
//                                                         \_|_/    region's angle meets the glass
//
// All draw into the current ImGui window. (Dingliana 2002, figure 6.3)
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "engine/scheduling/priority_lists.hpp"
#include "experiments/drawing/body_colours.hpp"
#include "experiments/drawing/picture_map.hpp"
#include "experiments/gaze/gaze_trail.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline viewers {

/// The length of a normal's arrow, as a share of the largest body's radius.
inline constexpr double kArrowShare = 0.7;

/// `opacity` from 0 to 1, here as below.
void mark_node_contact(const PictureMap& map, const Vector3& place, double opacity);
void mark_contact(const PictureMap& map, const Vector3& place, const Vector3& tip, double opacity);

/// An arrow, and a line, each on a light ground that sets it off from dark bodies.
void mark_arrow(const PictureMap& map, const Vector3& from, const Vector3& to, ImU32 ink);
void mark_line(const PictureMap& map, const Vector3& from, const Vector3& to, ImU32 ink);

/// `own` is the viewer whose gaze it is, here as below: it lies on that viewer's glass, wherever
/// the picture is seen from.
void draw_gaze(const PictureMap& map, const Viewer& own, const ScreenPoint& fixation);

/// Nothing for a region that holds all the view.
void draw_region(const PictureMap& map, const Viewer& own, const GazeRegion& region);

/// The samples of the last moments, paler the older; a gap where they were lost, and in words why
/// the newest is.
void draw_trail(const PictureMap& map, const Viewer& own, const GazeTrail& trail);

/// What colours mean, one below the other in the area's lower left corner; nothing where there is
/// nothing to tell.
void draw_colour_legend(const Gui& gui, const PixelArea& area,
                        const std::vector<ColourMeaning>& meanings);

/// The same in as few lines as it can along the area's lower edge, so that it covers little.
void draw_colour_line(const Gui& gui, const PixelArea& area,
                      const std::vector<ColourMeaning>& meanings);

/// Words in the area's upper left corner, legible on whatever is there; nothing for "".
void draw_badge(const Gui& gui, const PixelArea& area, const std::string& words);

}  // namespace impetus::inline viewers
