// A figure as one rigid body, and how its parts move beyond that.
//
//   momenta  =  those of a rigid body with the figure's whole momentum  +  internal ones
//
// The internal momenta sum to nothing, linear and angular, and the two energies add up. So the
// internal motion can be made slower or faster, or be kept for later, without touching the figure's
// momentum or pulling at its hinges.
//
// A part without inverse mass, if any, is the root: the figure is fixed there, and all of its
// motion is internal.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "engine/dynamics/motion.hpp"
#include "engine/volumes/enclosure.hpp"

namespace impetus::inline figures {

/// The kinetic energy of a figure's parts (J).
double kinetic_energy(std::span<const BodyModel> parts, std::span<const BodyState> states);

/// The kinetic energy of their whole mass at their centre of mass (J); of a figure that is fixed,
/// nothing.
double energy_of_centre(std::span<const BodyModel> parts, std::span<const BodyState> states);

/// Makes the internal motion such that the kinetic energy is `energy_J`, as far as that can be: at
/// least that of the rigid motion. It grows only where `may_grow`, and by a thousandth at the most.
void bring_to_energy(double energy_J, bool may_grow, std::span<const BodyModel> parts,
                     std::span<BodyState> states);

/// Moves a figure through `dt_s` seconds in the posture that it has: as a whole it goes, falls and
/// turns as a body does, by the rule that keeps energy. Its internal motion goes on after that; but
/// where any of its parts is held, so is the whole, and its internal motion ends: gravity would
/// feed it, step by step, while nothing moves. A figure that is fixed stays as it is. `falls` is
/// empty or has a fall for each part.
void move_as_one_body(double dt_s, std::span<const BodyModel> parts, std::span<const Fall> falls,
                      std::span<BodyState> states);

/// Moves a figure of which a centre is beyond a wall back, as a whole. What it is lifted by comes
/// from its kinetic energy, and is no more than that has. One that is fixed stays where it is.
void move_back_inside(const Enclosure& enclosure, const Vector3& gravity_m_s2,
                      std::span<const BodyModel> parts, std::span<BodyState> states);

}  // namespace impetus::inline figures
