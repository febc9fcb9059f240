// Rotations by the implicit midpoint rule, of eight bodies at a time: what free motion takes most
// of.
//
//   ω = R_mid I⁻¹ R_midᵀ L      R_mid is half way between the old rotation and the new one
//
// Each iteration waits for roots and quotients of the one before; those of bodies that know nothing
// of each other are taken together. Lanes never meet, so a body turns to the same bits alone and
// among others, at every width.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "engine/dynamics/body.hpp"
#include "engine/numerics/lanes.hpp"

namespace impetus::inline dynamics {

/// Bodies that wait for their turn; each number of theirs is a row of lanes.
class TurningBodies {
 public:
  /// The state must stay where it is until turn(). Precondition: not full.
  void put(const BodyModel& model, BodyState& state, double dt_s);

  [[nodiscard]] bool is_full() const { return count_ == kLanes; }

  /// Turns all that were put, and waits for others.
  void turn(LaneWidth width = widest_lanes());

  /// What they turn by.
  struct Rows {
    double orientation[4][kLanes];  ///< x, y, z, w
    double momentum[3][kLanes];
    double inverse_inertia[9][kLanes];  ///< row by row
    double dt_s[kLanes];
  };

 private:
  int count_{0};
  std::array<BodyState*, kLanes> states_;
  Rows rows_;
};

}  // namespace impetus::inline dynamics
