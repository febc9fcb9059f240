// Factors between participants: a participant has one level of each, and the trials of that group.
//
//   groups   fast, tracked   slow, tracked   fast, fixed   slow, fixed
//   so far        3               2               2             3         participants
//                                 └───────┬───────┘
//                      drawn among those with the fewest, by seed and code
//
// What was drawn is kept in the plan, so that nothing later depends on who else took part.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/design/plan.hpp"

namespace impetus::inline design {

/// Every combination of the levels of the factors between participants; one empty condition for a
/// design without such factors.
std::vector<Condition> groups(const Design& design);

/// What of the condition says in which group the participant is.
Condition group_of(const Design& design, const Condition& condition);

/// The participant's group, where `earlier` are the groups of those who were planned for before.
Condition draw_group(const Design& design, const PlanKey& key,
                     const std::vector<Condition>& earlier);

/// The condition, which lacks the levels between participants, with those of the group: in the
/// order of the design's factors.
Condition with_group(const Condition& condition, const Condition& group, const Design& design);

/// The same under every group in turn.
std::vector<Condition> in_every_group(const Condition& condition, const Design& design);

/// The design of a participant of the group, practice and catch trials included. The design itself
/// where it has no factor between participants.
Design design_of_group(Design design, const Condition& group);

}  // namespace impetus::inline design
