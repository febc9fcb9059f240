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
#include "experiments/stage/picture_map.hpp"

namespace impetus {

/// Both draw into the current ImGui window, within the picture.
void draw_gaze(const PictureMap& map, const ScreenPoint& fixation);

/// Nothing for a region that holds all the view.
void draw_region(const PictureMap& map, const GazeRegion& region);

}  // namespace impetus
