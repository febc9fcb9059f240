// SPDX-License-Identifier: MIT
#include "experiments/observers/imagining/noise_ladder.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/observers/side_by_side.hpp"

namespace impetus::inline observers {
namespace {

constexpr std::size_t kRungs = 11;
constexpr double kLeastDeg = 0.25;
constexpr double kRungsPerDoubling = 2.0;

/// Enough that what is left of chance in a share is small beside how people's answers differ; where
/// the first runs all end alike, they are.
constexpr std::int64_t kFirstRuns = 500;
constexpr std::int64_t kRunsARung = 3000;

/// The slope at a rung, from the rise before it and after it.
double slope_between(double before, double after) {
  return before * after > 0.0 ? 2.0 * before * after / (before + after) : 0.0;
}

}  // namespace

Percept shares_by_noise(
    const ImaginingParameters& own, std::uint64_t clip,
    const std::function<double(const Imagination& by, RandomStream& draws)>& share) {
  Percept shares(kRungs);
  do_side_by_side(shares.size(), [&](std::size_t rung) {
    Imagination by = own.imagination();
    by.in_pairs = true;
    by.heading_noise_deg = kLeastDeg * std::exp2(static_cast<double>(rung) / kRungsPerDoubling);
    RandomStream draws(clip, "fit/imagination");
    by.runs = kFirstRuns;
    const double first = share(by, draws);
    shares[rung] = first;
    if (first > 0.0 && first < 1.0) {
      by.runs = kRunsARung - kFirstRuns;
      const double part = static_cast<double>(kFirstRuns) / kRunsARung;
      shares[rung] = part * first + (1.0 - part) * share(by, draws);
    }
  });
  return shares;
}

/// Fritsch and Butland 1984: a cubic without a corner at a rung, where a fit would come to rest,
/// and without hills between two.
double share_at_noise(const Percept& shares, double heading_noise_deg) {
  const double last = static_cast<double>(shares.size() - 1);
  const double rung =
      std::min(kRungsPerDoubling * std::log2(std::max(heading_noise_deg / kLeastDeg, 1.0)), last);
  const auto below = std::min(static_cast<std::size_t>(rung), shares.size() - 2);
  const double part = rung - static_cast<double>(below);
  const double rise = shares[below + 1] - shares[below];
  const double before = below > 0 ? shares[below] - shares[below - 1] : rise;
  const double after = below + 2 < shares.size() ? shares[below + 2] - shares[below + 1] : rise;
  const double slope = slope_between(before, rise);
  const double slope_above = slope_between(rise, after);
  const double bend = slope + slope_above - 2.0 * rise;
  const double turn = 3.0 * rise - 2.0 * slope - slope_above;
  const double share = shares[below] + part * (slope + part * (turn + part * bend));
  return std::clamp(share, 0.0, 1.0);  // but for rounding it is
}

}  // namespace impetus::inline observers
