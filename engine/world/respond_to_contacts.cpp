// The sixth phase of a step: impulses, and what is imposed beyond physics.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "engine/numerics/at.hpp"
#include "engine/numerics/elementary_functions.hpp"
#include "engine/world/phases.hpp"

namespace impetus::inline world {
namespace {

/// The reported contacts of a collision, by their index.
std::pair<std::size_t, std::size_t> contact_range(const CollisionReport& collision) {
  const auto first = static_cast<std::size_t>(collision.first_contact);
  return {first, first + static_cast<std::size_t>(collision.contact_count)};
}

/// The contacts that the response gets, in the order of StepReport::contacts.
void gather_contacts(const StepReport& report, std::vector<Contact>& contacts) {
  contacts.clear();
  for (const CollisionReport& collision : report.collisions) {
    const auto [first, end] = contact_range(collision);
    for (std::size_t i = first; i < end; ++i) {
      contacts.push_back({collision.bodies, report.contacts[i].touch});
    }
  }
}

/// The contacts of the collisions, by list and by falling priority.
std::span<const std::size_t> most_visible_first(const Step& step) {
  const std::vector<CollisionReport>& collisions = step.memory.report.collisions;
  const PriorityMetric& metric = metric_of(step.settings.schedule);
  std::vector<std::size_t>& order = step.memory.collision_order;
  order.resize(collisions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto priority = [&](std::size_t i) {
    return collisions[i].measured ? metric.priority(*collisions[i].measured) : 0.0;
  };
  std::sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) {
    if (collisions[x].list != collisions[y].list) {
      return collisions[x].list < collisions[y].list;
    }
    const double of_x = priority(x);
    const double of_y = priority(y);
    return of_x > of_y || (of_x == of_y && x < y);
  });
  std::vector<std::size_t>& contacts = step.memory.by_visibility;
  contacts.clear();
  for (const std::size_t collision : order) {
    const auto [first, end] = contact_range(collisions[collision]);
    for (std::size_t contact = first; contact < end; ++contact) {
      contacts.push_back(contact);
    }
  }
  return contacts;
}

/// Approaches that are slower are given nothing back.
double resting_speed_m_s(const Step& step) {
  return kRestingSteps * step.settings.gravity_m_s2.norm() * step.input.dt_s;
}

const ResponseResult& give_impulses(const Step& step) {
  const WorldSettings& settings = step.settings;
  WorldState& world = step.world;
  StepMemory& memory = step.memory;
  gather_contacts(memory.report, memory.contacts);
  Restitutions{settings.restitution, settings.materials, settings.wall_material}.find(
      memory.contacts, world.models, memory.restitutions);
  ResponseRules rules;
  rules.method = settings.response;
  rules.most_passes = settings.most_response_passes;
  rules.resting_m_s = resting_speed_m_s(step);
  rules.least_share_of_give = settings.has_rules_before(3) ? 0.0 : rules.least_share_of_give;
  ResponseWork work{step.work_of(WorkPhase::kResponse), step.work_of(WorkPhase::kVisible),
                    [&step] { return most_visible_first(step); }};
  rules.work = &work;
  const ResponseResult& result =
      world.figures
          ? world.figures->respond(settings.figures, memory.contacts, memory.restitutions, rules,
                                   step.input.dt_s, world.models, world.finite, world.states)
          : memory.responder.respond(memory.contacts, memory.restitutions, rules, world.models,
                                     world.states);
  memory.report.degradations |= work.passes.refused() ? kResponseCut : 0U;
  return result;
}

/// Adds what the response did: to each contact, and in all to each collision.
void report_response(const ResponseResult& result, StepReport& report) {
  for (CollisionReport& collision : report.collisions) {
    const auto [first, end] = contact_range(collision);
    for (std::size_t i = first; i < end; ++i) {
      ReportedContact& contact = report.contacts[i];
      contact.approach_m_s = result.approach_m_s[i];
      contact.impulse_Ns = result.impulse_Ns[i];
      collision.approach_m_s = std::max(collision.approach_m_s, contact.approach_m_s);
      collision.impulse_Ns += contact.impulse_Ns;
    }
  }
  if (result.residual_approach_m_s > 0.0) {
    report.degradations |= kApproachRemains;
  }
}

/// Holds the bodies of a collision that began and was responded to.
void hold_bodies(double hold_s, CollisionReport& collision, std::vector<BodyState>& states) {
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

/// Changes the body's angular velocity by `spin_rad_s`; nothing where nothing turns it.
void add_spin(const BodyModel& model, const Vector3& spin_rad_s, BodyState& state) {
  state.angular_momentum += angular_momentum_at(model, state.pose.orientation, spin_rad_s);
}

/// Adds the spin, if the collision is handled at the spin's level.
void spin_bodies(const ImposedSpinRule& rule, CollisionReport& collision, WorldState& world) {
  if (collision.level == rule.at_level) {
    collision.imposed_spin = true;
    add_spin(world.models[0], rule.spin.a, world.states[0]);
    add_spin(world.models[1], rule.spin.b, world.states[1]);
  }
}

/// Turns a vector about a unit one. (Rodrigues)
Vector3 turned(const Vector3& v, const Vector3& axis, double angle_deg) {
  const auto [sine, cosine] = sine_cosine_deg(angle_deg);
  return cosine * v + sine * axis.cross(v) + (1.0 - cosine) * axis.dot(v) * axis;
}

/// Turns the ways of the two away from each other, or towards each other, and changes their speed.
/// Where they part in opposite directions the second turns anticlockwise, as seen against the axis.
void redirect_bodies(const ImposedRebound& rebound, WorldState& world) {
  Vector3& a = world.states[0].linear_momentum;
  Vector3& b = world.states[1].linear_momentum;
  const double away = rebound.axis.dot(a.cross(b)) >= 0.0 ? 0.5 : -0.5;
  a = rebound.speed_ratio * turned(a, rebound.axis, -away * rebound.wider_deg);
  b = rebound.speed_ratio * turned(b, rebound.axis, away * rebound.wider_deg);
}

/// What waits for the first collision of bodies 0 and 1 that is responded to.
void impose_once(const WorldSettings& settings, CollisionReport& collision, WorldState& world) {
  constexpr BodyPair kBoth{0, 1};
  if (world.have_met || !(collision.bodies == kBoth) || !(collision.impulse_Ns > 0.0)) {
    return;
  }
  world.have_met = true;
  if (settings.imposed_spin) {
    spin_bodies(*settings.imposed_spin, collision, world);
  }
  if (settings.imposed_rebound) {
    redirect_bodies(*settings.imposed_rebound, world);
  }
}

/// Manipulations that are not physics, said in the report: only those that the settings ask for.
void impose(const Step& step) {
  for (CollisionReport& collision : step.memory.report.collisions) {
    hold_bodies(step.settings.imposed_hold_s, collision, step.world.states);
    impose_once(step.settings, collision, step.world);
  }
}

/// Brings a body whose centre is beyond a wall back to it, and takes from it what would carry its
/// centre through in the next step, as if the wall pushed at its centre: its kinetic energy does
/// not grow, and nothing turns it.
void stop_centre_at_walls(const Enclosure& enclosure, const Vector3& gravity_m_s2, double dt_s,
                          const BodyModel& model, BodyState& state) {
  for (int wall = 0; wall < kWallCount; ++wall) {
    const double room_m = -reach_beyond(enclosure, wall, Sphere{state.pose.position, 0.0});
    const Vector3 outward = -inward_normal(enclosure, wall);
    if (room_m < 0.0) {
      state.pose.position += room_m * outward;
    }
    const double outward_Ns = outward.dot(state.linear_momentum);
    const double fall_m = std::max(0.0, 0.5 * outward.dot(gravity_m_s2) * dt_s * dt_s);
    const double allowed_Ns = std::max(0.0, room_m - fall_m) / (dt_s * model.inverse_mass);
    if (outward_Ns > allowed_Ns) {
      state.linear_momentum -= (outward_Ns - allowed_Ns) * outward;
    }
  }
}

/// Turns a body back whose centre is beyond a wall and would go on outwards, as if the wall pushed
/// at its centre: what pushes beside it may turn the body ever faster and still let it through. Its
/// kinetic energy does not grow.
void turn_back_at_walls(const Enclosure& enclosure, double restitution, double resting_m_s,
                        const BodyModel& model, BodyState& state) {
  for (int wall = 0; wall < kWallCount; ++wall) {
    const Vector3 outward = -inward_normal(enclosure, wall);
    const double outward_Ns = outward.dot(state.linear_momentum);
    if (outward_Ns > 0.0 && reach_beyond(enclosure, wall, Sphere{state.pose.position, 0.0}) > 0.0) {
      const double given_back = outward_Ns * model.inverse_mass > resting_m_s ? restitution : 0.0;
      state.linear_momentum -= (1.0 + given_back) * outward_Ns * outward;
    }
  }
}

/// Nobody leaves the enclosure, whatever pushes at the walls were found.
void turn_back_at_walls(const Step& step) {
  const double resting_m_s = resting_speed_m_s(step);
  for (const CollisionReport& collision : step.memory.report.collisions) {
    const auto [first, end] = contact_range(collision);
    const auto body = at(collision.bodies.a);
    if (is_wall(collision.bodies.b) && first < end && step.memory.bounds[body].movable &&
        !step.world.models[body].passes_through) {
      turn_back_at_walls(*step.settings.enclosure, step.memory.restitutions[first], resting_m_s,
                         step.world.models[body], step.world.states[body]);
    }
  }
}

/// Once work was cut what is left unanswered can push bodies out for long, so that their centres
/// are stopped at the walls; else they are turned back behind them.
void keep_centres_inside(const Step& step) {
  const WorldSettings& settings = step.settings;
  step.world.was_cut |= step.memory.report.grants.cut_beyond_refinement();
  if (!settings.enclosure || !(step.input.dt_s > 0.0)) {
    return;
  }
  if (!step.world.was_cut) {
    if (!settings.has_rules_before(3)) {
      turn_back_at_walls(step);
    }
    return;
  }
  for (const MovedBound& bound : step.memory.bounds) {
    const auto body = static_cast<std::size_t>(&bound - step.memory.bounds.data());
    if (bound.movable && !step.world.finite.is_out(body) &&
        !step.world.models[body].passes_through) {
      stop_centre_at_walls(*settings.enclosure, settings.gravity_m_s2, step.input.dt_s,
                           step.world.models[body], step.world.states[body]);
    }
  }
}

void take_out_not_finite(WorldState& world, StepReport& report) {
  for (std::size_t body = 0; body < world.states.size(); ++body) {
    world.finite.check(body, world.states[body], report.not_finite);
  }
  if (world.finite.any_out()) {
    report.degradations |= kNotFinite;
  }
}

}  // namespace

void respond_to_contacts(const Step& step) {
  step.meter.begin(StepPart::kRespond,
                   static_cast<std::int64_t>(step.memory.report.contacts.size()));
  report_response(give_impulses(step), step.memory.report);
  keep_centres_inside(step);
  impose(step);
  take_out_not_finite(step.world, step.memory.report);
}

}  // namespace impetus::inline world
