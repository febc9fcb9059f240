// SPDX-License-Identifier: MIT
#include "experiments/trade/scene_rows.hpp"

#include <algorithm>

#include "experiments/trade/estimate.hpp"

namespace impetus::inline trade {
namespace {

TradeRow row_of(const std::string& title, const char* measure, const char* statistic,
                const Estimate& estimate) {
  TradeRow row;
  row.part = "scene";
  row.subject = title;
  row.measure = measure;
  row.unit = "1";
  row.statistic = statistic;
  row.n = estimate.n;
  row.value = estimate.value;
  row.low = estimate.low;
  row.high = estimate.high;
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

}  // namespace impetus::inline trade
