// Which kind of volume a node gets.
//
//   kind        cost    one overlap test of two such volumes, relative to 4 for two spheres
//   sphere         4
//   line           9
//   box           25
//   rectangle     30
//
// `swept` takes what reaches least beyond the object, the cheapest of those within 2 %.
// `heterogeneous` takes the least reach × √cost. A tree refined by one level costs about eight
// times the tests and errs about a third as much, so an error falls as the square root of what is
// spent on it: a dearer volume is worth its tests when it does better than that.
// (after Dingliana 2002, sec. 7.3)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/trees/builders/volume_fits.hpp"
#include "engine/trees/tree_settings.hpp"

namespace impetus::inline trees {

/// The fit of the kind of volume that suits `kind` best, round the part that `shape` is of. A reach
/// below `negligible_m` counts as that. Precondition: `kind` is kBox, kSwept or kHeterogeneous.
Fit best_fit(TreeKind kind, const PartShape& shape, const RoughDistance& solid,
             const Matrix3& parent_frame, Effort effort, double negligible_m);

}  // namespace impetus::inline trees
