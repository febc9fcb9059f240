// How far a volume reaches beyond a solid at worst: a bound that holds, by branch and bound.
//
//   V = core ⊕ ball, cut into cells { k + r w : k in a box, r in a range, w in a cone }
//
// Every cell lies in V. A ball that is known to lie in the solid, of centre a and radius ρ, bounds
// the distance of a cell's points to the solid by max ‖p − a‖ − ρ, which is exact over such a cell.
// Cells are halved, the worst first, until the bound meets the greatest distance found.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/surface_distance.hpp"
#include "engine/volumes/volume.hpp"

namespace impetus::inline trees {

/// The bound exceeds the truth by at most this share of itself, or by kFitResolution of the
/// volume's bounding radius where that is more.
inline constexpr double kFitTolerance = 0.02;
inline constexpr double kFitResolution = 1e-3;

/// Greatest distance from a point of `volume` to the solid (metres): an upper bound always, within
/// the tolerance unless it takes more than `most_questions` distances. 0 only when the volume lies
/// in the solid. A result at or below `indifferent_m` may be any bound that is not above
/// `indifferent_m`.
double fit_error_m(const Volume& volume, const SurfaceDistance& solid, double indifferent_m = 0.0,
                   int most_questions = 1000);

}  // namespace impetus::inline trees
