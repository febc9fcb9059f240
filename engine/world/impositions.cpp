// SPDX-License-Identifier: MIT
#include "engine/world/impositions.hpp"

#include <cstdint>

#include "engine/numerics/at.hpp"

namespace impetus::inline world {
namespace {

void hold(double hold_s, CollisionReport& collision, std::vector<BodyState>& states) {
  if (!collision.began || !(collision.impulse_Ns > 0.0) || !(hold_s > 0.0)) {
    return;
  }
  collision.imposed_hold_s = hold_s;
  for (const std::int32_t body : {collision.bodies.a, collision.bodies.b}) {
    if (!is_wall(body)) {
      states[at(body)].held_s = hold_s;
    }
  }
}

}  // namespace

void Impositions::impose(const WorldSettings& settings, const std::vector<BodyModel>& models,
                         std::vector<CollisionReport>& collisions, std::vector<BodyState>& states) {
  for (CollisionReport& collision : collisions) {
    hold(settings.imposed_hold_s, collision, states);
    if (settings.imposed_spin) {
      spin(*settings.imposed_spin, models, collision, states);
    }
  }
}

void Impositions::spin(const ImposedSpinRule& rule, const std::vector<BodyModel>& models,
                       CollisionReport& collision, std::vector<BodyState>& states) {
  constexpr BodyPair kSpun{0, 1};
  if (has_spun_ || !(collision.bodies == kSpun) || !(collision.impulse_Ns > 0.0)) {
    return;
  }
  has_spun_ = true;
  if (collision.level == rule.at_level) {
    collision.imposed_spin = true;
    add_spin(models[at(kSpun.a)], rule.spin.a, states[at(kSpun.a)]);
    add_spin(models[at(kSpun.b)], rule.spin.b, states[at(kSpun.b)]);
  }
}

}  // namespace impetus::inline world
