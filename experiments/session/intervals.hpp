// The stimuli of a trial: one, or two of which one is to be chosen.
//
//   one interval    the condition's own
//   two intervals   own, standard   or   standard, own      drawn with the trial's seed
//
// The standard is the same trial with some levels replaced: it starts alike and draws alike, so
// that nothing but those levels sets the two apart.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "experiments/design/plan.hpp"
#include "experiments/record/script.hpp"

namespace impetus::inline session {

/// The condition with the standard's levels in place of its own.
Condition standard_of(const Condition& condition, const TwoIntervalQuestion& question);

/// Which interval shows the condition's own stimulus, 1 or 2; 1 where there is one interval. It
/// follows from the trial's seed alone, by a random stream of its own.
std::int64_t test_interval(const Script& script, const PlannedTrial& trial);

/// What the trial shows, in order: itself, and the standard where the script asks for two.
std::vector<PlannedTrial> stimuli_of(const Script& script, const PlannedTrial& trial);

}  // namespace impetus::inline session
