// A viewer who goes round the scene: the eye turns about the vertical at a constant rate, and looks
// at the world's origin all the time.
//
//   viewer_at(screen, azimuth + rate · t)      velocity of the eye ω × eye, ω = rate about y
//
// (Dingliana 2002, eq. 5.1: camera motion)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/scheduling/viewer.hpp"

namespace impetus::inline record {

struct ViewerTurn {
  double azimuth_deg{0.0};  ///< at time zero
  double rate_deg_s{0.0};   ///< anticlockwise from above; 0: the viewer stays
};

/// The viewer `time_s` after `start`, which is as it was when nothing turns. The same bits on every
/// machine: a step's viewer follows from its number.
Viewer turned_viewer(const Viewer& start, const ViewerTurn& turn, double time_s);

}  // namespace impetus::inline record
