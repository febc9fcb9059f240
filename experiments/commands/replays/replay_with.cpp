// SPDX-License-Identifier: MIT
#include "experiments/commands/replays/replay_with.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/new_file.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/sentences.hpp"
#include "experiments/models/atomic_file.hpp"
#include "experiments/study/replay_library.hpp"
#include "experiments/study/what_if_sums.hpp"
#include "experiments/tables/csv_line.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline commands {
namespace {

using nlohmann::json;

/// "-" of what is not a number.
std::string decimals(double value, int digits) {
  return !std::isnan(value) ? printed("%.*f", digits, value) : "-";
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
    text += printed("  at level %d: %s\n", level, both_whole(count.first, count.second).c_str());
  }
  return text;
}

std::string total_words(const WhatIfTotals& totals, std::size_t stimuli) {
  const CourseSums& then = totals.then;
  const CourseSums& now = totals.now;
  std::string text;
  text += printed("%zu stimuli; the states of %lld part, and in %lld the eye could tell\n", stimuli,
                  static_cast<long long>(totals.parted), static_cast<long long>(totals.seen_apart));
  text += printed(
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

/// A line for each, and what they come to together.
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
    for (const auto& [name, value] : named_sums(sums_of(*course))) {
      cells.push_back(value.is_number_float() ? csv_number(value)
                      : value.is_null()       ? ""
                                              : value.dump());
    }
  }
  return cells;
}

Cells csv_names() {
  Cells names{"participant",   "trial",   "slot",         "attempt", "interval",  "condition",
              "gaze_recorded", "parts_s", "seen_apart_s", "matched", "only_then", "only_now"};
  for (const char* const when : {"_then", "_now"}) {
    for (const auto& [name, value] : named_sums({})) {
      names.push_back(name + when);
    }
  }
  return names;
}

/// CSV: a row for each, after a line of names. Times in seconds, empty where nothing parted.
std::string what_if_csv(const std::vector<ComparedStimulus>& compared) {
  std::string text = csv_line(csv_names());
  for (const ComparedStimulus& each : compared) {
    text += csv_line(csv_cells(each));
  }
  return text;
}

/// The same, with every collision, and the totals.
json what_if_json(const std::vector<ComparedStimulus>& compared) {
  const WhatIfTotals totals = totals_of(compared);
  json stimuli = json::array();
  for (const ComparedStimulus& each : compared) {
    stimuli.push_back(json_of(each));
  }
  return json::object({{"stimuli", stimuli},
                       {"then", json_of(totals.then)},
                       {"now", json_of(totals.now)},
                       {"matched", totals.matches},
                       {"match_within_s", kMatchWithin_s},
                       {"parted", totals.parted},
                       {"seen_apart", totals.seen_apart},
                       {"differs", totals.differs}});
}

/// All that replay as they were; the others are named.
std::vector<ComparedStimulus> compare(ReplayLibrary& library,
                                      const std::vector<StoredAttempt>& attempts,
                                      std::int64_t& diverged) {
  ProgressLine line("simulating");
  std::vector<ComparedStimulus> all;
  for (std::size_t done = 0; done < attempts.size(); ++done) {
    const StoredAttempt& attempt = attempts[done];
    for (std::int64_t interval = 1; interval <= library.intervals(attempt); ++interval) {
      ComparedStimulus stimulus = compared(library, attempt, interval);
      if (stimulus.outcome.divergence) {
        std::printf("trial %lld diverges at step %lld: it is left out%s\n",
                    static_cast<long long>(attempt.trial_id),
                    static_cast<long long>(stimulus.outcome.divergence->step),
                    why_divergent(attempt).c_str());
        ++diverged;
      } else if (stimulus.outcome.steps > 0) {
        all.push_back(std::move(stimulus));
      }
    }
    line.tell(static_cast<double>(done + 1) / static_cast<double>(attempts.size()));
  }
  return all;
}

/// Of two values of one setting only the last would count.
void require_each_setting_once(const std::vector<std::string>& given) {
  std::map<std::string, std::string> seen;
  for (const std::string& change : given) {
    const auto [earlier, is_new] = seen.emplace(change.substr(0, change.find('=')), change);
    require(is_new,
            "--with " + change + ": expected each setting once, got also " + earlier->second);
  }
}

}  // namespace

std::string words_of_setting_keys() {
  std::string words =
      "What would have happened with this setting, for the gaze as\n"
      "recorded; as often as needed. KEY is a JSON Pointer below\n"
      "/engine of the scene, or one of:";
  for (const SettingKey& key : setting_keys()) {
    words += "\n  " + std::string(key.name) + ": " + key.meaning;
  }
  return words;
}

int replay_with(StudyFile& study, const std::vector<StoredAttempt>& attempts,
                const ReplayWithOptions& options) {
  require_new_files({{"--out", options.csv_file}, {"--json", options.json_file}});
  require_each_setting_once(options.with);
  std::vector<SettingChange> changes;
  for (const std::string& given : options.with) {
    changes.push_back(setting_change(given));
  }
  ReplayLibrary library(study, std::move(changes));
  for (const StoredAttempt& attempt : attempts) {
    library.check_changed(attempt);
  }
  std::int64_t diverged = 0;
  const std::vector<ComparedStimulus> all = compare(library, attempts, diverged);
  std::printf("as recorded -> with %s\n%s", listed(options.with).c_str(),
              what_if_words(all).c_str());
  if (!options.csv_file.empty()) {
    write_whole_file(options.csv_file, what_if_csv(all));
  }
  if (!options.json_file.empty()) {
    nlohmann::json whole = what_if_json(all);
    whole["with"] = options.with;
    write_whole_file(options.json_file, whole.dump(1) + "\n");
  }
  return diverged == 0 ? kDone : kFound;
}

}  // namespace impetus::inline commands
