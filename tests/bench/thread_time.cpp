// SPDX-License-Identifier: MIT
#include "tests/bench/thread_time.hpp"

#include <time.h>

#include <algorithm>
#include <numeric>

namespace impetus {

std::int64_t thread_cpu_ns() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

double clock_cost_ns() {
  constexpr int kLooks = 2'000;
  std::vector<double> costs;
  std::int64_t before_ns = thread_cpu_ns();
  for (int look = 0; look < kLooks; ++look) {
    const std::int64_t now_ns = thread_cpu_ns();
    costs.push_back(static_cast<double>(now_ns - before_ns));
    before_ns = now_ns;
  }
  return spread_of(std::move(costs)).median;
}

Spread spread_of(std::vector<double> samples) {
  if (samples.empty()) {
    return {};
  }
  std::sort(samples.begin(), samples.end());
  const auto at_share = [&](double share) {
    return samples[static_cast<std::size_t>(share * static_cast<double>(samples.size() - 1))];
  };
  const double sum = std::accumulate(samples.begin(), samples.end(), 0.0);
  return {at_share(0.5), sum / static_cast<double>(samples.size()), at_share(0.99), samples.back()};
}

}  // namespace impetus
