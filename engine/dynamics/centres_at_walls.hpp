// What walls do to the centre of a body, so that nobody leaves the enclosure whatever pushes at its
// contacts were found. None of it turns the body, and in none does its energy grow.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dynamics/body.hpp"
#include "engine/volumes/enclosure.hpp"

namespace impetus::inline dynamics {

/// By how far a centre that is at a wall may be off it (metres).
double wall_rounding_m(const BodyModel& model);

/// Where the way of a step from `from_m` led the centre through a wall, it ends there, with the
/// energy that the body has now; what was left of the step is lost, as for who stops at an entry.
/// One that was beyond a wall before goes on through that, and so does one that passes through
/// others.
void keep_centre_inside(const Enclosure& enclosure, const Vector3& gravity_m_s2,
                        const BodyModel& model, const Vector3& from_m, BodyState& state);

/// Turns a body back whose centre is more than `least_m` beyond a wall and would go on outwards, as
/// if the wall pushed at its centre: what pushes beside it may turn the body ever faster and still
/// let it through. Approaches slower than `resting_m_s` are given nothing back.
void turn_back_at_walls(const Enclosure& enclosure, double least_m, double restitution,
                        double resting_m_s, const BodyModel& model, BodyState& state);

/// By how much a centre is beyond a wall (metres); below 0: within it.
double centre_beyond_m(const Enclosure& enclosure, int wall, const Vector3& centre_m);

/// Takes from a body what would carry its centre through a wall in the next step, of `dt_s`
/// seconds, as if the wall pushed at its centre. One that is beyond it already is moved back to the
/// wall where `brings_back`, which tears at the hinges of a figure.
void stop_at_walls(const Enclosure& enclosure, const Vector3& gravity_m_s2, double dt_s,
                   bool brings_back, const BodyModel& model, BodyState& state);

}  // namespace impetus::inline dynamics
