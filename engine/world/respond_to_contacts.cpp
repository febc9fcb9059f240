// The sixth phase of a step: impulses, and what is imposed beyond physics.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "engine/dynamics/centres_at_walls.hpp"
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

bool goes_before(const RankedCollision& x, const RankedCollision& y) {
  if (x.list != y.list) {
    return x.list < y.list;
  }
  return x.priority > y.priority || (x.priority == y.priority && x.place < y.place);
}

/// The contacts of the collisions, by list and by falling priority.
std::span<const std::size_t> most_visible_first(const Step& step) {
  const std::vector<CollisionReport>& collisions = step.memory.report.collisions;
  const PriorityMetric& metric = metric_of(step.settings.schedule);
  std::vector<RankedCollision>& order = step.memory.ranked_collisions;
  order.clear();
  for (const CollisionReport& collision : collisions) {
    const double priority = collision.measured ? metric.priority(*collision.measured) : 0.0;
    order.push_back({collision.list, priority, order.size()});
  }
  std::sort(order.begin(), order.end(), goes_before);
  std::vector<std::size_t>& contacts = step.memory.by_visibility;
  contacts.clear();
  for (const RankedCollision& each : order) {
    const auto [first, end] = contact_range(collisions[each.place]);
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

/// Turns back whose centre is at a wall or beyond, whatever pushes at the wall were found.
void turn_centres_back(const Step& step) {
  const double resting_m_s = resting_speed_m_s(step);
  for (const CollisionReport& collision : step.memory.report.collisions) {
    const auto [first, end] = contact_range(collision);
    const auto body = at(collision.bodies.a);
    const BodyModel& model = step.world.models[body];
    if (is_wall(collision.bodies.b) && first < end && step.memory.bounds[body].movable &&
        !model.passes_through) {
      const bool from_beyond = step.settings.has_rules_before(5);
      turn_back_at_walls(*step.settings.enclosure, from_beyond ? 0.0 : -wall_rounding_m(model),
                         step.memory.restitutions[first], resting_m_s, model,
                         step.world.states[body]);
    }
  }
}

/// Stops whose centre would go through a wall in the step to come. Figures that are beyond one come
/// back as wholes: one of their parts alone would tear at its hinges.
void stop_centres(const Step& step) {
  WorldState& world = step.world;
  const bool each_alone = step.settings.has_rules_before(6);
  if (world.figures && !each_alone) {
    world.figures->move_back_inside(step.settings.figures, world.models, *step.settings.enclosure,
                                    step.settings.gravity_m_s2, world.finite, world.states);
  }
  for (std::size_t body = 0; body < world.models.size(); ++body) {
    const bool stops =
        step.settings.has_rules_before(5) || (world.figures && world.figures->has_part(body));
    if (stops && step.memory.bounds[body].movable && !world.finite.is_out(body) &&
        !world.models[body].passes_through) {
      stop_at_walls(*step.settings.enclosure, step.settings.gravity_m_s2, step.input.dt_s,
                    each_alone, world.models[body], step.world.states[body]);
    }
  }
}

/// Nobody leaves the enclosure: no centre goes through a wall, and at the wall it is turned back.
/// The parts of figures, which their hinges move, may go through; once work was cut what is left
/// unanswered can push them out for long, so that they are stopped before.
void keep_centres_inside(const Step& step) {
  const WorldSettings& settings = step.settings;
  bool& was_cut = step.world.was_cut;
  was_cut |= step.memory.report.grants.cut_beyond_refinement();
  if (!settings.enclosure || !(step.input.dt_s > 0.0)) {
    return;
  }
  if (was_cut) {
    stop_centres(step);
  }
  if (!settings.has_rules_before(was_cut ? 5 : 3)) {
    turn_centres_back(step);
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
