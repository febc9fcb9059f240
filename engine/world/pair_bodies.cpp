// The second phase of a step: who may have met, by the bounds of where bodies went.
//
//   candidates   bodies whose swept bounds touch, but those that are out, pass through others or
//                are neighbours in a figure; of more than can be found, those that begin near each
//                other along an axis
//   leave        of more than are granted, those that reach least into each other
//   stop         fast pairs that would pass through each other, where they first touch
//   walls        bodies that reach beyond the enclosure where they stand now
//
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "engine/collision/broad_phase.hpp"
#include "engine/numerics/at.hpp"
#include "engine/volumes/enclosure.hpp"
#include "engine/world/phases.hpp"

namespace impetus::inline world {
namespace {

/// So few are sooner all tested against each other than put in order; the pairs are the same.
constexpr std::size_t kFewBodies = 24;

/// What was placed in the step before is forgotten.
void lend_memory_to_trees(const Step& step) {
  step.memory.placed.clear();
  for (PlacedTree& tree : step.world.placed) {
    tree.take_memory_from(step.memory.placed);
  }
}

/// Finds whose bounds touched on the way; whether all was granted that this takes.
bool find_pairs(const Step& step, std::vector<BodyPair>& found) {
  WorldState& world = step.world;
  PhaseWork work = step.work_of(WorkPhase::kSweep);
  if (step.memory.bounds.size() <= kFewBodies) {
    find_among_all(step.memory.bounds, found);
  } else {
    world.broad_phase.find(step.memory.bounds, found, &work);
  }
  if (world.finite.any_out()) {
    std::erase_if(found, [&world](const BodyPair& pair) {
      return world.finite.is_out(at(pair.a)) || world.finite.is_out(at(pair.b));
    });
  }
  if (world.some_pass_through) {
    std::erase_if(found, [&world](const BodyPair& pair) {
      return world.models[at(pair.a)].passes_through || world.models[at(pair.b)].passes_through;
    });
  }
  if (world.figures) {
    std::erase_if(found, [&step, &world](const BodyPair& pair) {
      return !world.figures->may_meet(step.settings.figures, pair);
    });
  }
  return !work.refused();
}

/// How deep the bounds of a pair reach into each other at the end of the step (metres); of bounds
/// that met on the way alone, less than nothing.
double overlap_m(const std::vector<MovedBound>& bounds, BodyPair pair) {
  const Sphere& a = bounds[at(pair.a)].bound;
  const Sphere& b = bounds[at(pair.b)].bound;
  return a.radius_m + b.radius_m - (a.centre - b.centre).norm();
}

/// Keeps as many pairs as are granted: those that reach deepest into each other, of equals the
/// first by (b, a). Returns how many are left.
std::int64_t leave_shallow_pairs(const Step& step, std::vector<BodyPair>& found) {
  PhaseWork work = step.work_of(WorkPhase::kPairs);
  if (work.spend(static_cast<std::int64_t>(found.size()))) {
    return 0;
  }
  std::vector<PairDepth>& depths = step.memory.depths;
  depths.clear();
  for (const BodyPair& pair : found) {
    depths.push_back({overlap_m(step.memory.bounds, pair), pair});
  }
  const auto goes_before = [](const PairDepth& x, const PairDepth& y) {
    return x.overlap_m != y.overlap_m
               ? x.overlap_m > y.overlap_m
               : std::pair(x.pair.b, x.pair.a) < std::pair(y.pair.b, y.pair.a);
  };
  const auto kept = static_cast<std::ptrdiff_t>(work.granted());
  std::nth_element(depths.begin(), depths.begin() + kept, depths.end(), goes_before);
  const std::size_t left = found.size() - static_cast<std::size_t>(kept);
  found.resize(static_cast<std::size_t>(kept));
  std::transform(depths.begin(), depths.begin() + kept, found.begin(),
                 [](const PairDepth& depth) { return depth.pair; });
  return static_cast<std::int64_t>(left);
}

void find_candidates(const Step& step) {
  WorldState& world = step.world;
  StepMemory& memory = step.memory;
  const bool found_all = find_pairs(step, memory.found);
  memory.report.pairs_left = leave_shallow_pairs(step, memory.found);
  if (!found_all || memory.report.pairs_left > 0) {
    memory.report.degradations |= kPairsLeft;
  }
  if (memory.bounds.size() > kFewBodies || memory.report.pairs_left > 0) {  // else they are
    world.broad_phase.put_in_order(memory.bounds.size(), memory.found);
  }
  take_bounds(memory.bounds, memory.found, memory.candidates);
  if (world.figures) {
    world.figures->find_folds(step.settings.figures, world.finite, world.states);
  }
}

/// The candidates of which both bodies can stop: a part cannot where its figure goes on.
const std::vector<PairBounds>& stoppable_pairs(const Step& step) {
  const WorldState& world = step.world;
  if (!world.figures) {
    return step.memory.candidates;
  }
  std::vector<PairBounds>& stoppable = step.memory.stoppable;
  stoppable.clear();
  std::copy_if(step.memory.candidates.begin(), step.memory.candidates.end(),
               std::back_inserter(stoppable),
               [&world](const PairBounds& pair) { return !world.is_of_figure(pair.pair); });
  return stoppable;
}

EntryRules entry_rules(const WorldSettings& settings) {
  if (settings.has_rules_before(7)) {
    return EntryRules::kDirected;
  }
  return settings.has_rules_before(8) ? EntryRules::kNearestFirst : EntryRules::kNodeWays;
}

void stop_fast_pairs(const Step& step) {
  const WorldSettings& settings = step.settings;
  WorldState& world = step.world;
  StepMemory& memory = step.memory;
  int greatest_level = 0;
  for (const PriorityList& list : settings.schedule.lists) {
    greatest_level = std::max(greatest_level, list.greatest_level);
  }
  PhaseWork work = step.work_of(WorkPhase::kEntry);
  const Stopping& stopping = stop_at_entry(
      {step.input.dt_s, world.models, world.finite.before(), stoppable_pairs(step), greatest_level,
       settings.costs, settings.rotation, kMostStops, memory.falls, settings.most_entry_tests,
       &work, memory.workers.get(), step.walls_of_centres(), entry_rules(settings)},
      world.states, world.placed, memory.entries);
  for (PairBounds& pair : memory.candidates) {
    pair.a.centre = world.states[at(pair.pair.a)].pose.position;
    pair.b.centre = world.states[at(pair.pair.b)].pose.position;
  }
  StepReport& report = memory.report;
  report.work_floor = stopping.work;
  report.stopped = stopping.stopped;
  if (!report.stopped.empty()) {
    report.degradations |= kStoppedShort;
  }
  if (stopping.ran_out) {
    report.degradations |= kEntryTestsSpent;
  }
}

void add_wall_candidates(const Enclosure& enclosure, const std::vector<BodyModel>& models,
                         StepMemory& memory) {
  const WallReach reaches(enclosure);
  for (std::size_t body = 0; body < memory.bounds.size(); ++body) {
    const auto& [bound, travelled_m, movable] = memory.bounds[body];
    if (movable && !models[body].passes_through && reaches(bound)) {
      memory.candidates.push_back({{static_cast<std::int32_t>(body), kEnclosure}, bound, bound});
    }
  }
}

}  // namespace

void pair_bodies(const Step& step) {
  WorldState& world = step.world;
  lend_memory_to_trees(step);
  step.meter.begin(StepPart::kPair, static_cast<std::int64_t>(world.models.size()));
  find_candidates(step);
  step.meter.begin(StepPart::kEnter, static_cast<std::int64_t>(step.memory.candidates.size()));
  if (step.settings.tunnelling == Tunnelling::kStopAtEntry) {
    stop_fast_pairs(step);
  }
  for (std::size_t body = 0; body < world.models.size(); ++body) {
    world.placed[body].move_to(world.states[body].pose);
    step.memory.bounds[body].bound.centre = world.states[body].pose.position;
  }
  if (step.settings.enclosure) {
    add_wall_candidates(*step.settings.enclosure, world.models, step.memory);
  }
}

}  // namespace impetus::inline world
