// SPDX-License-Identifier: MIT
#include "experiments/commands/replays/what_if_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

namespace impetus::inline commands {
namespace {

template <typename... Values>
std::string formatted(const char* format, Values... values) {
  char text[300];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// "-" of what is not a number.
std::string decimals(double value, int digits) {
  return !std::isnan(value) ? formatted("%.*f", digits, value) : "-";
}

std::string both_whole(std::int64_t then, std::int64_t now) {
  return std::to_string(then) + " -> " + std::to_string(now);
}

std::string both_decimals(double then, double now, int digits = 2) {
  return decimals(then, digits) + " -> " + decimals(now, digits);
}

using Cells = std::vector<std::string>;

Cells cells_of(const ComparedStimulus& each) {
  const WhatIf& outcome = each.outcome;
  const CourseSums then = sums_of(outcome.then);
  const CourseSums now = sums_of(outcome.now);
  const MatchCounts matches = counts_of(outcome);
  std::string trial = std::to_string(each.attempt->trial_id);
  trial += each.attempt->number > 1 ? " attempt " + std::to_string(each.attempt->number) : "";
  trial += each.interval > 1 ? " interval " + std::to_string(each.interval) : "";
  return {trial,
          each.attempt->participant,
          decimals(seconds_of(outcome.parts_at, each.step_hz), 3),
          decimals(seconds_of(outcome.seen_apart_at, each.step_hz), 3),
          both_whole(then.collisions, now.collisions),
          std::to_string(matches.both),
          std::to_string(matches.only_then),
          std::to_string(matches.only_now),
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

std::string level_words(const CourseSums& then, const CourseSums& now) {
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

std::string total_words(const WhatIfTotals& totals, std::size_t stimuli) {
  const CourseSums& then = totals.then;
  const CourseSums& now = totals.now;
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
  const WhatIfTotals totals = totals_of(compared);
  const bool no_gaze = std::none_of(compared.begin(), compared.end(),
                                    [](const ComparedStimulus& each) { return each.has_gaze; });
  return aligned(rows) + "\n" + total_words(totals, compared.size()) +
         (no_gaze ? "no gaze was recorded: the screen's centre stands in for it\n" : "") +
         (totals.differs ? "" : "nothing differs\n");
}

}  // namespace impetus::inline commands
