// What a scene file may say of its plane, and of what happens there: rows of scene.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/scenes/scene.hpp"
#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline scenes {

Kind<PlaneSettings> plane_kind();
Kind<GoalSettings> goal_kind();
Kind<LaunchSettings> launch_kind();

}  // namespace impetus::inline scenes
