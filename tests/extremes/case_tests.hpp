// A test for each case at the extremes.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "experiments/extremes/extreme_cases.hpp"

namespace impetus {

inline std::string test_name_of(const testing::TestParamInfo<ExtremeCase>& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

inline void expect_kept(const ExtremeCase& extreme, Length length) {
  const std::vector<ExtremeResult> results = run_case(extreme, length);
  for (std::size_t i = 0; i < results.size(); ++i) {
    EXPECT_TRUE(results[i].kept) << extreme.promises[i].sentence << " "
                                 << extreme.promises[i].at_most << ": " << results[i].measured
                                 << " at " << results[i].worst_at;
  }
}

}  // namespace impetus
