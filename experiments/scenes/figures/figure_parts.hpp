// A figure's parts and hinges: from shares of its height to the shapes and hinges of a world.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/figures/hinge.hpp"
#include "engine/trees/tree_settings.hpp"

namespace impetus::inline scenes {

/// A part's shape as a scene would name it. `coarsest` is what swept parts are at level 0 where
/// they do not say it themselves; "": nothing is said.
nlohmann::json part_shape(const nlohmann::json& part, double height_deg,
                          const std::string& coarsest);

/// The trees of a part, where those of the engine are so.
TreeSettings part_tree(const nlohmann::json& part, TreeSettings engine);

/// The hinge by which part `index` of the figure hangs, as between the parts of a figure whose root
/// is body `root`; for a figure `height_m` high. Precondition: valid by the figure's schema, with
/// directions of some length and a parent among the parts.
Hinge part_hinge(const nlohmann::json& figure, std::size_t index, std::int32_t root,
                 double height_m);

/// By what scenes and motions call the joints: the hinge's number, or one past the last.
std::size_t joint_named(const nlohmann::json& figure, const std::string& name);

/// An angle for each joint (radians): those of `angles_deg` by name, the rest angles else.
std::vector<double> joint_angles(const nlohmann::json& figure, const nlohmann::json& angles_deg);

/// The number of the part called `name`, or one past the last.
std::size_t part_named(const nlohmann::json& figure, const std::string& name);

}  // namespace impetus::inline scenes
