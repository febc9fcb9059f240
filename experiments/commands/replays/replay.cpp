// `impetus replay`: simulates every recorded trial again and compares each step's hash.
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <optional>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/replays/replay_levels.hpp"
#include "experiments/commands/replays/replay_with.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/run/collision_truth.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/store/study_reader.hpp"
#include "experiments/study/replay_comparison.hpp"
#include "experiments/tables/text_table.hpp"

#ifdef IMPETUS_WINDOW
#include "experiments/commands/replays/replay_viewing.hpp"
#endif

namespace impetus::inline commands {
namespace {

// `impetus replay --truth`: fills the study's table of what was wrong with each collision.

/// The truth of an interval's collisions; tells and returns nothing when it diverges.
std::optional<std::vector<MeasuredCollision>> measured(StudyFile& study, ReplayLibrary& library,
                                                       const StoredAttempt& attempt,
                                                       std::int64_t interval) {
  const StagedScene scene = library.stage(attempt, interval);
  std::vector<MeasuredCollision> truths;
  const std::vector<StoredCollision> collisions =
      load_collisions(study, attempt.id, body_names(scene.world), interval);
  const ReplayResult result = replay(
      scene, library.steps(attempt, interval),
      [&](std::int64_t step, const World& world, const StepReport&) {
        for (const StoredCollision& collision : collisions) {
          if (collision.step == step) {
            truths.push_back({collision.id, measure_truth(scene, world, collision.bodies, step)});
          }
        }
      });
  if (result.divergence) {
    std::printf("trial %lld diverges at step %lld: its collisions are left without truth%s\n",
                static_cast<long long>(attempt.trial_id),
                static_cast<long long>(result.divergence->step), why_divergent(attempt).c_str());
    return std::nullopt;
  }
  return truths;
}

/// Of all intervals of an attempt.
std::optional<std::vector<MeasuredCollision>> measured(StudyFile& study, ReplayLibrary& library,
                                                       const StoredAttempt& attempt) {
  std::vector<MeasuredCollision> all;
  for (std::int64_t interval = 1; interval <= library.intervals(attempt); ++interval) {
    const auto truths = measured(study, library, attempt, interval);
    if (!truths) {
      return std::nullopt;
    }
    all.insert(all.end(), truths->begin(), truths->end());
  }
  return all;
}

/// Measures every recorded collision of the attempts and stores it; returns the exit status. A
/// trial that diverges is named and left without truth. `study` must be open for writing.
int fill_truth(StudyFile& study, const std::vector<StoredAttempt>& attempts) {
  ReplayLibrary library(study);
  const bool terminal = isatty(STDERR_FILENO) != 0;
  int status = kDone;
  std::size_t count = 0;
  for (std::size_t done = 0; done < attempts.size(); ++done) {
    const auto truths = measured(study, library, attempts[done]);
    if (!truths) {
      status = kFound;
      continue;
    }
    store_truths(study, *truths);
    count += truths->size();
    if (terminal) {
      std::fprintf(stderr, "\rtrial %zu of %zu", done + 1, attempts.size());
    }
  }
  if (terminal) {
    std::fprintf(stderr, "\n");
  }
  std::printf("%zu collisions measured in %zu trials\n", count, attempts.size());
  return status;
}

/// What `impetus replay` was asked for.
struct ReplayOptions {
  std::string study;
  std::optional<std::int64_t> trial;
  std::string participant;
  bool view{false};
  bool truth{false};
  std::string window_size;
  ReplayWithOptions what_if;
};

std::vector<StoredAttempt> chosen_attempts(StudyFile& study, const ReplayOptions& options) {
  std::vector<StoredAttempt> attempts = load_attempts(study);
  std::erase_if(attempts, [&](const StoredAttempt& attempt) {
    return (options.trial && attempt.trial_id != *options.trial) ||
           (!options.participant.empty() && attempt.participant != options.participant);
  });
  if (attempts.empty() && (options.trial || !options.participant.empty())) {
    throw InputError(study.name() + ": expected a recorded trial" +
                     (options.trial ? " " + std::to_string(*options.trial) : "") +
                     (options.participant.empty() ? "" : " of " + options.participant) +
                     ", but there is none");
  }
  return attempts;
}

void print(const StoredAttempt& attempt, const std::string& what) {
  std::printf("trial %lld (%s, slot %lld, attempt %lld): %s\n",
              static_cast<long long>(attempt.trial_id), printable(attempt.participant).c_str(),
              static_cast<long long>(attempt.trial.slot), static_cast<long long>(attempt.number),
              printable(what).c_str());
}

/// Whether the attempt is as it was recorded; what is not is told.
bool replays(ReplayComparison& comparison, const StoredAttempt& attempt) {
  const std::string problem = comparison.problem_of(attempt);
  for (const std::string& taken_out : comparison.taken_out()) {
    print(attempt, taken_out);
  }
  if (!problem.empty()) {
    print(attempt, problem);
  }
  return problem.empty();
}

int compare_all(StudyFile& study, const std::vector<StoredAttempt>& attempts) {
  using Seconds = std::chrono::duration<double>;
  ReplayLibrary library(study);
  ReplayComparison comparison(study, library);
  std::int64_t diverged = 0;
  const auto start = std::chrono::steady_clock::now();
  for (const StoredAttempt& attempt : attempts) {
    diverged += replays(comparison, attempt) ? 0 : 1;
  }
  diverged += compare_levels(study, attempts, library);
  const double took_s = Seconds(std::chrono::steady_clock::now() - start).count();
  const double times = comparison.simulated_s() / took_s;
  std::printf("%zu trials, %lld steps, %.*f times real time, %lld divergent\n", attempts.size(),
              static_cast<long long>(comparison.steps()), times < 10.0 ? 1 : 0, times,
              static_cast<long long>(diverged));
  return diverged == 0 ? kDone : kFound;
}

void require_one_purpose(const ReplayOptions& options) {
  const bool asks = !options.what_if.with.empty();
  if (asks && (options.view || options.truth)) {
    throw InputError(std::string("--with: expected neither --view nor --truth beside it, got ") +
                     (options.view ? "--view" : "--truth"));
  }
  if (options.view && options.truth) {
    throw InputError("--view: expected no --truth beside it");
  }
  if (!asks && !(options.what_if.csv_file.empty() && options.what_if.json_file.empty())) {
    throw InputError(std::string(options.what_if.csv_file.empty() ? "--json" : "--out") +
                     ": expected --with beside it, which is missing");
  }
}

int replay_study(const ReplayOptions& options) {
  const BuildingLine told;
  require_one_purpose(options);
#ifndef IMPETUS_WINDOW
  if (options.view) {
    throw InputError("--view: this build has no window");
  }
#endif
  if (options.truth) {  // what is refused leaves the file as it is
    StudyFile as_it_is = StudyFile::open_for_reading(options.study);
    while_reading(as_it_is, [&] { return chosen_attempts(as_it_is, options).size(); });
  }
  StudyFile study = options.truth ? StudyFile::open_for_writing(options.study, build_name())
                                  : StudyFile::open_for_reading(options.study);
  return while_reading(study, [&] {
    const std::vector<StoredAttempt> attempts = chosen_attempts(study, options);
#ifdef IMPETUS_WINDOW
    if (options.view) {
      return view_attempts(study, attempts, options.window_size);
    }
#endif
    if (!options.what_if.with.empty()) {
      return replay_with(study, attempts, options.what_if);
    }
    return options.truth ? fill_truth(study, attempts) : compare_all(study, attempts);
  });
}

}  // namespace

void add_replay(CLI::App& app, Command& chosen) {
  const auto [command, options] =
      add_command<ReplayOptions>(app, chosen, replay_study, "replay",
                                 "Simulate every recorded trial again and compare each step");
  command->add_option("study", options->study, "Study file")->required();
  command->add_option("--trial", options->trial,
                      "Only this trial (the column `trial` of the views)");
  command->add_option("--participant", options->participant, "Only this participant's trials");
  command->add_flag("--view", options->view, "Play the trials in a window");
  command->add_option("--window", options->window_size, "WIDTHxHEIGHT instead of fullscreen")
      ->needs("--view");
  command->add_flag("--truth", options->truth,
                    "Measure each collision's gap and hidden share and store them");
  command->add_option("--with", options->what_if.with, words_of_setting_keys())
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command->add_option("--out", options->what_if.csv_file,
                      "Of --with: write a CSV file, a row for each stimulus");
  command->add_option("--json", options->what_if.json_file,
                      "Of --with: write a JSON file, with every collision");
}

}  // namespace impetus::inline commands
