// What can be chosen, what it costs and errs, and what to choose within a budget.
//
//   of the options that are fast enough: the least  normal error x gap
//
// An option's normal error is the median, its gap what 95 % of gaps are below, both against the
// exact meshes. The product has no unit to agree on: half the one is worth twice the other. Errors
// too small to matter count as kLeastNormal_deg and kLeastGap_arcmin; of equals, the
// quickest, and of those about as quick the first.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/trade/estimate.hpp"
#include "experiments/trade/impacts/impact_measures.hpp"

namespace impetus::inline trade {

inline constexpr double kLeastNormal_deg = 0.1;
inline constexpr double kLeastGap_arcmin = 0.1;

/// One thing to choose: a kind of tree to a level with a reduction, its cost and its errors.
struct TradeOption {
  TreeKind kind{TreeKind::kOctree};
  int level{0};
  std::string reduction;
  double mean_us{0.0};  ///< a pair; by the clock
  double p99_us{0.0};
  Estimate normal_deg;  ///< median
  Estimate gap_arcmin;  ///< 95 % are below
  Estimate gap;         ///< the same as a share of the size
  Estimate linear;      ///< median
  Estimate angular;     ///< median; of nothing where nothing turns

  /// What a step of so many pairs takes for them: all at the mean, or one at its dearest.
  [[nodiscard]] double step_ms(double pairs) const;
  [[nodiscard]] double error() const;
};

/// One for each kind, level and reduction, in the order measured.
std::vector<TradeOption> trade_options(const ImpactMeasures& measures);

/// The options within `budget_ms` a step of so many pairs, the best first.
std::vector<TradeOption> ranked(const std::vector<TradeOption>& options, double pairs,
                                double budget_ms);

}  // namespace impetus::inline trade
