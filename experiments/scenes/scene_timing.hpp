// How long a scene lasts, which its file alone tells: nothing is built for it.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

namespace impetus::inline scenes {

/// For how long a scene that is valid by its schema holds two bodies at contact, seconds.
double intended_hold_s(const nlohmann::json& scene);

/// From onset to the end of the stimulus, seconds, with a hold of `hold_s`.
double scene_duration_s(const nlohmann::json& scene, double hold_s);

}  // namespace impetus::inline scenes
