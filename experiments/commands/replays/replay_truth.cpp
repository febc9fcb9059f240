// SPDX-License-Identifier: MIT
#include "experiments/commands/replays/replay_truth.hpp"

#include <unistd.h>

#include <cstdio>
#include <optional>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/replays/replayed_trial.hpp"
#include "experiments/run/collision_truth.hpp"
#include "experiments/store/study_reader.hpp"

namespace impetus::inline commands {
namespace {

/// The truth of an interval's collisions; tells and returns nothing when it diverges.
std::optional<std::vector<MeasuredCollision>> measured(StudyFile& study, ReplayLibrary& library,
                                                       const StoredAttempt& attempt,
                                                       std::int64_t interval) {
  const StagedScene scene = library.stage(attempt, interval);
  std::vector<std::string> names;
  for (const DrawnBody& look : scene.looks) {
    names.push_back(look.name);
  }
  std::vector<MeasuredCollision> truths;
  const std::vector<StoredCollision> collisions =
      load_collisions(study, attempt.id, names, interval);
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

}  // namespace

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

}  // namespace impetus::inline commands
