// Integrals over traits that are known.
// SPDX-License-Identifier: MIT
#include "experiments/fitting/trait_integral.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace impetus::trait_integral_test {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// ∫ exp(-½ (z - m)ᵀ P (z - m)) dz = (2π)^(n/2) |P|^(-½)
TEST(TraitIntegral, OfANormalDistributionIsExact) {
  MatrixXd precision(2, 2);
  precision << 3.0, 1.2, 1.2, 2.0;
  const VectorXd middle = VectorXd::LinSpaced(2, 0.7, -1.9);
  VectorXd highest = VectorXd::Zero(2);
  const double found = logarithm_of_integral(
      [&](const VectorXd& z) { return -0.5 * (z - middle).dot(precision * (z - middle)); },
      highest);
  EXPECT_NEAR(found, std::log(2.0 * std::numbers::pi) - 0.5 * std::log(precision.determinant()),
              1e-5);
  EXPECT_LT((highest - middle).norm(), 1e-4);
}

// A thousand yes of a logistic trait: ∫ (1 + exp(-z))^-1000 φ(z) dz, by a dense grid.
TEST(TraitIntegral, FollowsWhatLiesFarFromTheMean) {
  const auto f = [](const VectorXd& z) {
    return -1000.0 * std::log1p(std::exp(-z[0])) - 0.5 * z[0] * z[0];
  };
  double sum = 0.0;
  constexpr double kStep = 1e-3;
  for (double z = -10.0; z <= 20.0; z += kStep) {
    sum += std::exp(f(VectorXd::Constant(1, z))) * kStep;
  }
  VectorXd highest = VectorXd::Zero(1);
  EXPECT_NEAR(logarithm_of_integral(f, highest), std::log(sum), 2e-3);
  EXPECT_GT(highest[0], 3.0);
}

// ∫ exp(-z²/2) (z < edge ? 1 : fall) dz = √(2π) (Φ(edge) + fall (1 - Φ(edge)))
TEST(TraitIntegral, OfAStepIsExactWhereverItIs) {
  for (const double edge : {-2.013, -0.499, 0.3, 1.77}) {
    for (const double fall : {-30.0, -3.0, 2.0}) {
      const double found = logarithm_of_rough_integral(
          [&](double z) { return (z < edge ? 0.0 : fall) - 0.5 * z * z; });
      const double below = 0.5 * std::erfc(-edge / std::sqrt(2.0));
      EXPECT_NEAR(
          found,
          std::log(std::sqrt(2.0 * std::numbers::pi) * (below + std::exp(fall) * (1.0 - below))),
          5e-3)
          << edge << ' ' << fall;
    }
  }
}

// N(20, .03²), which lies between the nodes that are tried first.
TEST(TraitIntegral, FindsWhatIsNarrowAndFarOff) {
  const auto f = [](double z) {
    const double off = (z - 20.3) / 0.03;
    return -0.5 * off * off - 1e-3 * z * z;
  };
  EXPECT_NEAR(logarithm_of_rough_integral(f),
              std::log(0.03 * std::sqrt(2.0 * std::numbers::pi)) - 1e-3 * 20.3 * 20.3, 1e-3);
}

// From where f curves the wrong way, too: two humps, of which one counts.
TEST(TraitIntegral, ClimbsOutOfAHollow) {
  const auto f = [](const VectorXd& z) {
    return std::log(std::exp(-2.0 * (z[0] - 4.0) * (z[0] - 4.0)) + 1e-12) - 1e-3 * z[0] * z[0];
  };
  VectorXd highest = VectorXd::Constant(1, 2.2);
  static_cast<void>(logarithm_of_integral(f, highest));
  EXPECT_NEAR(highest[0], 4.0, 0.01);
}

}  // namespace impetus::trait_integral_test
