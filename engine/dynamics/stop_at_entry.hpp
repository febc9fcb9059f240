// Bodies that are too fast to be tested where the step ends alone are tested along their ways, and
// stop where they first touch.
//
//   round     entries of the fast pairs on the bodies' present ways, by rising time: both bodies
//             stop at it, unless one of them was stopped before it in this round
//   again     while a body was stopped: it is moved anew, by less, and its pairs are looked at
//   again at last   bodies that no number of rounds settled stop together, at the first entry of
//   all that
//             they could meet
//
// Safe when the rounds end: every fast pair was found free of an entry on the ways both took. A
// stop changes a way only after it, and by the turn of the shorter step; both are what the next
// round looks at. Safe at last too: until the first entry nobody was stopped, so all took the ways
// of the first round, on which no pair had touched by then; and no body meets one that is not its
// candidate. What a stopped body lost of the step is lost; its momenta are not touched, and what
// it turned by is what the integrator makes of the shorter step, so its energy is as good as after
// any step (at last: as that of a pose between two steps).
// (Mirtich 1996; Dingliana 2002, sec. 5.3.2)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/collision/time_of_entry.hpp"
#include "engine/collision/tunnelling.hpp"
#include "engine/dynamics/body.hpp"
#include "engine/dynamics/motion.hpp"
#include "engine/scheduling/work_costs.hpp"

namespace impetus {

/// Rounds before the bodies that are left are stopped together.
inline constexpr int kMostStoppingRounds = 16;

/// A step as it was made, of bodies that were not stopped: their states before it and their trees.
struct StepMade {
  double dt_s;
  const std::vector<BodyModel>& models;
  const std::vector<BodyState>& before;
  const std::vector<PairBounds>& candidates;
  int greatest_level;  ///< that any pair may be refined to
  const WorkCosts& costs;
  Rotation rotation;
};

struct Stopping {
  std::vector<StoppedAtEntry> stopped;  ///< in the order of the candidates
  std::int64_t work{0};                 ///< of all tests along the ways
};

/// Puts the bodies of `states`, which are at the end of the step, back to where they must stop.
/// Leaves `placed` anywhere.
Stopping stop_at_entry(const StepMade& step, std::vector<BodyState>& states,
                       std::vector<PlacedTree>& placed);

}  // namespace impetus
