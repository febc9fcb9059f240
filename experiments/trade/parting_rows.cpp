// SPDX-License-Identifier: MIT
#include "experiments/trade/parting_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/trade/ratio_of_sums.hpp"

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
      row.statistic = statistic;
      row.n = estimate.n;
      row.value = estimate.value;
      row.low = estimate.low;
      row.high = estimate.high;
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
    add("together", "1", "mean", ratio_of_sums(shares, std::vector<double>(shares.size(), 1.0)));
  }
  return rows;
}

}  // namespace impetus::inline trade
