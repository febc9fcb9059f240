// From a figure's settings, in shares of its height, to the shapes, trees, hinges and motions of
// one that is so high.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/figures/hinge.hpp"
#include "engine/figures/joint_motion.hpp"
#include "experiments/scenes/figures/figure_settings.hpp"

namespace impetus::inline scenes {

/// A part's shape as a scene would have it, in the unit of `height`. `sphere_first` is what swept
/// parts are at level 0 where they do not say it themselves; none: nothing is said.
ShapeSettings part_shape(const PartSettings& part, double height,
                         std::optional<bool> sphere_first = {});

/// The trees of a part, where those of the engine are so.
TreeSettings part_tree(const PartSettings& part, TreeSettings engine);

/// The hinge by which part `index` of the figure hangs, as between the parts of a figure whose root
/// is body `root`; for a figure `height_m` high. Precondition: directions have some length, and the
/// parent is among the parts.
Hinge part_hinge(const FigureSettings& figure, std::size_t index, std::int32_t root,
                 double height_m);

/// An angle for each joint (radians): those of `angles_deg` by name, the rest angles else.
std::vector<double> joint_angles(const FigureSettings& figure, const AnglesByJoint& angles_deg);

/// A motion of the figure for one `height_m` high; joints that it does not name stay at
/// `angles_rad`. The root's start and velocity are the caller's to set. Precondition: the figure
/// has the motion's joints.
JointMotion joint_motion(const FigureSettings& figure, const MotionSettings& motion,
                         double height_m, const std::vector<double>& angles_rad);

/// The names of the joints that the motion moves, in alphabetical order, each once.
std::vector<std::string> joints_of(const MotionSettings& motion);

}  // namespace impetus::inline scenes
