// Metrics: known angles, the direction of each, and the names.
// SPDX-License-Identifier: MIT
#include "engine/scheduling/metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/engine/builders.hpp"

namespace impetus {
namespace {

constexpr ScreenGeometry kScreen{0.5, 0.3, 1600, 900, 0.5};
const Viewer kViewer = viewer_at(kScreen, 0.0);  // the eye at (0, 0, 0.5), looking along −z
// Two or three roundings of an angle in degrees.
constexpr double kAngleError_deg = 1e-12;

/// Two equal spheres that touch at `place`, side by side along y.
PairBounds pair_at(const Vector3& place, double radius_m = 0.01) {
  const Vector3 half = radius_m * Vector3::UnitY();
  return {{0, 1}, {place - half, radius_m}, {place + half, radius_m}};
}

double measured(const char* metric, const PairBounds& bounds, const Fixation& fixation = {}) {
  return make_metric(metric)->measure(bounds, kViewer, fixation);
}

double priority(const char* metric, const PairBounds& bounds, const Fixation& fixation = {}) {
  return make_metric(metric)->priority(measured(metric, bounds, fixation));
}

TEST(Metrics, DistanceIsInMetresAndNearIsHigh) {
  EXPECT_DOUBLE_EQ(measured("distance", pair_at({0.0, 0.0, -1.0})), 1.5);
  EXPECT_GT(priority("distance", pair_at({0, 0, 0.1})), priority("distance", pair_at({0, 0, 0})));
}

TEST(Metrics, SizeIsTheAngleBetweenTangentsAndLargeIsHigh) {
  // sin(½ angle) = R / d: R = ¼ at d = ½ spans 60°.
  const PairBounds one{{0, 1}, {Vector3::Zero(), 0.25}, {Vector3::Zero(), 0.25}};
  EXPECT_NEAR(measured("size", one), 60.0, kAngleError_deg);
  PairBounds mixed = one;
  mixed.b.radius_m = 0.0;
  EXPECT_NEAR(measured("size", mixed), 30.0, kAngleError_deg) << "the mean of both";
  mixed.b.radius_m = 0.7;
  EXPECT_NEAR(measured("size", mixed), 120.0, kAngleError_deg) << "an eye inside sees 180 degrees";
  EXPECT_GT(priority("size", pair_at({0, 0, 0}, 0.02)), priority("size", pair_at({0, 0, 0}, 0.01)));
  EXPECT_GT(priority("size", pair_at({0, 0, 0})), priority("size", pair_at({0, 0, -1})));
}

TEST(Metrics, VelocityIsTheMeanAngularSpeedAndSlowIsHigh) {
  // Across the line of sight at 1 m from the eye: 0.1 m/s are 0.1 rad/s; along it, nothing.
  PairBounds pair{{0, 1}, {Vector3(0, 0, -0.5), 0.01}, {Vector3(0, 0, -0.5), 0.01}};
  pair.velocity_a = Vector3(0.1, 0.0, 5.0);
  pair.velocity_b = Vector3(0.0, 0.3, -2.0);
  const double per_radian = 180.0 / std::numbers::pi;
  EXPECT_NEAR(measured("velocity", pair), 0.2 * per_radian, kAngleError_deg);
  PairBounds slower = pair;
  slower.velocity_b.setZero();
  EXPECT_GT(priority("velocity", slower), priority("velocity", pair));
}

TEST(Metrics, EccentricityIsTheAngleFromTheFixationAndCentralIsHigh) {
  // 0.5 m right of the centre, seen from 0.5 m: 45°.
  const PairBounds aside = pair_at({0.5, 0.0, 0.0});
  EXPECT_NEAR(measured("eccentricity", aside), 45.0, kAngleError_deg) << "from the centre";
  EXPECT_NEAR(measured("eccentricity", aside, ScreenPoint{0.5, 0.0}), 0.0, kAngleError_deg);
  EXPECT_NEAR(measured("eccentricity", aside, ScreenPoint{-0.5, 0.0}), 90.0, kAngleError_deg);
  EXPECT_NEAR(measured("eccentricity", aside, ScreenPoint{0.5, std::sqrt(0.5)}), 45.0,
              kAngleError_deg)
      << "upward";
  // Behind the screen in line with it: no further from the fixation.
  EXPECT_NEAR(measured("eccentricity", pair_at({1.0, 0.0, -0.5})), 45.0, kAngleError_deg);
  const ScreenPoint fixation{0.4, 0.1};
  EXPECT_GT(priority("eccentricity", aside, fixation),
            priority("eccentricity", pair_at(Vector3::Zero()), fixation));
}

TEST(Metrics, EccentricityIsThatOfTheTouchingPointNotOfTheCentres) {
  // Radii 1 : 3 along y: the place is a quarter of the way from the small one.
  const PairBounds pair{{0, 1}, {Vector3(0, 0, 0), 0.01}, {Vector3(0, 0.04, 0), 0.03}};
  EXPECT_LT((collision_place(pair) - Vector3(0, 0.01, 0)).norm(), 1e-16);
  EXPECT_NEAR(measured("eccentricity", pair), std::atan2(0.01, 0.5) * 180.0 / std::numbers::pi,
              kAngleError_deg);
}

TEST(Metrics, EccentricityTurnsWithTheViewer) {
  const Viewer from_the_side = viewer_at(kScreen, 90.0);
  const PairBounds aside = pair_at({0.0, 0.0, -0.5});
  const auto metric = make_metric("eccentricity");
  EXPECT_NEAR(metric->measure(aside, from_the_side, {}), 45.0, kAngleError_deg);
  EXPECT_NEAR(metric->measure(aside, from_the_side, ScreenPoint{0.5, 0.0}), 0.0, kAngleError_deg);
}

TEST(Metrics, ProjectedGapIsTheAngleOfTheFitErrorAndLargeIsHigh) {
  PairBounds pair = pair_at({0.0, 0.0, -0.5});
  pair.fit_error_m = 2.0;
  EXPECT_NEAR(measured("projected-gap", pair), 90.0, kAngleError_deg) << "2 atan(1 / 1)";
  PairBounds smaller = pair;
  smaller.fit_error_m = 1.0;
  EXPECT_GT(priority("projected-gap", pair), priority("projected-gap", smaller));
  PairBounds farther = pair_at({0.0, 0.0, -5.0});
  farther.fit_error_m = 2.0;
  EXPECT_GT(priority("projected-gap", pair), priority("projected-gap", farther));
}

TEST(Metrics, EveryNameMakesAMetricAndOthersAreRefused) {
  for (const std::string_view name : metric_names()) {
    EXPECT_NE(make_metric(name), nullptr) << name;
  }
  try {
    make_metric("loudness");
    ADD_FAILURE() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "scheduler: expected one of distance, eccentricity, projected-gap, size, "
                 "velocity, got \"loudness\"");
  }
}

}  // namespace
}  // namespace impetus
