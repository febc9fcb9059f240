// SPDX-License-Identifier: MIT
#include "experiments/trade/trade_option.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

namespace impetus::inline trade {
namespace {

/// A time in steps of a quarter: what differs by less is chance, and the order measured decides.
double steps_of(double mean_us) { return std::round(std::log(mean_us) / std::log(1.25)); }

}  // namespace

double TradeOption::step_ms(double pairs) const { return 1e-3 * std::max(pairs * mean_us, p99_us); }

double TradeOption::error() const {
  return std::max(kLeastNormal_deg, normal_deg.value) *
         std::max(kLeastGap_arcmin, gap_arcmin.value);
}

std::vector<TradeOption> trade_options(const ImpactMeasures& measures) {
  std::vector<TradeOption> options;
  for (const ContactMeasures& contacts : measures.contacts) {
    const auto bounds = std::find_if(
        measures.bounds.begin(), measures.bounds.end(), [&](const BoundsMeasures& each) {
          return each.kind == contacts.kind && each.level == contacts.level;
        });
    TradeOption& option = options.emplace_back();
    option.kind = contacts.kind;
    option.level = contacts.level;
    option.reduction = contacts.reduction;
    option.mean_us = mean_of(contacts.pair_us).value;
    option.p99_us = quantile_of(contacts.pair_us, 0.99).value;
    option.normal_deg = quantile_of(contacts.exact.normal_deg, 0.5);
    option.gap_arcmin = quantile_of(bounds->gaps_arcmin, 0.95);
    option.gap = quantile_of(bounds->gaps, 0.95);
    option.linear = quantile_of(contacts.exact.linear, 0.5);
    if (measures.spins) {
      option.angular = quantile_of(contacts.exact.angular, 0.5);
    }
  }
  return options;
}

std::vector<TradeOption> ranked(const std::vector<TradeOption>& options, double pairs,
                                double budget_ms) {
  std::vector<TradeOption> within;
  std::copy_if(options.begin(), options.end(), std::back_inserter(within),
               [&](const TradeOption& option) { return option.step_ms(pairs) <= budget_ms; });
  std::stable_sort(within.begin(), within.end(), [](const TradeOption& x, const TradeOption& y) {
    return std::make_tuple(x.error(), steps_of(x.mean_us)) <
           std::make_tuple(y.error(), steps_of(y.mean_us));
  });
  return within;
}

}  // namespace impetus::inline trade
