// What a world imposes on bodies that collide: manipulations, not physics.
// SPDX-License-Identifier: MIT
#include "engine/world.hpp"

namespace impetus {
namespace {

std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

}  // namespace

void World::hold_where_imposed(CollisionReport& collision) {
  if (!collision.began || !(collision.impulse_Ns > 0.0) || !(settings_.imposed_hold_s > 0.0)) {
    return;
  }
  collision.imposed_hold_s = settings_.imposed_hold_s;
  for (const std::int32_t body : {collision.bodies.a, collision.bodies.b}) {
    if (!is_wall(body)) {
      states_[at(body)].held_s = settings_.imposed_hold_s;
    }
  }
}

void World::spin_where_imposed(CollisionReport& collision) {
  constexpr BodyPair kSpun{0, 1};
  const std::optional<ImposedSpinRule>& rule = settings_.imposed_spin;
  if (!rule || spin_was_imposed_ || !(collision.bodies == kSpun) || !(collision.impulse_Ns > 0.0)) {
    return;
  }
  spin_was_imposed_ = true;
  if (collision.level == rule->at_level) {
    collision.imposed_spin = true;
    add_spin(models_[at(kSpun.a)], rule->spin.a, states_[at(kSpun.a)]);
    add_spin(models_[at(kSpun.b)], rule->spin.b, states_[at(kSpun.b)]);
  }
}

}  // namespace impetus
