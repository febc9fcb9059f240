// 200 simulated studies of 20 people: how often a 95 % interval holds what was planted.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <map>

#include "experiments/fitting/fit.hpp"
#include "tests/experiments/fitting/answering_group.hpp"

namespace impetus::fit_coverage_slow_test {

// Of 200 intervals that hold it with a probability of .95, 180 to 198 do in 99.6 % of cases.
TEST(FitCoverage, IntervalsOfThresholdWidthAndSpreadHoldWhatWasPlanted) {
  constexpr int kStudies = 200;
  const std::map<std::string, double> planted{
      {"threshold_mean_ms", 110.0}, {"threshold_width_ms", 45.0}, {"threshold_sd_ms", 30.0}};
  const ObserverFile file = shipped_observer("causality-thresholds");
  std::map<std::string, int> within;
  for (int study = 1; study <= kStudies; ++study) {
    const auto people = answering_group(file, delays_study(8), 20, /*seed=*/1000 + study);
    FitWish wish;
    wish.starts = 1;
    for (const auto& [name, value] : planted) {
      wish.only.push_back(name);
    }
    const ObserverFit fit = fit_observer(*file.kind, *file.parameters, people, wish);
    for (const auto& [name, value] : planted) {
      const FittedParameter* one = fit.find(name);
      ASSERT_NE(one, nullptr) << name;
      within[name] += one->is_fitted() && one->low <= value && value <= one->high ? 1 : 0;
    }
  }
  for (const auto& [name, value] : planted) {
    RecordProperty(name, within[name]);
    EXPECT_GE(within[name], 180) << name;
    EXPECT_LE(within[name], 198) << name;
  }
}

}  // namespace impetus::fit_coverage_slow_test
