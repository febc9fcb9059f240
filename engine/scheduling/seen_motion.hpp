// How fast things are seen to move, by an eye that may itself move and turn.
//
//   V = v − v_cam − ω_cam × X     X from the eye
//
// A body that moves and turns with the eye is seen standing still. An eye at rest changes no bit.
// (Dingliana 2002, eq. 5.1, corrected: the camera's terms are taken off, in one frame and unit)
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/scheduling/viewer.hpp"

namespace impetus::inline scheduling {

/// The velocity, as the viewer's moving frame has it, of what is at `place` and moves at
/// `velocity` (m/s, world).
Vector3 seen_velocity(const Viewer& viewer, const Vector3& place, const Vector3& velocity);

/// The speed at which its direction from the eye changes (degrees per second): ‖X × V‖ / ‖X‖².
double angular_speed_deg_s(const Viewer& viewer, const Vector3& place, const Vector3& velocity);

/// Metres of screen per second.
struct ScreenVelocity {
  double right_m_s{0.0};
  double up_m_s{0.0};
};

/// How fast its image moves over the screen, f (V_x Z − X V_z) / Z² and likewise upwards, with f
/// from eye to screen and Z the depth; none when it is not before the eye. For pictures and
/// histograms: decisions are made in degrees.
std::optional<ScreenVelocity> projected_velocity(const Viewer& viewer, const Vector3& place,
                                                 const Vector3& velocity);

}  // namespace impetus::inline scheduling
