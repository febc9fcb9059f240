// What a figure must fulfil beyond its schema: a tree of hinges whose angles, names and motions
// fit. SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/scenes/scene.hpp"

namespace impetus::inline scenes {

/// Adds what is wrong with the figure that the scene holds for `file`, each place once.
void add_figure_file_problems(const Scene& scene, const std::string& file, SceneProblems& problems);

/// What is wrong with the angle (degrees) of the joint called `name`, in words; "" when nothing is:
/// the figure has none of the name, or the angle is beyond its limits.
std::string problem_of_angle(const FigureSettings& figure, const std::string& name,
                             double angle_deg);

}  // namespace impetus::inline scenes
