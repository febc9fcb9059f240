// The first phase of a step: everything moves as if it met nobody, and how far it went is kept.
// SPDX-License-Identifier: MIT
#include <cstdint>
#include <optional>

#include "engine/dynamics/centres_at_walls.hpp"
#include "engine/numerics/at.hpp"
#include "engine/world/phases.hpp"

namespace impetus::inline world {
namespace {

/// Notes who is held by what it touched when the step before ended: what is pushed upwards.
/// Sideways and downwards nothing is held; kept from falling there, a body would gain energy at
/// each touch.
void find_supported(const Step& step, std::vector<Fall>& falls) {
  const bool by_any_touch = step.settings.has_rules_before(3);
  for (const TouchingPair& pair : step.world.touching) {
    const double down = pair.normal.dot(step.settings.gravity_m_s2);  // the normal points to a
    for (const std::int32_t body : {pair.bodies.a, pair.bodies.b}) {
      const bool is_above = body == pair.bodies.a ? down < 0.0 : down > 0.0;
      if (!is_wall(body) && (is_above || by_any_touch)) {
        falls[at(body)].supported = true;
      }
    }
  }
}

/// How each body falls.
void find_falls(const Step& step) {
  const WorldState& world = step.world;
  std::vector<Fall>& falls = step.memory.falls;
  falls.clear();
  if (step.settings.gravity_m_s2.isZero(0.0)) {
    return;
  }
  falls.resize(world.models.size());
  find_supported(step, falls);
  for (std::size_t body = 0; body < world.models.size(); ++body) {
    falls[body] = fall_of(world.models[body], world.states[body], falls[body].supported,
                          step.settings.gravity_m_s2, step.input.dt_s);
    falls[body].comes_last = falls[body].supported && !step.settings.has_rules_before(4);
  }
}

/// Moves every body but the parts of figures, which have moved already, and notes how far each
/// centre went.
void move_each(const Step& step) {
  WorldState& world = step.world;
  const std::vector<Fall>& falls = step.memory.falls;
  const Enclosure* walls = step.walls_of_centres();
  const auto reaches = walls != nullptr ? std::optional<WallReach>(*walls) : std::nullopt;
  AdvancingBodies advancing;
  for (std::size_t body = 0; body < world.models.size(); ++body) {
    BodyState& state = world.states[body];
    double& travelled_m = step.memory.bounds[body].travelled_m;
    if (world.figures && world.figures->has_part(body)) {
      travelled_m = (state.pose.position - world.finite.before()[body].pose.position).norm();
    } else if (world.finite.is_out(body)) {
      travelled_m = 0.0;
    } else {
      travelled_m = advancing.take(world.models[body], state, step.input.dt_s,
                                   step.settings.rotation, falls.empty() ? Fall{} : falls[body]);
      if (walls != nullptr && (*reaches)(Sphere{state.pose.position, 0.0})) {
        const Vector3& from_m = world.finite.before()[body].pose.position;
        keep_centre_inside(*walls, step.settings.gravity_m_s2, world.models[body], from_m, state);
        travelled_m = (state.pose.position - from_m).norm();
      }
    }
  }
  advancing.finish();
}

/// Where a body is now, unless it is out, and whether it can move.
void note_bound(const Step& step, std::size_t body) {
  WorldState& world = step.world;
  if (!(world.figures && world.figures->has_part(body)) && !world.finite.is_out(body)) {
    world.finite.check(body, world.states[body], step.memory.report.not_finite);
  }
  const BodyModel& model = world.models[body];
  MovedBound& moved = step.memory.bounds[body];
  moved.bound = {world.states[body].pose.position, model.tree->bounding_radius_m()};
  const bool takes_part = !world.finite.is_out(body);
  moved.travelled_m = takes_part ? moved.travelled_m : 0.0;
  moved.movable = takes_part && model.inverse_mass > 0.0;
}

}  // namespace

void move_bodies(const Step& step) {
  WorldState& world = step.world;
  StepMemory& memory = step.memory;
  step.meter.begin(StepPart::kMove, static_cast<std::int64_t>(world.models.size()));
  world.finite.begin(world.states, memory.report.not_finite);
  find_falls(step);
  if (world.figures) {
    PhaseWork work = step.work_of(WorkPhase::kMotion);
    const FigureStep figure_step{step.input.dt_s, step.settings.rotation, memory.falls,
                                 /*may_go_as_one_body=*/!step.settings.has_rules_before(6)};
    const bool arrived =
        world.figures->advance(step.settings.figures, world.models, figure_step, work, world.finite,
                               memory.report.not_finite, world.states);
    const bool is_cut = work.refused() || (figure_step.may_go_as_one_body && !arrived);
    memory.report.degradations |= is_cut ? kMotionCut : 0U;
  }
  memory.bounds.resize(world.models.size());
  move_each(step);
  for (std::size_t body = 0; body < world.models.size(); ++body) {
    note_bound(step, body);
  }
}

}  // namespace impetus::inline world
