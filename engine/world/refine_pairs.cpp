// The fourth phase of a step: the roots of all pairs are tested, and then finer nodes for as long
// as work is granted. How it is shared among the lists is told in budgeted_refinement.hpp.
// SPDX-License-Identifier: MIT
#include <cstdint>
#include <optional>
#include <span>

#include "engine/numerics/at.hpp"
#include "engine/scheduling/eccentricity_metric.hpp"
#include "engine/world/phases.hpp"

namespace impetus::inline world {
namespace {

bool is_capped_by_speed(const Step& step, BodyPair bodies) {
  if (is_wall(bodies.b)) {
    return false;
  }
  const Tunnelling tunnelling = step.settings.tunnelling;
  return tunnelling == Tunnelling::kCapped ||
         (tunnelling == Tunnelling::kStopAtEntry &&
          (step.world.is_of_figure(bodies) || step.memory.entries.result.lacked_tests(bodies)));
}

int level_capped_by_speed(const Step& step, BodyPair bodies, int greatest_level) {
  if (!is_capped_by_speed(step, bodies)) {
    return greatest_level;
  }
  const std::vector<BodyModel>& models = step.world.models;
  const std::vector<BodyState>& states = step.world.states;
  const auto turning_m_s = [&](std::int32_t body) {
    return angular_velocity(models[at(body)], states[at(body)]).norm() *
           models[at(body)].tree->bounding_radius_m();
  };
  const auto velocity_of = [&](std::int32_t body) {
    return velocity(models[at(body)], states[at(body)]);
  };
  const double speed_m_s = (velocity_of(bodies.a) - velocity_of(bodies.b)).norm() +
                           turning_m_s(bodies.a) + turning_m_s(bodies.b);
  return capped_level(*models[at(bodies.a)].tree, *models[at(bodies.b)].tree,
                      speed_m_s * step.input.dt_s, greatest_level);
}

int walls_in_reach(const Step& step, std::size_t body) {
  const Sphere all{step.world.states[body].pose.position, step.world.placed[body].reach_m()};
  int count = 0;
  for (int wall = 0; wall < kWallCount; ++wall) {
    count += reach_beyond(*step.settings.enclosure, wall, all) >= 0.0 ? 1 : 0;
  }
  return count;
}

/// For traversals that go by what is seen of a pair.
void find_sight(const Step& step, RefinedPair& pair) {
  const unsigned terms = step.settings.schedule.traversal->terms();
  if ((terms & (kEyeDistanceTerm | kAcuityTerm)) == 0) {
    return;
  }
  const BodyPair bodies = pair.bodies;
  const auto bound = [&world = step.world](std::int32_t body) {
    return Sphere{world.states[at(body)].pose.position,
                  world.models[at(body)].tree->bounding_radius_m()};
  };
  const PairBounds bounds{bodies, bound(bodies.a), bound(is_wall(bodies.b) ? bodies.a : bodies.b)};
  pair.eye_distance_m = (collision_place(bounds) - step.input.viewer.eye).norm();
  if ((terms & kAcuityTerm) != 0) {
    pair.acuity = relative_acuity(eccentricity_deg(bounds, step.input.viewer, step.input.fixation,
                                                   /*point=*/std::nullopt));
  }
}

/// Tests the roots of a pair, and says how deep it may go.
void begin_refining(const Step& step, const ScheduledPair& pair) {
  const auto& [bodies, list] = pair;
  const int greatest = step.settings.schedule.lists[at(list)].greatest_level;
  const int capped = level_capped_by_speed(step, bodies, greatest);
  const bool walls = is_wall(bodies.b);
  RefinedPair& begun = step.memory.refined.add();
  begun.bodies = bodies;
  begun.list = list;
  begun.walls = walls ? walls_in_reach(step, at(bodies.a)) : 1;
  begun.hinged = step.world.is_of_figure(bodies);
  PlacedTree& a = step.world.placed[at(bodies.a)];
  if (walls) {
    begun.refinement.begin(a, *step.settings.enclosure, greatest);
  } else {
    begun.refinement.begin(a, step.world.placed[at(bodies.b)], capped,
                           capped < greatest ? StopReason::kCapped : StopReason::kGreatestLevel);
  }
  find_sight(step, begun);
}

/// What is responded to whatever the budget: folds of figures, of which nothing is refined.
std::int64_t work_of_folds(const Step& step) {
  if (!step.world.figures) {
    return 0;
  }
  const PhaseCosts costs(step.settings.costs, step.settings.contacts);
  const auto folds = static_cast<std::int64_t>(step.world.figures->folds().size());
  return costs.of_response(folds, /*hinged=*/true);
}

void report_work(const WorkDone& work, StepReport& report) {
  report.work_granted = work.granted;
  report.work_spent = work.spent;
  report.work_floor = work.floor;
  report.work_reserved = work.reserved;
  report.work_peak = work.peak;
  report.list_work = work.by_list;
  if (report.work_granted < report.work_floor) {
    report.degradations |= kFloorOverBudget;
  }
}

}  // namespace

void refine_pairs(const Step& step) {
  const Schedule& schedule = step.settings.schedule;
  const Measuring measuring{schedule, step.input, step.world.models, step.world.states};
  StepMemory& memory = step.memory;
  step.meter.begin(StepPart::kRefine, static_cast<std::int64_t>(memory.order.pairs().size()));
  memory.refined.clear();
  memory.work_of_folds = work_of_folds(step);
  memory.report.work_floor += memory.work_of_folds;
  for (const MeasuredPair& pair : memory.order.pairs()) {
    begin_refining(step, pair.scheduled);
  }
  const std::span<RefinedPair> pairs = memory.refined.all();
  const RefinementSettings settings{schedule.traversal, step.settings.costs, step.settings.contacts,
                                    memory.report.work_floor};
  const std::size_t waiting = memory.sharing.do_floor(pairs, schedule.lists, settings);
  const std::span<const std::size_t> order = memory.order.places_by_priority(waiting, measuring);
  report_work(memory.sharing.refine(pairs, schedule.lists, order, step.meter, settings),
              memory.report);
  memory.pairs.clear();
  if (step.world.watches_pairs) {
    memory.order.list_pairs(measuring, memory.pairs);
  }
}

}  // namespace impetus::inline world
