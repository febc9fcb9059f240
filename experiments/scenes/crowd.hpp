// Where a crowd starts: bodies or figures at random places within its enclosure, apart from each
// other, in random directions and orientations. The same names of streams, the same start, on every
// machine.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/dynamics/body.hpp"
#include "engine/figures/figure.hpp"
#include "engine/volumes/enclosure.hpp"

namespace impetus::inline scenes {

/// How a crowd starts: by which random stream, how large and how fast its bodies are.
struct CrowdStart {
  std::uint64_t seed{1};
  std::string name;      ///< of the random stream: another name, another start
  double radius_m{0.0};  ///< of a ball about the centre of mass that holds a body, at any level
  double speed_m_s{0.0};
  double spin_rad_s{0.0};
};

/// States of bodies alike, or none when no room was found for them all in 10,000 draws a body.
std::optional<std::vector<BodyState>> crowd_states(const std::vector<BodyModel>& models,
                                                   const Enclosure& enclosure,
                                                   const CrowdStart& start);

/// How many postures are drawn for a figure, and how many places for it or a body.
inline constexpr int kMostDraws = 10'000;

/// Whether any of so many postures, drawn as figure_crowd_states() does, has the figure's parts
/// apart from each other.
bool has_posture(const Figure& figure, const std::vector<BodyModel>& models,
                 const CrowdStart& start);

/// States of the parts of figures that move freely, with random joint angles, uniform within the
/// hinges' limits; apart from themselves, too. None when no room was found for them all in 10,000
/// draws a figure. Apart are the bounds at level 0 of the parts' trees; `start.radius_m` is not
/// asked.
std::optional<std::vector<BodyState>> figure_crowd_states(const std::vector<Figure>& figures,
                                                          const std::vector<BodyModel>& models,
                                                          const Enclosure& enclosure,
                                                          const CrowdStart& start);

}  // namespace impetus::inline scenes
