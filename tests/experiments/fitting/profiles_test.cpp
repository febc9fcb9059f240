// Profiles of functions whose ends are known.
// SPDX-License-Identifier: MIT
#include "experiments/fitting/profiles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace impetus::profiles_test {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

Profiles profiles_of(const SmoothFunction& cost, const VectorXd& begun,
                     const std::vector<ProfiledParameter>& parameters) {
  const FoundMinimum best = find_minimum(cost, begun, 1e-8);
  return {cost, begun, best, inverse_of_curvature(curvature_at(cost, best.at)), parameters};
}

const std::vector<ProfiledParameter> kTwo{{60.0}, {60.0}};

// ½ xᵀ C⁻¹ x: the profile of xᵢ is xᵢ² / 2 Cᵢᵢ, which is 1.92 at 1.96 √Cᵢᵢ.
TEST(Profiles, OfANormalLikelihoodEndAtNearlyTwoStandardDeviations) {
  MatrixXd covariance(2, 2);
  covariance << 4.0, 1.8, 1.8, 1.0;
  const MatrixXd precision = covariance.inverse();
  const auto cost = [&](const VectorXd& x) { return 0.5 * x.dot(precision * x); };
  Profiles profiles = profiles_of(cost, Vector2d(0.5, -0.5), kTwo);
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_NEAR(profiles.end(0, sign).value(), sign * 1.96 * 2.0, 0.05);
    EXPECT_NEAR(profiles.end(1, sign).value(), sign * 1.96 * 1.0, 0.05);
  }
}

// A valley that bends: (1 − x)² / 2 + 50 (y − x²)². The profile of x is (1 − x)² / 2, whatever way
// y has to go.
TEST(Profiles, FollowABendingValley) {
  const auto cost = [](const VectorXd& v) {
    return 0.5 * std::pow(1.0 - v[0], 2) + 50.0 * std::pow(v[1] - v[0] * v[0], 2);
  };
  Profiles profiles = profiles_of(cost, Vector2d(1.2, 1.2), kTwo);
  EXPECT_NEAR(profiles.end(0, -1.0).value(), 1.0 - 1.96, 0.05);
  EXPECT_NEAR(profiles.end(0, 1.0).value(), 1.0 + 1.96, 0.05);
}

// Two valleys, at y = 0 and y = 8, and a ridge between them: x is narrow in the one, where the best
// place is, and wide in the other, which is hardly worse. The interval is that of both.
TEST(Profiles, FindTheOtherValleyWhereTheSearchBegan) {
  const auto cost = [](const VectorXd& v) {
    const double narrow = 0.5 * std::pow(v[0] / 0.01, 2) + 2.0 * v[1] * v[1];
    const double wide = 0.3 + 0.5 * v[0] * v[0] + 2.0 * std::pow(v[1] - 8.0, 2);
    return std::min(narrow, wide);
  };
  FoundMinimum best{Vector2d(0.0, 0.0), 0.0};
  const MatrixXd inverse = inverse_of_curvature(curvature_at(cost, best.at));
  Profiles profiles(cost, Vector2d(0.0, 8.0), best, inverse, kTwo);
  const double end = std::sqrt(2.0 * (kProfileFall - 0.3));
  EXPECT_NEAR(profiles.end(0, 1.0).value(), end, 0.05);
  EXPECT_NEAR(profiles.end(0, -1.0).value(), -end, 0.05);
}

// Only the product of both is known, and the other can go no further than its reach: what ends
// there is no end.
TEST(Profiles, AreOpenWhereAnotherCameToTheEndOfItsReach) {
  const auto cost = [](const VectorXd& v) {
    const double y = std::min(v[1], 3.0);
    return 0.5 * std::pow((v[0] + y) / 0.1, 2) + std::pow(v[1] - y, 2);
  };
  const std::vector<ProfiledParameter> reach{{60.0}, {3.0}};
  Profiles profiles = profiles_of(cost, Vector2d(0.0, 0.0), reach);
  EXPECT_FALSE(profiles.end(0, -1.0).has_value());
  // There it is a value like others: a chance of 0, a spread of 0.
  Profiles closed = profiles_of(cost, Vector2d(0.0, 0.0), {{60.0}, {3.0, true, true}});
  EXPECT_NEAR(closed.end(0, -1.0).value(), -3.0 - 0.196, 0.05);
}

TEST(Profiles, ThatComeUponABetterPlaceSayWhere) {
  const auto cost = [](const VectorXd& v) {
    return 0.5 * v[0] * v[0] / 4.0 +
           std::min(v[1] * v[1], 2.0 * std::pow(v[1] - v[0] - 2.0, 2) - 3.0);
  };
  FoundMinimum best{Vector2d(0.0, 0.0), 0.0};
  Profiles profiles(cost, Vector2d(1.0, 3.0), best, MatrixXd::Identity(2, 2), kTwo);
  EXPECT_FALSE(profiles.end(1, 1.0).has_value());
  ASSERT_TRUE(profiles.better().has_value());
  EXPECT_LT(profiles.better()->value, -2.0);
  EXPECT_NEAR(cost(profiles.better()->at), profiles.better()->value, 1e-9);
}

}  // namespace impetus::profiles_test
