// Medians, other quantiles, shares and ratios with their 95 % intervals, exact and without
// resampling.
//
//   quantile p of n     the ordered values l and u between which it lies: of n values the number
//                       below it is binomial (n, p), whatever their distribution
//   share k of n        the shares under which k or more, k or fewer, are not too rare
//
// (order statistics: David and Nagaraja 2003, sec. 7.1; shares: Clopper and Pearson 1934)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace impetus::inline trade {

/// A number measured `n` times with the ends of its 95 % interval; NaN where there is none.
struct Estimate {
  std::int64_t n{0};
  double value{std::numeric_limits<double>::quiet_NaN()};
  double low{std::numeric_limits<double>::quiet_NaN()};
  double high{std::numeric_limits<double>::quiet_NaN()};
};

/// The least of `values` below or at which a share `p` in (0, 1) of them lies. An end of the
/// interval that so few values cannot tell is NaN; so is everything of no values.
Estimate quantile_of(std::vector<double> values, double p);

/// The mean, without an interval.
Estimate mean_of(const std::vector<double>& values);

/// `k` of `n`, with 0 ≤ k ≤ n; NaN of none.
Estimate share_of(std::int64_t k, std::int64_t n);

/// One sum over another, of numbers that were measured together, with its interval.
///
///   value ± t · s      s² = (n − 1)/n · Σ (r_i − r̄)²,  r_i the ratio without the i-th of n
///
/// (the jackknife: Quenouille 1956, Tukey 1958; t of Student with n − 1 degrees of freedom)
////
/// Σ over / Σ under, with its 95 % interval when there are at least four. NaN where the lower sum
/// is zero. Precondition: as many of each.
Estimate ratio_of_sums(const std::vector<double>& over, const std::vector<double>& under);

/// The mean, with that interval.
Estimate mean_over(const std::vector<double>& values);

}  // namespace impetus::inline trade
