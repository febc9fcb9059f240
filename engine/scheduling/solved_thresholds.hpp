// Thresholds solved for a share of the pairs.
//
//   measures, most urgent first   | list 0 | list 1 |    ...    | last list |
//   cut where the shares say      ^        ^        ^
//
// Equal measures are never parted: a cut moves to the nearer end of a run of them, towards the
// higher priority when both are as near.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/scheduling/priority.hpp"

namespace impetus::inline scheduling {

/// What is wrong with the shares of all lists but the last, which must lie in [0, 1] and add up to
/// at most 1, as "expected ..., got ..."; empty when nothing is.
std::string problem_of_shares(const std::vector<double>& shares);

/// How many of `count` pairs are in lists whose shares add up to `sum_of_shares`, rounded to the
/// nearest.
std::size_t cut_at(double sum_of_shares, std::size_t count);

/// The same for each of the shares and those before it.
std::vector<std::size_t> cuts_for(const std::vector<double>& shares, std::size_t count);

/// The thresholds, one for each share, by which `metric` parts pairs of such measures into lists
/// of those shares: of a pilot's pairs, for a protocol to fix. Throws std::invalid_argument when
/// the shares are wrong or the measures are none or not finite.
std::vector<double> thresholds_for(const std::vector<double>& shares, std::vector<double> measures,
                                   const PriorityMetric& metric);

}  // namespace impetus::inline scheduling
