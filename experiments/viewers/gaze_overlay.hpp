// Where a viewer looks, and the region about it, drawn over a picture.
//
//      ___
//     / | \      the cross is the fixation; the circle is where the cone of the region's angle
//    | -+- |     about its centre meets the glass
//     \_|_/
//
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/scheduling/priority_lists.hpp"
#include "experiments/drawing/picture_map.hpp"
#include "experiments/gaze/gaze_trail.hpp"

namespace impetus::inline viewers {

/// All draw into the current ImGui window, within the picture. `own` is the viewer whose gaze it
/// is: it lies on that viewer's glass, wherever the picture is seen from.
void draw_gaze(const PictureMap& map, const Viewer& own, const ScreenPoint& fixation);

/// Nothing for a region that holds all the view.
void draw_region(const PictureMap& map, const Viewer& own, const GazeRegion& region);

/// The samples of the last moments, paler the older; a gap where they were lost, and in words why
/// the newest is.
void draw_trail(const PictureMap& map, const Viewer& own, const GazeTrail& trail);

}  // namespace impetus::inline viewers
