// Exponential, logarithm and normal distribution: as exact as the C library's, without it.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/numerics/random_stream.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::elementary_functions_test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// |value / exact − 1|, in long double's precision.
double relative_error(double value, long double exact) {
  return static_cast<double>(std::fabs(static_cast<long double>(value) / exact - 1.0L));
}

TEST(Exponential, AgreesWithLongDoubleTo1e15) {
  RandomStream random(3, "exponential");
  for (int trial = 0; trial < 100'000; ++trial) {
    const double x = uniform_in(random, -700.0, 700.0);
    ASSERT_LT(relative_error(exp_of(x), std::exp(static_cast<long double>(x))), 1e-15) << x;
    const double small = x * 1e-5;
    ASSERT_LT(relative_error(exp_of(small), std::exp(static_cast<long double>(small))), 1e-15);
  }
}

TEST(Exponential, EndsInZeroAndInfinity) {
  EXPECT_EQ(exp_of(0.0), 1.0);
  EXPECT_EQ(exp_of(-1e300), 0.0);
  EXPECT_EQ(exp_of(-kInfinity), 0.0);
  EXPECT_EQ(exp_of(1e300), kInfinity);
  EXPECT_EQ(exp_of(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(exp_of(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(std::isfinite(exp_of(709.7)));
}

TEST(NaturalLogarithm, AgreesWithLongDoubleTo1e15AndNearOneToo) {
  RandomStream random(4, "logarithm");
  for (int trial = 0; trial < 100'000; ++trial) {
    const double x =
        std::ldexp(1.0 + random.uniform(), static_cast<int>(random.below(2000)) - 1000);
    ASSERT_LT(relative_error(log_of(x), std::log(static_cast<long double>(x))), 1e-15) << x;
    const double near_one = 1.0 + uniform_in(random, -0.4, 0.4);
    if (near_one != 1.0) {
      ASSERT_LT(relative_error(log_of(near_one), std::log(static_cast<long double>(near_one))),
                1e-15)
          << near_one;
    }
  }
  EXPECT_EQ(log_of(1.0), 0.0);
  EXPECT_EQ(log_of(0.0), -kInfinity);
  EXPECT_EQ(log_of(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(log_of(-1.0)));
}

// Φ(z) = ½ erfc(−z / √2)
TEST(CumulativeNormal, AgreesWithLongDoubleTo4e15AndInTheTailToo) {
  RandomStream random(5, "normal");
  for (int trial = 0; trial < 100'000; ++trial) {
    const double z =
        trial % 2 == 0 ? uniform_in(random, -4.0, 4.0) : uniform_in(random, -37.0, 9.0);
    const long double exact =
        0.5L * std::erfc(-static_cast<long double>(z) / std::numbers::sqrt2_v<long double>);
    ASSERT_LT(relative_error(cumulative_normal(z), exact), 4e-15) << z;
  }
}

TEST(CumulativeNormal, OfItsMiddleAndItsEnds) {
  EXPECT_EQ(cumulative_normal(0.0), 0.5);
  EXPECT_EQ(cumulative_normal(40.0), 1.0);
  EXPECT_EQ(cumulative_normal(-kInfinity), 0.0);
  EXPECT_EQ(cumulative_normal(kInfinity), 1.0);
  EXPECT_NEAR(cumulative_normal(1.0) + cumulative_normal(-1.0), 1.0, 1e-15);
}

}  // namespace impetus::elementary_functions_test
