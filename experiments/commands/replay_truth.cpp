// SPDX-License-Identifier: MIT
#include "experiments/commands/replay_truth.hpp"

#include <unistd.h>

#include <cstdio>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/replayed_trial.hpp"
#include "experiments/session/collision_truth.hpp"
#include "experiments/store/truth_rows.hpp"

namespace impetus {
namespace {

/// The collision's truth from the states at its step.
CollisionTruth truth_of(const StoredCollision& collision, const StagedScene& scene,
                        const World& world) {
  const auto a = static_cast<std::size_t>(collision.bodies.a);
  const Viewer viewer = scene.viewer_at_time(static_cast<double>(collision.step) / scene.step_hz);
  const Pose& pose_a = world.states()[a].pose;
  if (is_wall(collision.bodies.b)) {
    return measure_wall_truth(scene.looks[a], pose_a, *world.settings().enclosure,
                              kEnclosure - collision.bodies.b, viewer);
  }
  const auto b = static_cast<std::size_t>(collision.bodies.b);
  return measure_truth(scene.looks[a], pose_a, scene.looks[b], world.states()[b].pose, viewer);
}

}  // namespace

int fill_truth(StudyFile& study, const std::vector<StoredAttempt>& attempts) {
  ReplayLibrary library(study);
  const bool terminal = isatty(STDERR_FILENO) != 0;
  int status = kDone;
  std::size_t measured = 0;
  for (std::size_t done = 0; done < attempts.size(); ++done) {
    const StoredAttempt& attempt = attempts[done];
    const StagedScene scene = library.stage(attempt);
    std::vector<std::string> names;
    for (const DrawnBody& look : scene.looks) {
      names.push_back(look.name);
    }
    std::vector<MeasuredCollision> truths;
    const std::vector<StoredCollision> collisions = load_collisions(study, attempt.id, names);
    const ReplayResult result =
        replay(scene, library.steps(attempt),
               [&](std::int64_t step, const World& world, const StepReport&) {
                 for (const StoredCollision& collision : collisions) {
                   if (collision.step == step) {
                     truths.push_back({collision.id, truth_of(collision, scene, world)});
                   }
                 }
               });
    if (result.divergence) {
      std::printf("trial %lld diverges at step %lld: its collisions are left without truth\n",
                  static_cast<long long>(attempt.trial_id),
                  static_cast<long long>(result.divergence->step));
      status = kFound;
      continue;
    }
    store_truths(study, truths);
    measured += truths.size();
    if (terminal) {
      std::fprintf(stderr, "\rtrial %zu of %zu", done + 1, attempts.size());
    }
  }
  if (terminal) {
    std::fprintf(stderr, "\n");
  }
  std::printf("%zu collisions measured in %zu trials\n", measured, attempts.size());
  return status;
}

}  // namespace impetus
