// SPDX-License-Identifier: MIT
#include "experiments/commands/replays/replay_with.hpp"

#include <algorithm>
#include <cstdio>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/new_file.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/replays/replayed_trial.hpp"
#include "experiments/commands/replays/what_if_files.hpp"
#include "experiments/commands/replays/what_if_words.hpp"
#include "experiments/models/atomic_file.hpp"

namespace impetus::inline commands {
namespace {

bool follows_gaze(const std::vector<StepRecord>& steps) {
  return std::any_of(steps.begin(), steps.end(),
                     [](const StepRecord& step) { return step.gaze.fixation.has_value(); });
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
  for (const DrawnBody& look : then.looks) {
    result.bodies.push_back(look.name);
  }
  result.outcome = what_if(std::move(then), std::move(now), steps, attempt.trial.seed);
  return result;
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

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
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
  require_new_file(options.csv_file);
  require_new_file(options.json_file);
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
  std::printf("as recorded -> with %s\n%s", joined(options.with).c_str(),
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
