// Crowds in closed cubes that are too small for them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/extremes/building_blocks.hpp"
#include "experiments/extremes/crowd_scene.hpp"
#include "experiments/extremes/extreme_cases.hpp"

namespace impetus::inline extremes {
namespace {

std::vector<ExtremeScene> crowds(Length length) {
  std::vector<ExtremeScene> scenes;
  const std::int64_t steps = length == Length::kQuick ? 240 : 1200;
  for (const double filled : {0.3, 1.5, 2.0}) {
    for (const double restitution : {0.5, 1.0}) {
      scenes.push_back(crowd_scene(100, filled, restitution, steps));
    }
  }
  return scenes;
}

double energy_error(const Course& course) {
  if (!course.finite()) {
    return std::numeric_limits<double>::infinity();
  }
  return course.scene().settings.restitution == 1.0 ? energy_swing(course) : energy_gain(course);
}

/// How far the centre of any body came beyond a wall (m).
double beyond_walls_m(const Course& course) {
  const double half_m = std::get<ClosedCube>(*course.scene().settings.enclosure).half_edge_m;
  double farthest = 0.0;
  for (std::size_t body = 0; body < course.scene().bodies.size(); ++body) {
    farthest = std::max({farthest, course.greatest_m(body).maxCoeff() - half_m,
                         -course.least_m(body).minCoeff() - half_m});
  }
  return course.finite() ? farthest : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<ExtremeCase> crowd_cases() {
  return {{"crowd pressure",
           "crowd",
           {{"100 blocks that fill 30 to 200 % of a cube keep their energy (at restitution .5: "
             "gain none) within a share of",
             1e-9, "", energy_error},
            {"and none of their centres leaves the cube, by", 0.0, "m", beyond_walls_m}},
           crowds}};
}

}  // namespace impetus::inline extremes
