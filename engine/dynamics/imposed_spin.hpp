// A change of angular velocity that is imposed on two bodies when they collide: not physics.
//
// What it keeps and what not: linear momentum and its energy are what the response made them, since
// nothing is done to velocities. Angular momentum is not kept, about any point, and rotational
// energy is whatever the new spin has. (Dingliana 2002, sec. 6.2.2: at the lowest level bodies are
// spheres, whose collisions turn nothing)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dynamics/body.hpp"

namespace impetus::inline dynamics {

/// Added to the angular velocities of both bodies (rad/s, world).
struct ImposedSpin {
  Vector3 a{Vector3::Zero()};
  Vector3 b{Vector3::Zero()};
};

/// When it is imposed: at the first contact that bodies 0 and 1 of the world respond to, if that
/// was found at this level; once in a world's life.
struct ImposedSpinRule {
  int at_level{0};
  ImposedSpin spin;
};

/// Changes the body's angular velocity by `spin_rad_s`; nothing where nothing turns it.
inline void add_spin(const BodyModel& model, const Vector3& spin_rad_s, BodyState& state) {
  state.angular_momentum += angular_momentum_at(model, state.pose.orientation, spin_rad_s);
}

}  // namespace impetus::inline dynamics
