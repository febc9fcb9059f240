// The first phase of a step: everything moves as if it met nobody, and how far it went is kept.
// SPDX-License-Identifier: MIT
#include <cstdint>

#include "engine/numerics/at.hpp"
#include "engine/world/phases.hpp"

namespace impetus::inline world {
namespace {

/// How each body falls; one that touched when the step before ended is held by what it touches.
void find_falls(const Step& step) {
  const WorldState& world = step.world;
  std::vector<Fall>& falls = step.memory.falls;
  falls.clear();
  if (step.settings.gravity_m_s2.isZero(0.0)) {
    return;
  }
  falls.resize(world.models.size());
  for (const TouchingPair& pair : world.touching) {
    for (const std::int32_t body : {pair.bodies.a, pair.bodies.b}) {
      if (!is_wall(body)) {
        falls[at(body)].supported = true;
      }
    }
  }
  for (std::size_t body = 0; body < world.models.size(); ++body) {
    falls[body] = fall_of(world.models[body], world.states[body], falls[body].supported,
                          step.settings.gravity_m_s2, step.input.dt_s);
  }
}

/// Moves a body; the parts of figures have moved already. Returns how far its centre went (metres).
double move_body(const Step& step, std::size_t body) {
  WorldState& world = step.world;
  const std::vector<Fall>& falls = step.memory.falls;
  if (world.figures && world.figures->has_part(body)) {
    return (world.states[body].pose.position - world.finite.before()[body].pose.position).norm();
  }
  if (world.finite.is_out(body)) {
    return 0.0;
  }
  const double travelled_m = advance(world.models[body], world.states[body], step.input.dt_s,
                                     step.settings.rotation, falls.empty() ? Fall{} : falls[body]);
  world.finite.check(body, world.states[body], step.memory.report.not_finite);
  return travelled_m;
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
    world.figures->advance(step.settings.figures, world.models, step.input.dt_s,
                           step.settings.rotation, memory.falls, work, world.finite,
                           memory.report.not_finite, world.states);
    memory.report.degradations |= work.refused() ? kMotionCut : 0U;
  }
  memory.bounds.clear();
  for (std::size_t body = 0; body < world.models.size(); ++body) {
    const double travelled_m = move_body(step, body);
    const BodyModel& model = world.models[body];
    const bool takes_part = !world.finite.is_out(body);
    const Sphere bound{world.states[body].pose.position, model.tree->bounding_radius_m()};
    memory.bounds.push_back(
        {bound, takes_part ? travelled_m : 0.0, takes_part && model.inverse_mass > 0.0});
  }
}

}  // namespace impetus::inline world
