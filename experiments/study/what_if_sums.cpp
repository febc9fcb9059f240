// SPDX-License-Identifier: MIT
#include "experiments/study/what_if_sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/settings/optional_json.hpp"

namespace impetus::inline study {
namespace {

using nlohmann::json;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

void add(CourseSums& sums, const WhatIfCourse& course) {
  for (const SeenCollision& collision : course.collisions) {
    ++sums.collisions;
    ++sums.by_level[collision.level];
    sums.levels += collision.level;
    sums.visible_arcmin += collision.visible_arcmin;
    sums.at_gaze_arcmin += collision.at_gaze_arcmin;
  }
  sums.work_spent += course.work_spent;
  sums.steps_over_budget += course.steps_over_budget;
  sums.pops += course.pops;
  sums.stopped_short += course.stopped_short;
  sums.imposed_holds += course.imposed_holds;
  sums.imposed_spins += course.imposed_spins;
}

void add(MatchCounts& counts, const WhatIf& outcome) {
  for (const CollisionMatch& match : outcome.matches) {
    counts.both += match.then && match.now ? 1 : 0;
    counts.only_then += match.now ? 0 : 1;
    counts.only_now += match.then ? 0 : 1;
  }
}

json number_or_null(double value) { return !std::isnan(value) ? json(value) : json(); }

json json_of(const SeenCollision& collision) {
  return json::object({{"step", collision.step},
                       {"level", collision.level},
                       {"stopped", name_of(collision.stop)},
                       {"gap_arcmin", collision.gap_arcmin},
                       {"visible_gap_arcmin", collision.visible_arcmin},
                       {"gap_at_gaze_arcmin", collision.at_gaze_arcmin}});
}

json collision_or_null(const WhatIfCourse& course, const std::optional<std::size_t>& place) {
  return place ? json_of(course.collisions[*place]) : json();
}

json collisions_of(const ComparedStimulus& each) {
  const WhatIfCourse& then = each.outcome.then;
  const WhatIfCourse& now = each.outcome.now;
  const auto name = [&each](std::int32_t body) {
    return body_or_wall_name(body, each.bodies, each.walls);
  };
  json collisions = json::array();
  for (const CollisionMatch& match : each.outcome.matches) {
    const SeenCollision& either =
        match.then ? then.collisions[*match.then] : now.collisions[match.now.value()];
    collisions.push_back(json::object({{"body_a", name(either.bodies.a)},
                                       {"body_b", name(either.bodies.b)},
                                       {"then", collision_or_null(then, match.then)},
                                       {"now", collision_or_null(now, match.now)}}));
  }
  return collisions;
}

bool follows_gaze(const std::vector<StepRecord>& steps) {
  return std::any_of(steps.begin(), steps.end(),
                     [](const StepRecord& step) { return step.gaze.fixation.has_value(); });
}

}  // namespace

double CourseSums::mean(double sum) const {
  return collisions > 0 ? sum / static_cast<double>(collisions) : kNone;
}

CourseSums sums_of(const WhatIfCourse& course) {
  CourseSums sums;
  add(sums, course);
  return sums;
}

MatchCounts counts_of(const WhatIf& outcome) {
  MatchCounts counts;
  add(counts, outcome);
  return counts;
}

WhatIfTotals totals_of(const std::vector<ComparedStimulus>& compared) {
  WhatIfTotals totals;
  for (const ComparedStimulus& each : compared) {
    const WhatIf& outcome = each.outcome;
    add(totals.then, outcome.then);
    add(totals.now, outcome.now);
    add(totals.matches, outcome);
    totals.parted += outcome.parts_at ? 1 : 0;
    totals.seen_apart += outcome.seen_apart_at ? 1 : 0;
    totals.differs |= outcome.parts_at.has_value() || sums_of(outcome.then) != sums_of(outcome.now);
  }
  return totals;
}

double seconds_of(const std::optional<std::int64_t>& step, double step_hz) {
  return step ? static_cast<double>(*step) / step_hz : kNone;
}

ComparedStimulus compared(ReplayLibrary& library, const StoredAttempt& attempt,
                          std::int64_t interval) {
  const std::vector<StepRecord> steps = library.steps(attempt, interval);
  StagedScene then = library.stage(attempt, interval);
  StagedScene now = library.stage_changed(attempt, interval);
  ComparedStimulus result;
  result.attempt = &attempt;
  result.interval = interval;
  result.step_hz = then.step_hz;
  result.walls = wall_naming(then.world.settings().enclosure);
  result.has_gaze = follows_gaze(steps);
  result.bodies = body_names(then.world);
  result.outcome = what_if(std::move(then), std::move(now), steps, attempt.trial.seed);
  return result;
}

std::vector<std::pair<std::string, json>> named_sums(const CourseSums& sums) {
  return {{"collisions", sums.collisions},
          {"mean_level", number_or_null(sums.mean(sums.levels))},
          {"mean_visible_gap_arcmin", number_or_null(sums.mean(sums.visible_arcmin))},
          {"mean_gap_at_gaze_arcmin", number_or_null(sums.mean(sums.at_gaze_arcmin))},
          {"work_spent", sums.work_spent},
          {"steps_over_budget", sums.steps_over_budget},
          {"pops", sums.pops},
          {"stopped_short", sums.stopped_short},
          {"imposed_holds", sums.imposed_holds},
          {"imposed_spins", sums.imposed_spins}};
}

nlohmann::json json_of(const CourseSums& sums) {
  json result = {{"collisions_by_level", json::object()}};
  for (const auto& [level, count] : sums.by_level) {
    result["collisions_by_level"][std::to_string(level)] = count;
  }
  for (const auto& [name, value] : named_sums(sums)) {
    result[name] = value;
  }
  return result;
}

nlohmann::json json_of(const ComparedStimulus& each) {
  return json::object({{"participant", each.attempt->participant},
                       {"trial", each.attempt->trial_id},
                       {"slot", each.attempt->trial.slot},
                       {"attempt", each.attempt->number},
                       {"interval", each.interval},
                       {"condition", json::parse(each.attempt->trial.condition)},
                       {"gaze_recorded", each.has_gaze},
                       {"step_hz", each.step_hz},
                       {"steps", each.outcome.steps},
                       {"parts_at_step", each.outcome.parts_at},
                       {"seen_apart_at_step", each.outcome.seen_apart_at},
                       {"then", json_of(sums_of(each.outcome.then))},
                       {"now", json_of(sums_of(each.outcome.now))},
                       {"matched", counts_of(each.outcome)},
                       {"collisions", collisions_of(each)}});
}

}  // namespace impetus::inline study
