// The first phases of a step: bodies move, and who may have met is paired; fast pairs are stopped
// where they first touch.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <vector>

#include "engine/collision/broad_phase.hpp"
#include "engine/numerics/at.hpp"
#include "engine/volumes/enclosure.hpp"
#include "engine/world/world.hpp"

namespace impetus::inline world {
namespace {

/// So few are sooner all tested against each other than put in order; the pairs are the same.
constexpr std::size_t kFewBodies = 24;

}  // namespace

void World::move_and_pair(double dt_s) {
  find_falls(dt_s);
  std::vector<MovedBound>& bounds = memory_.bounds;
  bounds.clear();
  if (figures_) {
    figures_->advance(settings_.figures, models_, dt_s, settings_.rotation, memory_.falls, finite_,
                      memory_.report.not_finite, states_);
  }
  for (std::size_t body = 0; body < models_.size(); ++body) {
    double travelled_m = 0.0;
    if (figures_ && figures_->has_part(body)) {
      travelled_m = (states_[body].pose.position - finite_.before()[body].pose.position).norm();
    } else if (!finite_.is_out(body)) {
      travelled_m = advance(models_[body], states_[body], dt_s, settings_.rotation,
                            memory_.falls.empty() ? Fall{} : memory_.falls[body]);
      finite_.check(body, states_[body], memory_.report.not_finite);
    }
    const bool takes_part = !finite_.is_out(body);
    const Sphere bound{states_[body].pose.position, models_[body].tree->bounding_radius_m()};
    bounds.push_back(
        {bound, takes_part ? travelled_m : 0.0, takes_part && models_[body].inverse_mass > 0.0});
  }
  if (bounds.size() <= kFewBodies) {
    find_among_all(bounds, memory_.candidates);
  } else {
    broad_phase_.find(bounds, memory_.candidates);
  }
  if (finite_.any_out()) {
    std::erase_if(memory_.candidates, [this](const PairBounds& pair) {
      return finite_.is_out(at(pair.pair.a)) || finite_.is_out(at(pair.pair.b));
    });
  }
  if (figures_) {
    std::erase_if(memory_.candidates, [this](const PairBounds& pair) {
      return !figures_->may_meet(settings_.figures, pair.pair);
    });
    figures_->find_folds(settings_.figures, finite_, states_);
  }
  if (settings_.tunnelling == Tunnelling::kStopAtEntry) {
    stop_fast_pairs(dt_s);
  }
  for (std::size_t body = 0; body < models_.size(); ++body) {
    placed_[body].move_to(states_[body].pose);
    bounds[body].bound.centre = states_[body].pose.position;
  }
  if (settings_.enclosure) {
    add_wall_candidates();
  }
}

void World::find_falls(double dt_s) {
  memory_.falls.clear();
  if (settings_.gravity_m_s2.isZero(0.0)) {
    return;
  }
  memory_.falls.resize(models_.size());
  for (const TouchingPair& pair : touching_) {
    for (const std::int32_t body : {pair.bodies.a, pair.bodies.b}) {
      if (!is_wall(body)) {
        memory_.falls[at(body)].supported = true;
      }
    }
  }
  for (std::size_t body = 0; body < models_.size(); ++body) {
    memory_.falls[body] = fall_of(models_[body], states_[body], memory_.falls[body].supported,
                                  settings_.gravity_m_s2, dt_s);
  }
}

void World::stop_fast_pairs(double dt_s) {
  int greatest_level = 0;
  for (const PriorityList& list : settings_.schedule.lists) {
    greatest_level = std::max(greatest_level, list.greatest_level);
  }
  // A part cannot stop where its figure goes on.
  std::vector<PairBounds>& candidates = memory_.candidates;
  std::vector<PairBounds>& stoppable = memory_.stoppable;
  if (figures_) {
    stoppable.clear();
    std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(stoppable),
                 [this](const PairBounds& pair) { return !is_of_figure(pair.pair); });
  }
  const Stopping& stopping = stop_at_entry(
      {dt_s, models_, finite_.before(), figures_ ? stoppable : candidates, greatest_level,
       settings_.costs, settings_.rotation, kMostStops, memory_.falls, settings_.most_entry_tests},
      states_, placed_, memory_.entries);
  for (PairBounds& pair : candidates) {
    pair.a.centre = states_[at(pair.pair.a)].pose.position;
    pair.b.centre = states_[at(pair.pair.b)].pose.position;
  }
  StepReport& report = memory_.report;
  report.work_floor = stopping.work;
  report.stopped = stopping.stopped;
  if (!report.stopped.empty()) {
    report.degradations |= kStoppedShort;
  }
  if (stopping.ran_out) {
    report.degradations |= kEntryTestsSpent;
  }
}

void World::add_wall_candidates() {
  const WallReach reaches(*settings_.enclosure);
  for (std::size_t body = 0; body < memory_.bounds.size(); ++body) {
    const auto& [bound, travelled_m, movable] = memory_.bounds[body];
    if (movable && reaches(bound)) {
      memory_.candidates.push_back({{static_cast<std::int32_t>(body), kEnclosure}, bound, bound});
    }
  }
}

}  // namespace impetus::inline world
