// The candidate pairs of a step and their priority lists, found again for drawing alone.
//
// A step reports the pairs that collided; this tells all that it looked at, from the states before
// and after it. A body's place at the end of the step and its momentum before it are what the step
// itself prioritised by, so the lists agree; but a pair that persistence holds in a higher list is
// told in its own.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/world/world.hpp"

namespace impetus::inline run {

/// `before` are the states that the last step of `world` started from, `input` what it was given.
/// The pairs come by list and by falling priority within each.
std::vector<ScheduledPair> pairs_of_step(const World& world, const std::vector<BodyState>& before,
                                         const StepInput& input);

}  // namespace impetus::inline run
