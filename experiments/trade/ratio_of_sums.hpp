// One sum over another, of numbers that were measured together, with its interval.
//
//   value ± t · s      s² = (n − 1)/n · Σ (r_i − r̄)²,  r_i the ratio without the i-th of n
//
// (the jackknife: Quenouille 1956, Tukey 1958; t of Student with n − 1 degrees of freedom)
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/trade/estimate.hpp"

namespace impetus::inline trade {

/// Σ over / Σ under, with its 95 % interval when there are at least four. NaN where the lower sum
/// is zero. Precondition: as many of each.
Estimate ratio_of_sums(const std::vector<double>& over, const std::vector<double>& under);

}  // namespace impetus::inline trade
