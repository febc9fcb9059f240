// Bodies that are too fast to be tested where the step ends alone are tested along their ways, and
// stop where they first touch.
//
//   entries   of the fast pairs, on the ways the bodies would take
//   stop      both bodies of the earliest; they are moved anew, by less, and their pairs are looked
//             at again; and so on until no pair has an entry
//   at last   bodies that are stopped too often stop together with all that they could meet, at the
//             first entry there was before anybody stopped
//
// Safe when no entry is left: every fast pair was found free of one on the ways both took. A stop
// changes a way only after it, and by the turn of the shorter step; both are looked at again. Safe
// at last too: until the first entry nobody had stopped, so all were on the ways that were looked
// at first, on which no pair had touched by then; and no body meets one that is not its candidate.
// What a stopped body lost of the step is lost; its momenta are not touched, it fell for the
// shorter step and turned by what the integrator makes of the shorter step, so its energy is as
// good as after any step (at last: as that of a pose between two steps). (Mirtich 1996; Dingliana
// 2002, sec. 5.3.2)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/collision/time_of_entry.hpp"
#include "engine/collision/tunnelling.hpp"
#include "engine/dynamics/body.hpp"
#include "engine/dynamics/motion.hpp"
#include "engine/scheduling/work_costs.hpp"

namespace impetus {

/// How often a body is stopped in a step before it is stopped together with others.
inline constexpr int kMostStops = 16;

/// A step as it was made, of bodies that were not stopped: their states before it and their trees.
struct StepMade {
  double dt_s;
  const std::vector<BodyModel>& models;
  const std::vector<BodyState>& before;
  const std::vector<PairBounds>& candidates;
  int greatest_level;  ///< that any pair may be refined to
  const WorkCosts& costs;
  Rotation rotation;
  int most_stops{kMostStops};
  /// Of each body; none: nothing falls. A body that falls is looked at on the way from where it was
  /// to where it stops, straight as its turn is steady: so the ways of all bodies join from step to
  /// step, and none passes another on them unseen.
  std::span<const Fall> falls{};
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
