// Every promise of `impetus extremes --long`: 1e7 steps of one body, 1e6 of a crowd.
// SPDX-License-Identifier: MIT
#include "tests/extremes/case_tests.hpp"

namespace impetus {

void PrintTo(const ExtremeCase& extreme, std::ostream* out) { *out << extreme.name; }

namespace {

class LongPromises : public testing::TestWithParam<ExtremeCase> {};

TEST_P(LongPromises, AreKept) { expect_kept(GetParam(), Length::kLong); }

INSTANTIATE_TEST_SUITE_P(AtTheExtremes, LongPromises, testing::ValuesIn(extreme_cases()),
                         test_name_of);

}  // namespace
}  // namespace impetus
