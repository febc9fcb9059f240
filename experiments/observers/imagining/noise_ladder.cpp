// SPDX-License-Identifier: MIT
#include "experiments/observers/imagining/noise_ladder.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline observers {
namespace {

constexpr int kRungs = 11;
constexpr double kLeastDeg = 0.25;
constexpr double kRungsPerDoubling = 2.0;

/// Enough that what is left of chance in a share is small beside how people's answers differ.
constexpr std::int64_t kRunsARung = 1000;

}  // namespace

Percept shares_by_noise(
    const ImaginingParameters& own,
    const std::function<double(const Imagination& by, RandomStream& draws)>& share) {
  Percept shares;
  for (int rung = 0; rung < kRungs; ++rung) {
    Imagination by = own.imagination();
    by.runs = kRunsARung;
    by.heading_noise_deg = kLeastDeg * std::exp2(rung / kRungsPerDoubling);
    RandomStream draws(1, "fit/imagination");
    shares.push_back(share(by, draws));
  }
  return shares;
}

double share_at_noise(const Percept& shares, double heading_noise_deg) {
  const double rung = kRungsPerDoubling * std::log2(std::max(heading_noise_deg / kLeastDeg, 1.0));
  const auto below = std::min(static_cast<std::size_t>(rung), shares.size() - 1);
  const std::size_t above = std::min(below + 1, shares.size() - 1);
  const double part = std::min(rung - static_cast<double>(below), 1.0);
  return shares[below] + part * (shares[above] - shares[below]);
}

}  // namespace impetus::inline observers
