// Whether every scene that a protocol makes can be shown; each refusal is one sentence.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline protocol {

/// Whether `pointer` leads to a number, text or boolean of the scene.
bool names_single_value(const nlohmann::json& scene, const std::string& pointer);

/// What the scene's schema or the scene itself says against `scene`; "" when it can be shown.
std::string complaint(const nlohmann::json& scene, ShapeLibrary& shapes);

/// Refuses a level at `place` that the schema of scenes does.
void require_level_in_schema(const Protocol& protocol, const FactorLevel& level,
                             const std::string& place);

/// Where a level is written.
using LevelPlace = std::function<std::string(const FactorLevel& level)>;

/// Refuses the level of a scene with a fault that has the same by itself, if there is one.
void refuse_fault(const Protocol& protocol, const Condition& levels, const LevelPlace& place_of,
                  const std::string& message);

/// Every level and every cell, put into the scene, leaves a scene that can be shown. Throws
/// InputError.
void check_levels(const Protocol& protocol);

/// What is shown beside the cells leaves a scene that can be shown. Throws InputError.
void check_scenes_beside(const Protocol& protocol);

/// Bodies that questions are about are in every scene. Throws InputError.
void check_named_bodies(const Protocol& protocol);

/// Every demonstration's scene can be shown and needs no gaze. Throws InputError.
void check_demonstrations(const Protocol& protocol);

/// Where the detail of collisions depends on the gaze, the gaze is followed. Throws InputError.
void check_gaze(const Protocol& protocol);

/// Every duration that must fall on the display's frames does. `allow_rounding` lets an imposed
/// hold be rounded; what was realised is stored. Throws InputError.
void check_frames(const Protocol& protocol, double refresh_hz, bool allow_rounding);

}  // namespace impetus::inline protocol
