// The fourth phase of a step: the roots of all pairs are tested, and then finer nodes for as long
// as work is granted. How it is shared among the lists is told in budgeted_refinement.hpp.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "engine/numerics/at.hpp"
#include "engine/scheduling/eccentricity_metric.hpp"
#include "engine/scheduling/perceived_metric.hpp"
#include "engine/world/phases.hpp"

namespace impetus::inline world {
namespace {

/// Of pairs in their order, the first that does not come before the given one.
std::size_t place_of_first_from(BodyPair given, std::span<const RefinedPair> pairs) {
  const auto found = std::find_if(pairs.begin(), pairs.end(), [&](const RefinedPair& pair) {
    return std::pair(pair.bodies.a, pair.bodies.b) >= std::pair(given.a, given.b);
  });
  return static_cast<std::size_t>(found - pairs.begin());
}

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

/// From when on errors of the pair are noticed, where the metric goes by somebody's noticing.
void find_noticing(const Step& step, PairBounds bounds, RefinedPair& pair) {
  pair.noticing = metric_of(step.settings.schedule).noticing();
  if (pair.noticing == nullptr) {
    return;
  }
  const auto velocity_of = [&world = step.world](std::int32_t body) {
    return velocity(world.models[at(body)], world.states[at(body)]);
  };
  bounds.velocity_a = velocity_of(pair.bodies.a);
  bounds.velocity_b = velocity_of(is_wall(pair.bodies.b) ? pair.bodies.a : pair.bodies.b);
  pair.noticed_arcmin = noticed_threshold_arcmin(*pair.noticing, bounds, step.input.viewer,
                                                 step.input.fixation, /*point=*/std::nullopt);
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
    find_noticing(step, bounds, pair);
  }
}

/// Tests the root of a body against the walls, and says how deep it may go.
void begin_at_walls(const Step& step, int greatest_level, RefinedPair& begun) {
  begun.walls = walls_in_reach(step, at(begun.bodies.a));
  begun.refinement.begin(step.world.placed[at(begun.bodies.a)], *step.settings.enclosure,
                         greatest_level);
}

/// The same of the roots of two bodies.
void begin_between(const Step& step, int greatest_level, RefinedPair& begun) {
  const auto [a, b] = begun.bodies;
  const int capped = level_capped_by_speed(step, begun.bodies, greatest_level);
  begun.refinement.begin(
      step.world.placed[at(a)], step.world.placed[at(b)], capped,
      capped < greatest_level ? StopReason::kCapped : StopReason::kGreatestLevel);
}

void add_pairs(const Step& step) {
  StepMemory& memory = step.memory;
  memory.refined.clear();
  memory.refined.expect(memory.order.pairs().size(), step.world.models.size());
  for (const MeasuredPair& pair : memory.order.pairs()) {
    RefinedPair& added = memory.refined.add();
    added.bodies = pair.scheduled.pair;
    added.list = pair.scheduled.list;
    added.walls = 1;
    added.hinged = step.world.is_of_figure(added.bodies);
    added.looked_at = true;
  }
}

/// Tests the roots of all bodies and walls.
void begin_all_at_walls(const Step& step, std::span<RefinedPair> pairs) {
  const std::vector<PriorityList>& lists = step.settings.schedule.lists;
  std::int64_t touching = 0;
  for (RefinedPair& pair : pairs) {
    if (is_wall(pair.bodies.b)) {
      begin_at_walls(step, lists[at(pair.list)].greatest_level, pair);
      find_sight(step, pair);
      touching += pair.refinement.overlapping().empty() ? 0 : 1;
    }
  }
  step.meter.expect_at_walls(touching);
}

/// Tests the roots of the pairs of bodies: in their order, but from the one on that the step before
/// had no work left for, so that everybody's turn comes. A pair for which no work is left stays
/// unlooked at, as if it were apart, and costs nothing.
void begin_all_between(const Step& step, std::span<RefinedPair> pairs) {
  const std::vector<PriorityList>& lists = step.settings.schedule.lists;
  std::optional<BodyPair>& next = step.world.next_to_begin;
  const std::size_t first = next ? place_of_first_from(*next, pairs) : 0;
  next.reset();
  PhaseWork roots = step.work_of(WorkPhase::kRoots);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    RefinedPair& pair = pairs[(first + i) % pairs.size()];
    if (is_wall(pair.bodies.b)) {
      continue;
    }
    if (roots.spend(1)) {
      begin_between(step, lists[at(pair.list)].greatest_level, pair);
      find_sight(step, pair);
    } else {
      next = next.value_or(pair.bodies);
      pair.looked_at = step.settings.has_rules_before(9);
      step.memory.report.degradations |= kPairsLeft;
      ++step.memory.report.pairs_left;
    }
  }
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
  report.grants.of(WorkPhase::kTests) = work.grants.of(WorkPhase::kTests);
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
  memory.work_of_folds = work_of_folds(step);
  memory.report.work_floor += memory.work_of_folds;
  add_pairs(step);
  const std::span<RefinedPair> pairs = memory.refined.all();
  begin_all_at_walls(step, pairs);
  begin_all_between(step, pairs);
  const RefinementSettings settings{schedule.traversal, step.settings.costs, step.settings.contacts,
                                    memory.report.work_floor};
  const std::span<const std::size_t> waiting =
      memory.sharing.do_floor(pairs, schedule.lists, settings);
  const std::span<const std::size_t> order = memory.order.places_by_priority(waiting, measuring);
  report_work(memory.sharing.refine(pairs, schedule.lists, order, step.meter, settings),
              memory.report);
  memory.pairs.clear();
  if (step.world.watches_pairs) {
    memory.order.list_pairs(measuring, memory.pairs);
  }
}

}  // namespace impetus::inline world
