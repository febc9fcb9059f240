// SPDX-License-Identifier: MIT
#include "experiments/trade/scene_demand.hpp"

#include <algorithm>
#include <cmath>

#include "engine/numerics/at.hpp"
#include "experiments/run/scene_run.hpp"
#include "experiments/trade/estimate.hpp"

namespace impetus::inline trade {

std::vector<double> step_times_ms(const StagedScene& scene, const Clock& clock, double most_s) {
  const auto steps = static_cast<std::int64_t>(std::ceil(scene.duration_s * scene.step_hz));
  const std::int64_t begin_ns = clock.now_ns();
  SceneRun run(scene);
  std::vector<double> times_ms;
  for (std::int64_t step = 0; step < steps; ++step) {
    const std::int64_t start_ns = clock.now_ns();
    const bool touches = !run.step_whole().collisions.empty();
    const std::int64_t end_ns = clock.now_ns();
    if (touches) {
      times_ms.push_back(1e-6 * static_cast<double>(end_ns - start_ns));
    }
    if (1e-9 * static_cast<double>(end_ns - begin_ns) > most_s) {
      break;
    }
  }
  return times_ms;
}

std::vector<TradeRow> run_rows(const std::string& title, const TradeOption& option,
                               const std::vector<double>& times_ms) {
  /// A quantile of the steps' times, by name.
  struct Statistic {
    const char* name;
    double p;
  };
  std::vector<TradeRow> rows;
  for (const Statistic& each :
       {Statistic{"median", 0.5}, Statistic{"p95", 0.95}, Statistic{"p99", 0.99}}) {
    const Estimate found = quantile_of(times_ms, each.p);
    TradeRow& row = rows.emplace_back();
    row.part = "run";
    row.subject = title;
    row.kind = name_of(option.kind);
    row.level = option.level;
    row.reduction = option.reduction;
    row.measure = "step_time";
    row.unit = "ms";
    row.set(each.name, found);
    row.by_clock = true;
  }
  return rows;
}

namespace {

TradeRow row_of(const std::string& title, const char* measure, const char* statistic,
                const Estimate& estimate) {
  TradeRow row;
  row.part = "scene";
  row.subject = title;
  row.measure = measure;
  row.unit = "1";
  row.set(statistic, estimate);
  return row;
}

Estimate count_of(std::int64_t count, std::int64_t steps) {
  Estimate estimate;
  estimate.n = steps;
  estimate.value = static_cast<double>(count);
  return estimate;
}

}  // namespace

double pairs_per_step(const SceneDemand& demand) {
  return demand.pairs.empty() ? 1.0 : std::max(1.0, quantile_of(demand.pairs, 0.95).value);
}

std::vector<TradeRow> scene_rows(const SceneDemand& demand, const std::string& title) {
  const auto meetings = static_cast<std::int64_t>(demand.meetings.size());
  return {row_of(title, "pairs_refined", "median", quantile_of(demand.pairs, 0.5)),
          row_of(title, "pairs_refined", "p95", quantile_of(demand.pairs, 0.95)),
          row_of(title, "pairs_touching", "most", count_of(demand.touching_most, demand.steps)),
          row_of(title, "meetings", "total", count_of(meetings, demand.steps))};
}

namespace {

constexpr std::int64_t kMostSteps = 2'400;
constexpr std::int64_t kMostProbes = 400;

std::int64_t pairs_in(const StepReport& report) {
  return std::count_if(report.collisions.begin(), report.collisions.end(),
                       [](const CollisionReport& each) { return !is_wall(each.bodies.b); });
}

/// How many pairs the next step begins to refine.
std::int64_t pairs_to_refine(SceneRun probe) {
  Schedule coarsest;
  coarsest.lists = {{1.0, 0, 0}};
  probe.world().set_schedule(coarsest);
  return pairs_in(probe.step_whole());
}

MeetingMotion motion_of(const std::vector<BodyModel>& models, const std::vector<BodyState>& states,
                        const BodyPair& bodies) {
  const std::size_t a = at(bodies.a);
  const std::size_t b = at(bodies.b);
  return {(velocity(models[a], states[a]) - velocity(models[b], states[b])).norm(),
          angular_velocity(models[a], states[a]).norm(),
          angular_velocity(models[b], states[b]).norm()};
}

void note_meetings(const StepReport& report, const SceneRun& run, SceneDemand& demand) {
  for (const CollisionReport& each : report.collisions) {
    if (each.began && !is_wall(each.bodies.b)) {
      const MeetingMotion motion = motion_of(run.world().models(), run.before(), each.bodies);
      if (motion.approach_m_s > 0.0) {
        demand.meetings.push_back({at(each.bodies.a), at(each.bodies.b), motion});
      }
    }
  }
}

}  // namespace

SceneDemand demand_of(const StagedScene& scene, const Progress& progress) {
  SceneDemand demand;
  demand.steps =
      std::min(kMostSteps, static_cast<std::int64_t>(std::ceil(scene.duration_s * scene.step_hz)));
  const std::int64_t stride = (demand.steps + kMostProbes - 1) / kMostProbes;
  SceneRun run(scene);
  run.world().set_schedule({});
  for (std::int64_t step = 0; step < demand.steps; ++step) {
    if (step % stride == 0) {
      const std::int64_t pairs = pairs_to_refine(run);
      if (pairs > 0) {
        demand.pairs.push_back(static_cast<double>(pairs));
      }
    }
    const StepReport& report = run.step_whole();
    note_meetings(report, run, demand);
    demand.touching_most = std::max(demand.touching_most, pairs_in(report));
    if (progress) {
      progress(static_cast<double>(step + 1) / static_cast<double>(demand.steps));
    }
  }
  return demand;
}

}  // namespace impetus::inline trade
