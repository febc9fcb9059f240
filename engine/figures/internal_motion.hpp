// How a figure moves beyond what it would as one rigid body, and the energy in it.
//
//   momenta  =  those of a rigid body with the figure's whole momentum  +  internal ones
//
// The internal momenta sum to nothing, linear and angular, and the two energies add up: so the
// internal motion can be made slower or faster without touching the figure's momentum or pulling
// at its hinges.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "engine/figures/hinge_solver.hpp"

namespace impetus::inline figures {

/// The kinetic energy of a figure's parts (J).
double kinetic_energy(std::span<const BodyModel> parts, std::span<const BodyState> states);

/// Makes the internal motion such that the kinetic energy is `energy_J`, as far as that can be: at
/// least that of the rigid motion. It grows only where `may_grow`, and by a thousandth at the most.
/// A part without inverse mass, if any, is the root, and nothing is rigid motion then.
void bring_to_energy(double energy_J, bool may_grow, std::span<const BodyModel> parts,
                     std::span<BodyState> states);

}  // namespace impetus::inline figures
