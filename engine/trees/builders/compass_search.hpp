// A search for better parameters that asks for nothing but scores: a step along each parameter
// either way, kept when it helps; half the step when none does. (Hooke and Jeeves 1961)
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace impetus::inline trees {

/// Parameters about zero with no greater a score than zero's own, after `rounds` of at most 2 N
/// scores each. `score(parameters, enough)` may return anything above `enough` once it is known to
/// exceed it.
template <std::size_t N, typename Score>
std::array<double, N> compass_search(std::array<double, N> steps, int rounds, const Score& score) {
  std::array<double, N> best{};
  double least = score(best, 1e300);
  for (int round = 0; round < rounds; ++round) {
    bool helped = false;
    for (std::size_t i = 0; i < N; ++i) {
      for (const double sign : {1.0, -1.0}) {
        std::array<double, N> tried = best;
        tried[i] += sign * steps[i];
        const double got = score(tried, least);
        if (got < least) {
          least = got;
          best = tried;
          helped = true;
          break;
        }
      }
    }
    if (!helped) {
      for (double& step : steps) {
        step *= 0.5;
      }
    }
  }
  return best;
}

}  // namespace impetus::inline trees
