// The last phase of a step: what the next step, and whoever replays this one, must know.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>

#include "engine/numerics/at.hpp"
#include "engine/scheduling/gap_metrics.hpp"
#include "engine/world/phases.hpp"

namespace impetus::inline world {
namespace {

double fit_error_m(const BodyPair& bodies, int level, const std::vector<BodyModel>& models) {
  double sum_m = 0.0;
  for (const std::int32_t body : {bodies.a, bodies.b}) {
    sum_m += is_wall(body) ? 0.0 : models[at(body)].tree->fit_error_m(level);
  }
  return sum_m;
}

/// Pairs that touch at a coarser level than in the step before. Their size is how much more both
/// trees' fit errors are at the level they fell to, seen where they touch.
void report_pops(const Step& step) {
  const WorldState& world = step.world;
  StepReport& report = step.memory.report;
  for (const CollisionReport& now : report.collisions) {
    const TouchingPair* then = world.touched_before(now.bodies);
    if (then == nullptr || now.level >= then->level) {
      continue;
    }
    const double grown_m = fit_error_m(now.bodies, now.level, world.models) -
                           fit_error_m(now.bodies, then->level, world.models);
    report.pops.push_back({now.bodies, then->level, now.level,
                           spanned_by_length_deg(std::max(0.0, grown_m), now.contact.touch.point,
                                                 step.input.viewer)});
  }
}

void note_touching_for_persistence(const Step& step) {
  std::vector<BodyPair>& touching = step.memory.touching;
  touching.clear();
  for (const TouchingPair& pair : step.world.touching) {
    touching.push_back(pair.bodies);
  }
  step.world.priorities.note_touching(touching);
}

}  // namespace

void remember_contacts(const Step& step) {
  WorldState& world = step.world;
  StepReport& report = step.memory.report;
  step.meter.begin(StepPart::kRemember, static_cast<std::int64_t>(world.models.size()));
  report_pops(step);
  world.touching.clear();
  for (const CollisionReport& collision : report.collisions) {
    world.touching.push_back({collision.bodies, collision.contact.touch.normal, collision.level});
  }
  if (step.settings.schedule.persistence_steps > 0) {
    note_touching_for_persistence(step);
  }
  hash_state(world.states, report.state);
}

}  // namespace impetus::inline world
