// What a protocol's design must fulfil beyond its schema; each refusal is one sentence.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "experiments/design/plan.hpp"
#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline protocol {

/// Size, names, pointers, runs and the scale agree with each other and the scene.
/// Throws InputError.
void check_design(const Protocol& protocol);

/// Every practice condition is a cell of the design. Throws InputError.
void check_practice(const Protocol& protocol);

/// The levels that practice is judged by are practised. Throws InputError.
void check_practice_rule(const Protocol& protocol);

/// The plan of a participant of `group`; none: of the study's first. Throws InputError when no
/// order was found that keeps to the longest runs, or the participant's code has no number for a
/// Latin square.
Plan plan_for(const Protocol& protocol, const std::string& participant, std::uint64_t seed,
              const std::optional<Condition>& group = {});

}  // namespace impetus::inline protocol
