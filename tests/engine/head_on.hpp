// Two balls that meet head on.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tests/engine/builders.hpp"

namespace impetus {

/// Two balls on the x axis that meet after two thirds of a step and then overlap.
inline World head_on(double mass_a_kg, double speed_a_m_s, double mass_b_kg, double speed_b_m_s,
                     WorldSettings settings = {}) {
  const std::vector<BodyModel> models{ball(0.5, mass_a_kg), ball(0.5, mass_b_kg)};
  const double gap_m = (speed_a_m_s - speed_b_m_s) * kStep_s * (2.0 / 3.0);
  return {models,
          {moving(models[0], Vector3::Zero(), {speed_a_m_s, 0.0, 0.0}),
           moving(models[1], {1.0 + gap_m, 0.0, 0.0}, {speed_b_m_s, 0.0, 0.0})},
          settings};
}

/// Of one body along x (m/s).
inline double x_speed(const World& world, std::size_t body) {
  return velocity(world.models()[body], world.states()[body]).x();
}

}  // namespace impetus
