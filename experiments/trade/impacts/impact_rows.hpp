// What was measured of impacts as rows: costs and errors of every kind, level and reduction.
//
//   measure             unit     statistic            against           of
//   tests, overlaps     1        median, p99                            kind, level
//   descent_time        us       mean, median, p99    -                 kind, level: tests alone
//   memory              B        total                                  kind, level
//   missed              1        share                                  kind, level: 0 is expected
//   false_collisions    1        share of collisions  exact             kind, level
//   gap, gap_seen       1, arcmin  median, p95        exact             kind, level
//   contacts            1        median               -                 kind, level, reduction
//   pair_time           us       mean, median, p99    -                 kind, level, reduction
//   normal_error        deg      median, p95          exact, finest     kind, level, reduction
//   point_error         1        median, p95          exact, finest     kind, level, reduction
//   linear_error, angular_error  1  median, p95       exact, finest     kind, level, reduction
//
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/trade/impacts/impact_measures.hpp"
#include "experiments/trade/trade_row.hpp"

namespace impetus::inline trade {

std::vector<TradeRow> impact_rows(const ImpactMeasures& measures);

/// All of them as if they were one subject, called `name`. Precondition: the same kinds, levels and
/// reductions; levels that only some have come from those alone.
ImpactMeasures pooled(const std::vector<ImpactMeasures>& measures, const std::string& name);

}  // namespace impetus::inline trade
