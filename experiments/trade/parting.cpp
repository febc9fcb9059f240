// SPDX-License-Identifier: MIT
#include "experiments/trade/parting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/run/scene_run.hpp"
#include "experiments/trade/crowds/trajectory.hpp"
#include "experiments/trade/crowds/work_beyond_floor.hpp"
#include "experiments/trade/estimate.hpp"

namespace impetus::inline trade {
namespace {

/// What lies beyond the trial's end is not known.
double known(double time_s) {
  return std::isfinite(time_s) ? time_s : std::numeric_limits<double>::quiet_NaN();
}

Estimate median_of(const std::vector<PartedTrial>& trials, double PartedTrial::*time_s) {
  std::vector<double> times;
  times.reserve(trials.size());
  for (const PartedTrial& trial : trials) {
    times.push_back(trial.*time_s);
  }
  const Estimate median = quantile_of(times, 0.5);
  return {median.n, known(median.value), known(median.low), known(median.high)};
}

TradeRow row_of(const PartingSetting& setting, const std::string& subject) {
  TradeRow row;
  row.part = "parting";
  row.subject = subject;
  row.kind = setting.kind;
  if (setting.level != kUnlimitedLevel) {
    row.level = setting.level;
  }
  row.scheduler = setting.order.scheduler;
  row.traversal = setting.order.traversal;
  row.budget = setting.budget;
  row.reference = "finest";
  return row;
}

}  // namespace

std::vector<TradeRow> parting_rows(const std::vector<PartedTrials>& partings,
                                   const std::string& subject) {
  std::vector<TradeRow> rows;
  for (const auto& [setting, trials] : partings) {
    const auto add = [&, &of_setting = setting](const char* measure, const char* unit,
                                                const char* statistic, const Estimate& estimate) {
      TradeRow row = row_of(of_setting, subject);
      row.measure = measure;
      row.unit = unit;
      row.set(statistic, estimate);
      rows.push_back(std::move(row));
    };
    add("first_parting", "s", "median", median_of(trials, &PartedTrial::first_s));
    add("half_parted", "s", "median", median_of(trials, &PartedTrial::half_s));
    const auto together = std::count_if(trials.begin(), trials.end(), [](const PartedTrial& trial) {
      return !std::isfinite(trial.first_s);
    });
    add("not_parted", "1", "share", share_of(together, static_cast<std::int64_t>(trials.size())));
    std::vector<double> shares;
    shares.reserve(trials.size());
    for (const PartedTrial& trial : trials) {
      shares.push_back(trial.share_together);
    }
    add("together", "1", "mean", mean_over(shares));
  }
  return rows;
}

namespace {

using Poses = std::vector<Pose>;

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
  for (std::int64_t step = 1; step <= count_steps(scene, longest_s); ++step) {
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
  for (std::int64_t start_place = 0; start_place < request.starts; ++start_place) {
    const std::int64_t number = request.first_start + start_place;
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
