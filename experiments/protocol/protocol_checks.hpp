// What a protocol must fulfil beyond its schema; each refusal is one sentence.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "experiments/protocol/protocol_file.hpp"
#include "experiments/session/plan.hpp"

namespace impetus {

/// Size, names, pointers, runs and the scale agree with each other and the scene.
/// Throws InputError.
void check_design(const JsonDocument& protocol, const JsonDocument& scene);

/// Every level and every cell, put into the scene, leaves a scene that can be shown. Throws
/// InputError.
void check_levels(const Protocol& protocol);

/// Every practice condition is a cell of the design. Throws InputError.
void check_practice(const JsonDocument& protocol);

/// The levels that practice is judged by are practised. Throws InputError.
void check_practice_rule(const JsonDocument& protocol);

/// Every demonstration's scene can be shown and needs no gaze. Throws InputError.
void check_demonstrations(const Protocol& protocol);

/// Where the detail of collisions depends on the gaze, the gaze is followed. Throws InputError.
void check_gaze(const Protocol& protocol);

/// A participant's plan. Throws InputError when no order was found that keeps to the longest runs.
Plan plan_for(const Protocol& protocol, const std::string& participant, std::uint64_t seed);

/// A simulated participant who answers on scales of `observer_points` can answer on the protocol's.
/// Throws InputError.
void check_scale_for_observer(const Protocol& protocol, std::size_t observer_points);

/// Every duration that must fall on the display's frames does. `allow_rounding` lets an imposed
/// hold be rounded; what was realised is stored. Throws InputError.
void check_frames(const Protocol& protocol, double refresh_hz, bool allow_rounding);

}  // namespace impetus
