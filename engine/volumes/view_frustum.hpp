// What a viewer sees through the screen, from inside: bodies are kept in view.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/volumes/volume.hpp"

namespace impetus {

/// Six walls: 0 right, 1 left, 2 above, 3 below, 4 towards the eye, 5 away from it.
struct ViewFrustum {
  Vector3 eye{Vector3::UnitZ()};    ///< metres, world; the screen's centre is the origin
  Vector3 right{Vector3::UnitX()};  ///< unit, along the screen
  Vector3 up{Vector3::UnitY()};     ///< unit, along the screen
  double half_width_m{0.0};         ///< of the screen
  double half_height_m{0.0};
  double front_m{0.0};  ///< how far it reaches before the screen, less than the eye
  double back_m{0.0};   ///< and behind it
};

}  // namespace impetus
