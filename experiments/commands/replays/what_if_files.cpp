// SPDX-License-Identifier: MIT
#include "experiments/commands/replays/what_if_files.hpp"

#include <cmath>

#include "experiments/tables/csv_line.hpp"

namespace impetus::inline commands {
namespace {

using nlohmann::json;

using Cells = std::vector<std::string>;

json number_or_null(double value) { return !std::isnan(value) ? json(value) : json(); }

json json_of(const CourseSums& sums) {
  json levels = json::object();
  for (const auto& [level, count] : sums.by_level) {
    levels[std::to_string(level)] = count;
  }
  return json::object({{"collisions", sums.collisions},
                       {"collisions_by_level", levels},
                       {"mean_level", number_or_null(sums.mean(sums.levels))},
                       {"mean_visible_gap_arcmin", number_or_null(sums.mean(sums.visible_arcmin))},
                       {"mean_gap_at_gaze_arcmin", number_or_null(sums.mean(sums.at_gaze_arcmin))},
                       {"work_spent", sums.work_spent},
                       {"steps_over_budget", sums.steps_over_budget},
                       {"pops", sums.pops},
                       {"stopped_short", sums.stopped_short},
                       {"imposed_holds", sums.imposed_holds},
                       {"imposed_spins", sums.imposed_spins}});
}

json json_of(const MatchCounts& matches) {
  return json::object(
      {{"both", matches.both}, {"only_then", matches.only_then}, {"only_now", matches.only_now}});
}

const char* word_of(StopReason stop) {
  return stop == StopReason::kBudgetSpent     ? "budget"
         : stop == StopReason::kGreatestLevel ? "greatest level"
         : stop == StopReason::kCapped        ? "capped"
                                              : "finest";
}

json json_of(const SeenCollision& collision) {
  return json::object({{"step", collision.step},
                       {"level", collision.level},
                       {"stopped", word_of(collision.stop)},
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
    return is_wall(body) ? wall_name(body, each.walls)
                         : each.bodies[static_cast<std::size_t>(body)];
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

json step_or_null(const std::optional<std::int64_t>& step) { return step ? json(*step) : json(); }

json json_of(const ComparedStimulus& each) {
  return json::object({{"participant", each.attempt->participant},
                       {"trial", each.attempt->trial_id},
                       {"slot", each.attempt->trial.slot},
                       {"attempt", each.attempt->number},
                       {"interval", each.interval},
                       {"condition", json::parse(each.attempt->trial.condition)},
                       {"gaze_recorded", each.has_gaze},
                       {"step_hz", each.step_hz},
                       {"steps", each.outcome.steps},
                       {"parts_at_step", step_or_null(each.outcome.parts_at)},
                       {"seen_apart_at_step", step_or_null(each.outcome.seen_apart_at)},
                       {"then", json_of(sums_of(each.outcome.then))},
                       {"now", json_of(sums_of(each.outcome.now))},
                       {"matched", json_of(counts_of(each.outcome))},
                       {"collisions", collisions_of(each)}});
}

Cells csv_cells(const ComparedStimulus& each) {
  const WhatIf& outcome = each.outcome;
  const MatchCounts matches = counts_of(outcome);
  Cells cells{each.attempt->participant,
              std::to_string(each.attempt->trial_id),
              std::to_string(each.attempt->trial.slot),
              std::to_string(each.attempt->number),
              std::to_string(each.interval),
              each.attempt->trial.condition,
              each.has_gaze ? "1" : "0",
              csv_number(seconds_of(outcome.parts_at, each.step_hz)),
              csv_number(seconds_of(outcome.seen_apart_at, each.step_hz)),
              std::to_string(matches.both),
              std::to_string(matches.only_then),
              std::to_string(matches.only_now)};
  for (const WhatIfCourse* course : {&outcome.then, &outcome.now}) {
    const CourseSums sums = sums_of(*course);
    for (const std::string& cell :
         {std::to_string(sums.collisions), csv_number(sums.mean(sums.levels)),
          csv_number(sums.mean(sums.visible_arcmin)), csv_number(sums.mean(sums.at_gaze_arcmin)),
          std::to_string(sums.work_spent), std::to_string(sums.steps_over_budget),
          std::to_string(sums.pops), std::to_string(sums.stopped_short),
          std::to_string(sums.imposed_holds), std::to_string(sums.imposed_spins)}) {
      cells.push_back(cell);
    }
  }
  return cells;
}

Cells csv_names() {
  Cells names{"participant",   "trial",   "slot",         "attempt", "interval",  "condition",
              "gaze_recorded", "parts_s", "seen_apart_s", "matched", "only_then", "only_now"};
  for (const char* when : {"then", "now"}) {
    for (const char* what : {"collisions", "mean_level", "mean_visible_gap_arcmin",
                             "mean_gap_at_gaze_arcmin", "work_spent", "steps_over_budget", "pops",
                             "stopped_short", "imposed_holds", "imposed_spins"}) {
      names.push_back(std::string(what) + "_" + when);
    }
  }
  return names;
}

}  // namespace

std::string what_if_csv(const std::vector<ComparedStimulus>& compared) {
  std::string text = csv_line(csv_names());
  for (const ComparedStimulus& each : compared) {
    text += csv_line(csv_cells(each));
  }
  return text;
}

json what_if_json(const std::vector<ComparedStimulus>& compared) {
  const WhatIfTotals totals = totals_of(compared);
  json stimuli = json::array();
  for (const ComparedStimulus& each : compared) {
    stimuli.push_back(json_of(each));
  }
  return json::object({{"stimuli", stimuli},
                       {"then", json_of(totals.then)},
                       {"now", json_of(totals.now)},
                       {"matched", json_of(totals.matches)},
                       {"match_within_s", kMatchWithin_s},
                       {"parted", totals.parted},
                       {"seen_apart", totals.seen_apart},
                       {"differs", totals.differs}});
}

}  // namespace impetus::inline commands
