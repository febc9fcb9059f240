// Where a crowd of figures starts: at random places within its enclosure, in random directions,
// orientations and joint angles, apart from each other and from themselves.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "engine/figures/figure.hpp"
#include "experiments/scenes/crowd.hpp"

namespace impetus::inline scenes {

/// States of the parts of figures that move freely, or none when no room was found for them all in
/// 10,000 draws a figure. Joint angles are uniform within the hinges' limits. Apart are the bounds
/// at level 0 of the parts' trees; `start.radius_m` is not asked.
std::optional<std::vector<BodyState>> figure_crowd_states(const std::vector<Figure>& figures,
                                                          const std::vector<BodyModel>& models,
                                                          const Enclosure& enclosure,
                                                          const CrowdStart& start);

}  // namespace impetus::inline scenes
