// SPDX-License-Identifier: MIT
#include "experiments/trade/parting.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/run/scene_run.hpp"
#include "experiments/trade/crowds/work_beyond_floor.hpp"

namespace impetus::inline trade {
namespace {

using Poses = std::vector<Pose>;

std::int64_t steps_of(const StagedScene& scene, double longest_s) {
  return std::llround(std::floor(std::min(scene.duration_s, longest_s) * scene.step_hz));
}

/// A trial of a scene under one schedule, whose viewer looks at the screen's centre.
class Trial {
 public:
  Trial(const StagedScene& scene, Schedule schedule, std::int64_t budget, std::uint64_t seed)
      : run_(scene, seed), meter_(budget) {
    run_.world().set_schedule(std::move(schedule));
    run_.world().set_costs(costs_of_tests(run_.world().settings().costs));
  }

  const std::vector<BodyState>& step() {
    constexpr ScreenPoint kCentre{};
    meter_.start_step();
    static_cast<void>(run_.step(kCentre, run_.next_region(kCentre), meter_));
    return run_.world().states();
  }

  [[nodiscard]] const Viewer& viewer() const { return run_.input().viewer; }

 private:
  SceneRun run_;
  WorkBeyondFloor meter_;
};

/// Poses of all bodies after each step, at the finest level.
std::vector<Poses> reference_course(const StagedScene& scene, double longest_s) {
  Trial trial(scene, {}, kUnlimitedTests, 0);
  std::vector<Poses> course;
  for (std::int64_t step = 1; step <= steps_of(scene, longest_s); ++step) {
    Poses poses;
    for (const BodyState& state : trial.step()) {
      poses.push_back(state.pose);
    }
    course.push_back(std::move(poses));
  }
  return course;
}

PartedTrial parted(const StagedScene& scene, const std::vector<Poses>& reference, Trial trial,
                   const PartingThresholds& thresholds) {
  const std::size_t bodies = scene.world.models().size();
  std::vector<bool> has_parted(bodies, false);
  std::size_t count = 0;
  PartedTrial result;
  for (std::size_t step = 0; step < reference.size() && count < bodies; ++step) {
    const std::vector<BodyState>& states = trial.step();
    for (std::size_t body = 0; body < bodies; ++body) {
      if (!has_parted[body] &&
          seen_apart(reference[step][body], states[body].pose, scene.looks[body].mesh != nullptr,
                     trial.viewer(), thresholds)) {
        has_parted[body] = true;
        ++count;
      }
    }
    const double time_s = static_cast<double>(step + 1) / scene.step_hz;
    result.first_s = count > 0 ? std::min(result.first_s, time_s) : result.first_s;
    result.half_s = 2 * count >= bodies ? std::min(result.half_s, time_s) : result.half_s;
  }
  result.share_together = 1.0 - static_cast<double>(count) / static_cast<double>(bodies);
  return result;
}

Trial tried(const StagedScene& scene, const PartingSetting& setting, std::uint64_t seed) {
  Schedule schedule = schedule_of(setting.order, scene, seed);
  if (setting.order.scheduler != kOwnScheduler) {
    schedule.lists.front().greatest_level = setting.level;
  }
  return {scene, std::move(schedule), setting.budget.value_or(kUnlimitedTests), seed};
}

}  // namespace

std::vector<PartedTrials> partings(const StartOf& start, const PartingRequest& request,
                                   const Progress& progress) {
  std::vector<PartedTrials> all;
  for (const PartingSetting& setting : request.settings) {
    all.push_back({setting, {}});
  }
  const auto count = static_cast<double>(all.size()) * static_cast<double>(request.starts);
  std::int64_t done = 0;
  for (std::int64_t number = 1; number <= request.starts; ++number) {
    std::optional<StagedScene> scene;
    std::vector<Poses> reference;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const PartingSetting& setting = all[i].setting;
      if (!scene || setting.kind != all[i - 1].setting.kind) {
        scene.emplace(start(setting.kind, number));
        reference = reference_course(*scene, request.longest_s);
      }
      all[i].trials.push_back(
          parted(*scene, reference, tried(*scene, setting, request.seed), request.thresholds));
      if (progress) {
        progress(static_cast<double>(++done) / count);
      }
    }
  }
  return all;
}

}  // namespace impetus::inline trade
