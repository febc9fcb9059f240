// The third phase of a step: which pair is in which list, and before whom.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>

#include "engine/numerics/at.hpp"
#include "engine/world/phases.hpp"

namespace impetus::inline world {
namespace {

/// For a body and a wall, both are that body.
void find_motion(PairBounds& pair, const Measuring& by) {
  const std::size_t a = at(pair.pair.a);
  const std::size_t b = is_wall(pair.pair.b) ? a : at(pair.pair.b);
  pair.velocity_a = velocity(by.models[a], by.states[a]);
  pair.velocity_b = velocity(by.models[b], by.states[b]);
}

void find_fit_error(PairBounds& pair, const Measuring& by) {
  constexpr int kLevelBeforeRefinement = 0;
  pair.fit_error_m = by.models[at(pair.pair.a)].tree->fit_error_m(kLevelBeforeRefinement);
  if (!is_wall(pair.pair.b)) {
    pair.fit_error_m += by.models[at(pair.pair.b)].tree->fit_error_m(kLevelBeforeRefinement);
  }
}

void find_terms(unsigned terms, PairBounds& pair, const Measuring& by) {
  if ((terms & kMotionTerm) != 0) {
    find_motion(pair, by);
  }
  if ((terms & kFitErrorTerm) != 0) {
    find_fit_error(pair, by);
  }
}

}  // namespace

void StepOrder::put_into_lists(std::vector<PairBounds>& candidates, const Measuring& by) {
  candidates_ = &candidates;
  const unsigned terms = metric_decides_lists(by.schedule) ? metric_of(by.schedule).terms() : 0;
  if ((terms & (kMotionTerm | kFitErrorTerm)) != 0) {
    for (PairBounds& pair : candidates) {
      find_terms(terms, pair, by);
    }
  }
  impetus::put_into_lists(candidates, by.schedule, by.input.viewer, by.input.fixation,
                          by.input.region, pairs_);
}

std::span<const std::size_t> StepOrder::places_by_priority(std::span<const std::size_t> waiting,
                                                           const Measuring& by) {
  if (!waiting.empty() && by.schedule.lists.size() > 1) {
    return all_places_by_priority(by);
  }
  places_.assign(waiting.begin(), waiting.end());
  if (waiting.size() > 1) {
    sort_places(by);
  }
  return places_;
}

std::span<const std::size_t> StepOrder::all_places_by_priority(const Measuring& by) {
  places_.resize(pairs_.size());
  std::iota(places_.begin(), places_.end(), std::size_t{0});
  sort_places(by);
  return places_;
}

void StepOrder::list_pairs(const Measuring& by, std::vector<ScheduledPair>& listed) {
  listed.clear();
  for (const std::size_t place : all_places_by_priority(by)) {
    listed.push_back(pairs_[place].scheduled);
  }
}

void StepOrder::sort_places(const Measuring& by) {
  const PriorityMetric& metric = metric_of(by.schedule);
  ranked_.clear();
  for (const std::size_t place : places_) {
    MeasuredPair& pair = pairs_[place];
    if (!pair.is_measured) {
      pair.priority = metric.priority(measure(pair.place, by));
      pair.is_measured = true;
    }
    ranked_.push_back({pair, place});
  }
  std::sort(ranked_.begin(), ranked_.end(),
            [](const Ranked& x, const Ranked& y) { return goes_before(x.pair, y.pair); });
  for (std::size_t rank = 0; rank < ranked_.size(); ++rank) {
    places_[rank] = ranked_[rank].place;
  }
}

double StepOrder::measured(std::size_t place, const Measuring& by) {
  const MeasuredPair& pair = pairs_[place];
  return pair.is_measured ? metric_of(by.schedule).priority(pair.priority)  // its sign turned back
                          : measure(pair.place, by);
}

double StepOrder::measure(std::int32_t candidate, const Measuring& by) {
  const PriorityMetric& metric = metric_of(by.schedule);
  PairBounds& pair = (*candidates_)[at(candidate)];
  find_terms(metric.terms(), pair, by);
  return metric.measure(pair, by.input.viewer, by.input.fixation);
}

void prioritise_pairs(const Step& step) {
  const Schedule& schedule = step.settings.schedule;
  step.memory.order.put_into_lists(step.memory.candidates,
                                   {schedule, step.input, step.world.models, step.world.states});
  step.world.priorities.raise(step.memory.order.pairs(), schedule.persistence_steps);
}

}  // namespace impetus::inline world
