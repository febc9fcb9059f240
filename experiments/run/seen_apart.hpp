// Whether the eye could tell two poses of a body apart.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/vector.hpp"
#include "engine/scheduling/viewer.hpp"

namespace impetus::inline run {

/// As far apart as this, a body is seen to be elsewhere, or turned. Spheres are not seen to turn.
struct PartingThresholds {
  double position_deg{0.5};  ///< of visual angle, for the scene's viewer
  double turn_deg{10.0};
};

/// Whether the places, or the turns where these show, are so far apart. What is not a number is
/// told from everything.
[[nodiscard]] bool seen_apart(const Pose& x, const Pose& y, bool turns_show, const Viewer& viewer,
                              const PartingThresholds& thresholds = {});

}  // namespace impetus::inline run
