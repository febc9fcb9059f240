// The motions that a figure file names, as the engine moves joints by them.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/figures/joint_motion.hpp"

namespace impetus::inline scenes {

/// The motion `name` of the figure for one `height_m` high; joints that it does not name stay at
/// `angles_rad`. The root's start and velocity are the caller's to set. Precondition: the figure is
/// valid by its schema, has the motion, and the motion's joints.
JointMotion figure_motion(const nlohmann::json& figure, const std::string& name, double height_m,
                          const std::vector<double>& angles_rad);

/// The names of the joints that the motion moves, in alphabetical order, each once.
std::vector<std::string> joints_of(const nlohmann::json& motion);

}  // namespace impetus::inline scenes
