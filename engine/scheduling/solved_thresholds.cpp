// SPDX-License-Identifier: MIT
#include "engine/scheduling/solved_thresholds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace impetus::inline scheduling {
namespace {

/// Shares such as 0.1 + 0.2 + 0.7 may exceed 1 by rounding.
constexpr double kRounding = 1e-9;

/// The cut moved out of a run of equal measures.
std::size_t outside_of_run(const std::vector<double>& sorted, std::size_t cut) {
  if (cut == 0 || cut == sorted.size() || sorted[cut - 1] != sorted[cut]) {
    return cut;
  }
  std::size_t first = cut;
  while (first > 0 && sorted[first - 1] == sorted[cut]) {
    --first;
  }
  std::size_t end = cut;
  while (end < sorted.size() && sorted[end] == sorted[cut]) {
    ++end;
  }
  return cut - first <= end - cut ? first : end;
}

/// What the first `cut` of the measures, most urgent first, meet and the others do not.
double threshold_at(const std::vector<double>& sorted, std::size_t cut,
                    const PriorityMetric& metric) {
  if (cut == 0) {
    return std::nextafter(sorted.front(),
                          metric.priority(1.0) * std::numeric_limits<double>::infinity());
  }
  if (cut == sorted.size()) {
    return sorted.back();
  }
  // Half of each, for their sum could overflow; rounding may bring it onto the one beyond.
  const double middle = 0.5 * sorted[cut - 1] + 0.5 * sorted[cut];
  return metric.meets(sorted[cut], middle) ? sorted[cut - 1] : middle;
}

}  // namespace

std::string problem_of_shares(const std::vector<double>& shares) {
  double sum = 0.0;
  for (const double share : shares) {
    if (!(share >= 0.0 && share <= 1.0)) {
      return "expected pair shares in [0, 1], got " + std::to_string(share);
    }
    sum += share;
  }
  return sum <= 1.0 + kRounding
             ? ""
             : "expected pair shares of at most 1 together, got " + std::to_string(sum);
}

std::size_t cut_at(double sum_of_shares, std::size_t count) {
  const double wanted = std::floor(sum_of_shares * static_cast<double>(count) + 0.5);
  return std::min(count, static_cast<std::size_t>(wanted));
}

std::vector<std::size_t> cuts_for(const std::vector<double>& shares, std::size_t count) {
  std::vector<std::size_t> cuts;
  double sum = 0.0;
  for (const double share : shares) {
    sum += share;
    cuts.push_back(cut_at(sum, count));
  }
  return cuts;
}

std::vector<double> thresholds_for(const std::vector<double>& shares, std::vector<double> measures,
                                   const PriorityMetric& metric) {
  if (const std::string problem = problem_of_shares(shares); !problem.empty()) {
    throw std::invalid_argument("thresholds: " + problem);
  }
  if (measures.empty() || !std::all_of(measures.begin(), measures.end(),
                                       [](double measure) { return std::isfinite(measure); })) {
    throw std::invalid_argument("thresholds: expected finite measures of at least one pair, got " +
                                std::string(measures.empty() ? "none" : "one that is not finite"));
  }
  std::sort(measures.begin(), measures.end(),
            [&metric](double x, double y) { return metric.priority(x) > metric.priority(y); });
  std::vector<double> thresholds;
  for (const std::size_t cut : cuts_for(shares, measures.size())) {
    thresholds.push_back(threshold_at(measures, outside_of_run(measures, cut), metric));
  }
  return thresholds;
}

}  // namespace impetus::inline scheduling
