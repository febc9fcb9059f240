// How far a volume seems to reach beyond an object: measured at points, for choosing among fits.
// The certified bound is NodeDescription's.
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "engine/trees/builders/rough_distance.hpp"
#include "engine/volumes/volume.hpp"

namespace impetus::inline trees {

/// How finely a reach is measured, and where to stop.
struct ReachSettings {
  int most_questions{120};  ///< distances asked for, corners not counted
  double enough_m{std::numeric_limits<double>::infinity()};
};

/// Metres, never negative: the greatest signed distance to the solid from points on the faces of a
/// box; for swept volumes the radius plus the greatest along the core, more than the truth where
/// the nearest surface lies askew. Faces are halved where they might hold a greater distance, to
/// within 2 % or 1e-3 of the volume's size, as long as questions last. Any value above `enough_m`
/// may be returned once it is known to be exceeded.
double reach_beyond_m(const Volume& volume, const DistanceToUse& solid,
                      const ReachSettings& settings = {});

}  // namespace impetus::inline trees
