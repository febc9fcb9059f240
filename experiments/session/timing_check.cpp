// SPDX-License-Identifier: MIT
#include "experiments/session/timing_check.hpp"

#include <cmath>

#include "experiments/tables/number_text.hpp"

namespace impetus::inline session {
namespace {

constexpr std::int64_t kFewestValid = 50;
constexpr double kLargestStandardErrorNs = 200e3;
constexpr double kLargestDisagreement = 0.01;

std::vector<double> valid_intervals(const std::vector<std::int64_t>& flipped_ns,
                                    double nominal_ns) {
  std::vector<double> valid;
  for (std::size_t i = 1; i < flipped_ns.size(); ++i) {
    const auto interval = static_cast<double>(flipped_ns[i] - flipped_ns[i - 1]);
    const bool plausible = interval >= 4e6 && interval <= 40e6;
    if (plausible && std::abs(interval - nominal_ns) <= 0.2 * nominal_ns) {
      valid.push_back(interval);
    }
  }
  return valid;
}

std::string verdict_of(const SyncTest& test, double nominal_ns) {
  if (test.valid_flips < kFewestValid) {
    return printed(
        "flips do not follow the display's refresh: only %lld intervals were within 20 %% "
        "of %.2f ms, %lld are needed",
        static_cast<long long>(test.valid_flips), nominal_ns / 1e6,
        static_cast<long long>(kFewestValid));
  }
  return printed("%lld valid flips, interval %.3f ms (nominal %.3f ms), standard deviation %.3f ms",
                 static_cast<long long>(test.valid_flips), test.mean_interval_ns / 1e6,
                 nominal_ns / 1e6, test.sd_interval_ns / 1e6);
}

}  // namespace

SyncTest judge_flips(const std::vector<std::int64_t>& flipped_ns, double nominal_hz) {
  const double nominal_ns = 1e9 / nominal_hz;
  const std::vector<double> intervals = valid_intervals(flipped_ns, nominal_ns);
  SyncTest test;
  test.tries = 1;
  test.valid_flips = static_cast<std::int64_t>(intervals.size());
  const auto count = static_cast<double>(intervals.size());
  for (const double interval : intervals) {
    test.mean_interval_ns += interval / count;
  }
  double squares = 0.0;
  for (const double interval : intervals) {
    squares += (interval - test.mean_interval_ns) * (interval - test.mean_interval_ns);
  }
  test.sd_interval_ns = count > 1.0 ? std::sqrt(squares / (count - 1.0)) : 0.0;
  test.passed = test.valid_flips >= kFewestValid &&
                test.sd_interval_ns / std::sqrt(count) < kLargestStandardErrorNs &&
                std::abs(test.mean_interval_ns - nominal_ns) <= kLargestDisagreement * nominal_ns;
  test.verdict = verdict_of(test, nominal_ns);
  return test;
}

SyncTest run_sync_test(const FlipRun& flips, double nominal_hz) {
  constexpr int kTries = 3;
  constexpr int kFlipsPerTry = 120;
  SyncTest test;
  for (int attempt = 1; attempt <= kTries && !test.passed; ++attempt) {
    test = judge_flips(flips(kFlipsPerTry), nominal_hz);
    test.tries = attempt;
  }
  return test;
}

}  // namespace impetus::inline session
