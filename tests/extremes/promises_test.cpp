// Every promise of `impetus extremes`, as quickly as it can be asked.
// SPDX-License-Identifier: MIT
#include <set>

#include "tests/extremes/case_tests.hpp"

namespace impetus {

void PrintTo(const ExtremeCase& extreme, std::ostream* out) { *out << extreme.name; }

namespace {

class Promises : public testing::TestWithParam<ExtremeCase> {};

TEST_P(Promises, AreKept) { expect_kept(GetParam(), Length::kQuick); }

INSTANTIATE_TEST_SUITE_P(AtTheExtremes, Promises, testing::ValuesIn(extreme_cases()), test_name_of);

TEST(ExtremeCases, HaveNamesOfTheirOwnAndAFigureForEachPromise) {
  std::set<std::string> names;
  for (const ExtremeCase& extreme : extreme_cases()) {
    EXPECT_TRUE(names.insert(extreme.name).second) << extreme.name;
    EXPECT_NE(extreme.scenes == nullptr, extreme.ask == nullptr) << extreme.name;
    for (const ExtremePromise& promise : extreme.promises) {
      EXPECT_NE(promise.measure == nullptr, extreme.ask == nullptr) << extreme.name;
    }
  }
}

TEST(ExtremeCases, APromiseThatIsNotKeptOrIsNoNumberIsTold) {
  ExtremeCase broken{"none", "broken", {{"less than", 1.0}, {"a number", 1.0}, {"kept", 1.0}}};
  broken.ask = [](Length, const Progress&) {
    return std::vector<double>{1.5, std::numeric_limits<double>::quiet_NaN(), 1.0};
  };
  const std::vector<ExtremeResult> results = run_case(broken, Length::kQuick);
  EXPECT_FALSE(results[0].kept);
  EXPECT_FALSE(results[1].kept);
  EXPECT_TRUE(results[2].kept);
}

}  // namespace
}  // namespace impetus
