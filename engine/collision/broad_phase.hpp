// Candidate pairs: those whose bounding spheres could meet within the step.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/scheduling/priority.hpp"

namespace impetus::inline collision {

/// What the broad phase needs of a body: its bound at the end of the step, how far it moved in
/// it (metres), and whether anything can move it.
struct MovedBound {
  Sphere bound;
  double travelled_m{0.0};
  bool movable{true};
};

/// Whether the bounds, grown by the distance both travelled, touch. a comes before b.
bool could_meet(const MovedBound& a, const MovedBound& b);

/// Every pair that could meet; in order of (b, a). Two immovable bodies never pair. All pairs are
/// tested: SweepAndPrune finds the same ones sooner.
/// (Dingliana 2002, sec. 5.3.2: space-time bounds)
std::vector<PairBounds> candidate_pairs(const std::vector<MovedBound>& bodies);

/// What candidate_pairs(bodies) returns, in place of what `pairs` held.
void find_among_all(const std::vector<MovedBound>& bodies, std::vector<PairBounds>& pairs);

}  // namespace impetus::inline collision
