// A box that tumbles about its axis of intermediate inertia: the hardest free rotation to keep.
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/engine/builders.hpp"

namespace impetus {

/// The .2 × .4 × .6 m box of 1 kg: m (b² + c²) / 12.
inline BodyModel box_body() {
  BodyModel model = ball(0.4, 1.0);
  model.inverse_inertia =
      Vector3(12.0 / (0.16 + 0.36), 12.0 / (0.04 + 0.36), 12.0 / (0.04 + 0.16)).asDiagonal();
  return model;
}

/// Spinning about the axis of intermediate inertia, a hundredth off it.
inline BodyState tumbling(const BodyModel& model, double spin_rad_s) {
  BodyState state;
  const Vector3 spin(0.01 * spin_rad_s, spin_rad_s, 0.01 * spin_rad_s);
  state.angular_momentum = model.inverse_inertia.inverse() * spin;
  return state;
}

}  // namespace impetus
