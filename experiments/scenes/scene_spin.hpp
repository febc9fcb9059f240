// The random change of angular velocity that a scene imposes on two bodies that meet.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "engine/dynamics/imposed_spin.hpp"
#include "experiments/scenes/scene_checks.hpp"

namespace impetus::inline scenes {

/// What /imposed/random_spin imposes in the trial of this seed: each component uniform between its
/// limits, from a stream of its own; none where it is left out or off.
std::optional<ImposedSpinRule> imposed_spin_of(const nlohmann::json& scene, std::uint64_t seed);

/// What is wrong with it beyond the schema.
std::vector<SceneProblem> spin_problems(const nlohmann::json& scene);

}  // namespace impetus::inline scenes
