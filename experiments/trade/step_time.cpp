// SPDX-License-Identifier: MIT
#include "experiments/trade/step_time.hpp"

#include <cmath>

#include "experiments/run/scene_run.hpp"

namespace impetus::inline trade {

std::vector<double> step_times_ms(const StagedScene& scene, const Clock& clock, double most_s) {
  const auto steps = static_cast<std::int64_t>(std::ceil(scene.duration_s * scene.step_hz));
  const std::int64_t begin_ns = clock.now_ns();
  SceneRun run(scene);
  FixedWork meter(kUnlimitedTests);
  std::vector<double> times_ms;
  for (std::int64_t step = 0; step < steps; ++step) {
    const std::int64_t start_ns = clock.now_ns();
    const bool touches = !run.step({}, {}, meter).collisions.empty();
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
    row.statistic = each.name;
    row.n = found.n;
    row.value = found.value;
    row.low = found.low;
    row.high = found.high;
    row.by_clock = true;
  }
  return rows;
}

}  // namespace impetus::inline trade
