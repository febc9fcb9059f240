// SPDX-License-Identifier: MIT
#include "experiments/commands/what_if_tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <utility>

#include "experiments/tables/csv_line.hpp"

namespace impetus {
namespace {

using nlohmann::json;

/// Of the collisions of one course or of several, and what else is counted.
struct Sums {
  std::int64_t collisions{0};
  std::map<int, std::int64_t> by_level;
  double levels{0.0};
  double visible_arcmin{0.0};
  double at_gaze_arcmin{0.0};
  std::int64_t work_spent{0};
  std::int64_t steps_over_budget{0};
  std::int64_t pops{0};
  std::int64_t stopped_short{0};
  std::int64_t imposed_holds{0};
  std::int64_t imposed_spins{0};

  /// Mean over the collisions; not a number without any.
  [[nodiscard]] double mean(double sum) const {
    return collisions > 0 ? sum / static_cast<double>(collisions)
                          : std::numeric_limits<double>::quiet_NaN();
  }
};

void add(Sums& sums, const Course& course) {
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

Sums sums_of(const Course& course) {
  Sums sums;
  add(sums, course);
  return sums;
}

struct Matches {
  std::int64_t both{0};
  std::int64_t only_then{0};
  std::int64_t only_now{0};
};

void add(Matches& matches, const WhatIf& outcome) {
  for (const CollisionMatch& match : outcome.matches) {
    matches.both += match.then && match.now ? 1 : 0;
    matches.only_then += match.now ? 0 : 1;
    matches.only_now += match.then ? 0 : 1;
  }
}

Matches matches_of(const WhatIf& outcome) {
  Matches matches;
  add(matches, outcome);
  return matches;
}

double seconds(const std::optional<std::int64_t>& step, double step_hz) {
  return step ? static_cast<double>(*step) / step_hz : std::numeric_limits<double>::quiet_NaN();
}

struct Totals {
  Sums then;
  Sums now;
  Matches matches;
  std::int64_t parted{0};
  std::int64_t seen_apart{0};
  bool differs{false};
};

bool same_course(const Course& one, const Course& other) {
  const Sums a = sums_of(one);
  const Sums b = sums_of(other);
  return a.by_level == b.by_level && a.visible_arcmin == b.visible_arcmin &&
         a.work_spent == b.work_spent && a.steps_over_budget == b.steps_over_budget &&
         a.pops == b.pops;
}

Totals totals_of(const std::vector<ComparedStimulus>& compared) {
  Totals totals;
  for (const ComparedStimulus& each : compared) {
    const WhatIf& outcome = each.outcome;
    add(totals.then, outcome.then);
    add(totals.now, outcome.now);
    add(totals.matches, outcome);
    totals.parted += outcome.parts_at ? 1 : 0;
    totals.seen_apart += outcome.seen_apart_at ? 1 : 0;
    totals.differs |= outcome.parts_at.has_value() || !same_course(outcome.then, outcome.now);
  }
  return totals;
}

template <typename... Values>
std::string formatted(const char* format, Values... values) {
  char text[300];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

std::string whole(std::int64_t value) { return std::to_string(value); }

/// "-" of what is not a number.
std::string decimals(double value, int digits) {
  return !std::isnan(value) ? formatted("%.*f", digits, value) : "-";
}

std::string both_whole(std::int64_t then, std::int64_t now) {
  return whole(then) + " -> " + whole(now);
}

std::string both_decimals(double then, double now, int digits = 2) {
  return decimals(then, digits) + " -> " + decimals(now, digits);
}

using Cells = std::vector<std::string>;

Cells cells_of(const ComparedStimulus& each) {
  const WhatIf& outcome = each.outcome;
  const Sums then = sums_of(outcome.then);
  const Sums now = sums_of(outcome.now);
  const Matches matches = matches_of(outcome);
  std::string trial = whole(each.attempt->trial_id);
  trial += each.attempt->number > 1 ? " attempt " + whole(each.attempt->number) : "";
  trial += each.interval > 1 ? " interval " + whole(each.interval) : "";
  return {trial,
          each.attempt->participant,
          decimals(seconds(outcome.parts_at, each.step_hz), 3),
          decimals(seconds(outcome.seen_apart_at, each.step_hz), 3),
          both_whole(then.collisions, now.collisions),
          whole(matches.both),
          whole(matches.only_then),
          whole(matches.only_now),
          both_decimals(then.mean(then.levels), now.mean(now.levels)),
          both_decimals(then.mean(then.visible_arcmin), now.mean(now.visible_arcmin)),
          both_decimals(then.mean(then.at_gaze_arcmin), now.mean(now.at_gaze_arcmin)),
          both_whole(then.work_spent, now.work_spent)};
}

/// Columns as wide as they need, numbers to the right.
std::string aligned(const std::vector<Cells>& rows) {
  constexpr std::size_t kWords = 2;  // columns to the left that are words
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Cells& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  std::string text;
  for (const Cells& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string space(widths[i] - row[i].size(), ' ');
      text += (i == 0 ? "" : "  ") + (i < kWords ? row[i] + space : space + row[i]);
    }
    text += "\n";
  }
  return text;
}

std::string level_words(const Sums& then, const Sums& now) {
  std::map<int, std::pair<std::int64_t, std::int64_t>> counts;
  for (const auto& [level, count] : then.by_level) {
    counts[level].first = count;
  }
  for (const auto& [level, count] : now.by_level) {
    counts[level].second = count;
  }
  std::string text;
  for (const auto& [level, count] : counts) {
    text += formatted("  at level %d: %s\n", level, both_whole(count.first, count.second).c_str());
  }
  return text;
}

std::string total_words(const Totals& totals, std::size_t stimuli) {
  const Sums& then = totals.then;
  const Sums& now = totals.now;
  std::string text;
  text +=
      formatted("%zu stimuli; the states of %lld part, and in %lld the eye could tell\n", stimuli,
                static_cast<long long>(totals.parted), static_cast<long long>(totals.seen_apart));
  text += formatted(
      "collisions %s: %lld of the same pair within %.0f ms, %lld only then, %lld only now\n",
      both_whole(then.collisions, now.collisions).c_str(),
      static_cast<long long>(totals.matches.both), 1e3 * kMatchWithin_s,
      static_cast<long long>(totals.matches.only_then),
      static_cast<long long>(totals.matches.only_now));
  text += level_words(then, now);
  text += "mean level " + both_decimals(then.mean(then.levels), now.mean(now.levels)) + "\n";
  text += "visible gap, mean of the collisions (minutes of arc) " +
          both_decimals(then.mean(then.visible_arcmin), now.mean(now.visible_arcmin)) +
          ", as hard to see where one looks " +
          both_decimals(then.mean(then.at_gaze_arcmin), now.mean(now.at_gaze_arcmin)) + "\n";
  text += "units of work " + both_whole(then.work_spent, now.work_spent) + "; steps over budget " +
          both_whole(then.steps_over_budget, now.steps_over_budget) +
          "; falls to a coarser level " + both_whole(then.pops, now.pops) + "; stopped at entry " +
          both_whole(then.stopped_short, now.stopped_short) + "\n";
  text += "imposed: holds " + both_whole(then.imposed_holds, now.imposed_holds) + ", spins " +
          both_whole(then.imposed_spins, now.imposed_spins) + "\n";
  return text;
}

json number_or_null(double value) { return !std::isnan(value) ? json(value) : json(); }

json json_of(const Sums& sums) {
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

json json_of(const Matches& matches) {
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

json collisions_of(const ComparedStimulus& each) {
  const auto name = [&each](std::int32_t body) {
    return is_wall(body) ? wall_name(body, each.walls)
                         : each.bodies[static_cast<std::size_t>(body)];
  };
  json collisions = json::array();
  for (const CollisionMatch& match : each.outcome.matches) {
    const auto* then = match.then ? &each.outcome.then.collisions[*match.then] : nullptr;
    const auto* now = match.now ? &each.outcome.now.collisions[*match.now] : nullptr;
    const BodyPair bodies = (then != nullptr ? then : now)->bodies;
    collisions.push_back(json::object({{"body_a", name(bodies.a)},
                                       {"body_b", name(bodies.b)},
                                       {"then", then != nullptr ? json_of(*then) : json()},
                                       {"now", now != nullptr ? json_of(*now) : json()}}));
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
                       {"matched", json_of(matches_of(each.outcome))},
                       {"collisions", collisions_of(each)}});
}

Cells csv_cells(const ComparedStimulus& each) {
  const WhatIf& outcome = each.outcome;
  const Matches matches = matches_of(outcome);
  Cells cells{each.attempt->participant,
              whole(each.attempt->trial_id),
              whole(each.attempt->trial.slot),
              whole(each.attempt->number),
              whole(each.interval),
              each.attempt->trial.condition,
              each.has_gaze ? "1" : "0",
              csv_number(seconds(outcome.parts_at, each.step_hz)),
              csv_number(seconds(outcome.seen_apart_at, each.step_hz)),
              whole(matches.both),
              whole(matches.only_then),
              whole(matches.only_now)};
  for (const Course* course : {&outcome.then, &outcome.now}) {
    const Sums sums = sums_of(*course);
    for (const std::string& cell :
         {whole(sums.collisions), csv_number(sums.mean(sums.levels)),
          csv_number(sums.mean(sums.visible_arcmin)), csv_number(sums.mean(sums.at_gaze_arcmin)),
          whole(sums.work_spent), whole(sums.steps_over_budget), whole(sums.pops),
          whole(sums.stopped_short), whole(sums.imposed_holds), whole(sums.imposed_spins)}) {
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

std::string what_if_words(const std::vector<ComparedStimulus>& compared) {
  if (compared.empty()) {
    return "no stimulus was shown\n";
  }
  std::vector<Cells> rows{{"trial", "participant", "parts s", "seen s", "collisions", "both",
                           "only then", "only now", "level", "gap arcmin", "at gaze", "work"}};
  for (const ComparedStimulus& each : compared) {
    rows.push_back(cells_of(each));
  }
  const Totals totals = totals_of(compared);
  const bool no_gaze = std::none_of(compared.begin(), compared.end(),
                                    [](const ComparedStimulus& each) { return each.has_gaze; });
  return aligned(rows) + "\n" + total_words(totals, compared.size()) +
         (no_gaze ? "no gaze was recorded: the screen's centre stands in for it\n" : "") +
         (totals.differs ? "" : "nothing differs\n");
}

std::string what_if_csv(const std::vector<ComparedStimulus>& compared) {
  std::string text = csv_line(csv_names());
  for (const ComparedStimulus& each : compared) {
    text += csv_line(csv_cells(each));
  }
  return text;
}

json what_if_json(const std::vector<ComparedStimulus>& compared) {
  const Totals totals = totals_of(compared);
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

}  // namespace impetus
