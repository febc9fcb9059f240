// SPDX-License-Identifier: MIT
#include "experiments/commands/replays/what_if_sums.hpp"

#include <limits>

namespace impetus::inline commands {
namespace {

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

}  // namespace impetus::inline commands
