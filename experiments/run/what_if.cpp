// SPDX-License-Identifier: MIT
#include "experiments/run/what_if.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "engine/scheduling/eccentricity_metric.hpp"
#include "experiments/run/collision_truth.hpp"
#include "experiments/run/seen_apart.hpp"

namespace impetus::inline run {
namespace {

/// One of the two, as it goes.
class Running {
 public:
  Running(StagedScene scene, std::uint64_t seed) : run_(std::move(scene), seed) {}

  const StepReport& step(const StepRecord& recorded, const std::optional<GazeRegion>& region,
                         const WorkGrants& granted) {
    FixedWork meter(granted);
    const StepReport& report = run_.step(recorded.gaze.fixation, region, meter);
    keep(report);
    return report;
  }

  SceneRun& run() { return run_; }
  [[nodiscard]] const StagedScene& scene() const { return run_.scene(); }
  WhatIfCourse take_course() { return std::move(course_); }

 private:
  void keep(const StepReport& report) {
    course_.work_spent += report.work_spent;
    course_.steps_over_budget += (report.degradations & kFloorOverBudget) != 0 ? 1 : 0;
    course_.pops += static_cast<std::int64_t>(report.pops.size());
    course_.stopped_short += static_cast<std::int64_t>(report.stopped.size());
    for (const CollisionReport& collision : report.collisions) {
      course_.imposed_holds += collision.imposed_hold_s > 0.0 ? 1 : 0;
      course_.imposed_spins += collision.imposed_spin ? 1 : 0;
      if (collision.began) {
        course_.collisions.push_back(seen(collision));
      }
    }
  }

  [[nodiscard]] SeenCollision seen(const CollisionReport& collision) const {
    const CollisionTruth truth =
        measure_truth(scene(), run_.world(), collision.bodies, run_.number());
    const StepInput& input = run_.input();
    const Vector3 looked_at = on_screen(input.viewer, input.fixation.value_or(ScreenPoint{}));
    const double eccentricity_deg =
        visual_angle_deg(input.viewer, collision.contact.touch.point, looked_at);
    return {run_.number(),
            collision.bodies,
            collision.level,
            collision.stop,
            truth.gap_arcmin,
            truth.visible_arcmin(),
            truth.visible_arcmin() * relative_acuity(eccentricity_deg)};
  }

  SceneRun run_;
  WhatIfCourse course_;
};

/// The region of the next step of `now`: what was recorded where both have the same rule, and about
/// the same places where it follows another participant's gaze.
std::optional<GazeRegion> region_now(const RegionRule& then, SceneRun& now,
                                     const StepRecord& recorded) {
  const RegionRule& rule = now.scene().region;
  const std::optional<GazeRegion> own = now.next_region(recorded.gaze.fixation);
  if (then == rule) {
    return recorded.gaze.region;
  }
  if (rule.kind == RegionKind::kRecorded && recorded.gaze.region) {
    return GazeRegion{recorded.gaze.region->centre, rule.radius_deg};
  }
  return own;
}

bool any_seen_apart(const Running& then, const Running& now, const Viewer& viewer) {
  const StagedScene& scene = then.scene();
  const std::vector<BodyState>& states = scene.world.states();
  const std::vector<BodyState>& others = now.scene().world.states();
  for (std::size_t body = 0; body < states.size(); ++body) {
    if (seen_apart(states[body].pose, others[body].pose, scene.looks[body].mesh != nullptr,
                   viewer)) {
      return true;
    }
  }
  return false;
}

WorkGrants granted_now(const WorkBudget& budget, const StepRecord& recorded) {
  if (budget.ns_per_step > 0) {
    return grants_of(recorded);
  }
  WorkGrants granted;
  granted.of(WorkPhase::kRefinement) = budget.tests_per_step;
  return granted;
}

/// Of one pair, in order, by their places in a list.
using Places = std::vector<std::size_t>;

std::map<std::pair<std::int32_t, std::int32_t>, Places> by_pair(
    const std::vector<SeenCollision>& collisions) {
  std::map<std::pair<std::int32_t, std::int32_t>, Places> places;
  for (std::size_t i = 0; i < collisions.size(); ++i) {
    places[{collisions[i].bodies.a, collisions[i].bodies.b}].push_back(i);
  }
  return places;
}

}  // namespace

std::vector<CollisionMatch> matched(const std::vector<SeenCollision>& then,
                                    const std::vector<SeenCollision>& now,
                                    std::int64_t within_steps) {
  std::vector<CollisionMatch> matches;
  const auto now_by_pair = by_pair(now);
  std::vector<bool> met(now.size(), false);
  for (const auto& [pair, places] : by_pair(then)) {
    const auto found = now_by_pair.find(pair);
    const Places others = found == now_by_pair.end() ? Places{} : found->second;
    std::size_t next = 0;
    for (const std::size_t place : places) {
      const std::int64_t step = then[place].step;
      while (next < others.size() && now[others[next]].step < step - within_steps) {
        ++next;
      }
      const bool meets = next < others.size() && now[others[next]].step <= step + within_steps;
      matches.push_back({place, meets ? std::optional(others[next]) : std::nullopt});
      if (meets) {
        met[others[next++]] = true;
      }
    }
  }
  for (std::size_t place = 0; place < now.size(); ++place) {
    if (!met[place]) {
      matches.push_back({std::nullopt, place});
    }
  }
  const auto order = [&](const CollisionMatch& match) {
    const BodyPair bodies = match.then ? then[*match.then].bodies : now[*match.now].bodies;
    const std::int64_t step = match.then && match.now
                                  ? std::min(then[*match.then].step, now[*match.now].step)
                              : match.then ? then[*match.then].step
                                           : now[*match.now].step;
    return std::tuple(step, bodies.a, bodies.b, match.then.has_value());
  };
  std::stable_sort(matches.begin(), matches.end(),
                   [&](const CollisionMatch& one, const CollisionMatch& other) {
                     return order(one) < order(other);
                   });
  return matches;
}

WhatIf what_if(StagedScene then, StagedScene now, const std::vector<StepRecord>& recorded,
               std::uint64_t seed) {
  WhatIf result;
  Running first(std::move(then), seed);
  Running second(std::move(now), seed);
  for (const StepRecord& step : recorded) {
    if (step.step == 0) {
      result.divergence =
          divergence_of(step, hash_state(first.scene().world.states()), first.scene().world);
    } else {
      const StepReport& was = first.step(step, step.gaze.region, grants_of(step));
      result.divergence = divergence_of(step, was.state, first.scene().world);
      const StepReport& is = second.step(step, region_now(first.scene().region, second.run(), step),
                                         granted_now(second.scene().budget, step));
      ++result.steps;
      if (!result.parts_at && was.state.hash != is.state.hash) {
        result.parts_at = step.step;
      }
      if (result.parts_at && !result.seen_apart_at &&
          any_seen_apart(first, second, first.run().input().viewer)) {
        result.seen_apart_at = step.step;
      }
    }
    if (result.divergence) {
      return result;
    }
  }
  const double step_hz = first.scene().step_hz;
  result.then = first.take_course();
  result.now = second.take_course();
  result.matches = matched(result.then.collisions, result.now.collisions,
                           std::llround(kMatchWithin_s * step_hz));
  return result;
}

}  // namespace impetus::inline run
