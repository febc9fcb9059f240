// Student's t beside the tables of R's qt(0.975, n).
// SPDX-License-Identifier: MIT
#include "experiments/tables/student_t.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace impetus::student_t_test {

TEST(StudentT, IsWithinAThirdOfAPerCentAlsoOfTwoNumbers) {
  const std::vector<std::pair<double, double>> known{{1, 12.706205}, {2, 4.302653},   {3, 3.182446},
                                                     {4, 2.776445},  {5, 2.570582},   {9, 2.262157},
                                                     {29, 2.045230}, {1000, 1.962339}};
  for (const auto& [freedom, quantile] : known) {
    EXPECT_NEAR(student_t(freedom) / quantile, 1.0, 3e-3) << freedom;
  }
}

}  // namespace impetus::student_t_test
