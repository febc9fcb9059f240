// Metrics: known angles, the direction of each, and the names.
// SPDX-License-Identifier: MIT
#include "engine/scheduling/metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "engine/collision/pair_refinement.hpp"
#include "engine/scheduling/visible_frequency.hpp"
#include "engine/shapes/mesh_distance.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/mesh_oracles.hpp"

namespace impetus::metrics_test {

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

TEST(Metrics, ProjectedCentresIsTheAngleBetweenTheCentresSoDepthAndForeshorteningCount) {
  const auto apart = [](const Vector3& a, const Vector3& b) {
    PairBounds pair = pair_at({0.0, 0.0, 0.0});
    pair.a.centre = a;
    pair.b.centre = b;
    return measured("projected-centres", pair);
  };
  // The eye is at z = 0.5: 2 atan(0.5 / 1) at a distance of 1.
  EXPECT_NEAR(apart({-0.5, 0, -0.5}, {0.5, 0, -0.5}), 53.13010235415598, kAngleError_deg);
  EXPECT_LT(apart({-0.5, 0, -1.5}, {0.5, 0, -1.5}), apart({-0.5, 0, -0.5}, {0.5, 0, -0.5}));
  EXPECT_NEAR(apart({0, 0, -1.0}, {0, 0, -0.5}), 0.0, kAngleError_deg) << "along the line of sight";
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

TEST(Metrics, CollisionSpeedIsThatOfOneBodyPastTheOtherAndSlowIsHigh) {
  // 1 m from the eye, side by side: 0.3 m/s across the line of sight are 0.3 rad/s.
  PairBounds pair = pair_at({0.0, 0.0, -0.5});
  pair.velocity_a = Vector3(0.2, 0.0, 7.0);
  pair.velocity_b = Vector3(-0.1, 0.0, 2.0);
  const double per_radian = 180.0 / std::numbers::pi;
  EXPECT_NEAR(measured("collision-speed", pair), 0.3 * per_radian, kAngleError_deg);
  PairBounds together = pair;
  together.velocity_b = together.velocity_a;
  EXPECT_EQ(measured("collision-speed", together), 0.0) << "side by side";
  EXPECT_GT(priority("collision-speed", together), priority("collision-speed", pair));
  PairBounds at_wall = together;
  at_wall.pair.b = kEnclosure;
  EXPECT_NEAR(measured("collision-speed", at_wall), 0.2 * per_radian, kAngleError_deg)
      << "the wall stands still";
}

TEST(Metrics, GapIsBetweenTheCentresAndGapBoundTheFitErrorAndLargeIsHigh) {
  PairBounds pair = pair_at({0.3, 0.0, -0.5}, 0.25);
  pair.fit_error_m = 0.125;
  EXPECT_DOUBLE_EQ(measured("gap", pair), 0.5);
  EXPECT_DOUBLE_EQ(measured("gap-bound", pair), 0.125);
  PairBounds wider = pair_at({0.3, 0.0, -9.5}, 0.3);
  wider.fit_error_m = 0.2;
  EXPECT_GT(priority("gap", wider), priority("gap", pair)) << "at any distance";
  EXPECT_GT(priority("gap-bound", wider), priority("gap-bound", pair));
}

TEST(Metrics, NoPairThatTouchesAtALevelIsFurtherApartThanItsGapBound) {
  RandomStream random(7, "gap bounds");
  const TriangleMesh mesh = small_l_block();
  const VolumeTree tree = octree(mesh, 3);
  const auto metric = make_metric("gap-bound");
  int touching = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Pose pose{random_in_cube(random, 0.2), random_turn(random)};
    PlacedTree a(tree);
    PlacedTree b(tree);
    b.move_to(pose);
    PairRefinement refinement(a, b);
    const double gap_m =
        intersects(mesh, {}, mesh, pose) ? 0.0 : mesh_distance(mesh, {}, mesh, pose).distance_m;
    while (true) {
      if (!refinement.overlapping().empty()) {
        PairBounds bounds;
        bounds.fit_error_m = 2.0 * tree.fit_error_m(refinement.level());
        EXPECT_LE(gap_m, metric->measure(bounds, kViewer, {})) << "trial " << trial;
        ++touching;
      }
      const int level = refinement.level();
      while (!refinement.resolved() && refinement.level() == level) {
        refinement.refine_one_block();
      }
      if (refinement.level() == level) {
        break;
      }
    }
  }
  EXPECT_GT(touching, 60);
}

TEST(Metrics, VisibleFrequencyHasReddysValues) {
  // experiments: M(10) = .4681, M(20) = .1529, G(10) = 29.91, their product 14.00.
  EXPECT_NEAR(share_seen_at_eccentricity(10.0), 0.4681, 5e-5);
  EXPECT_NEAR(share_seen_at_eccentricity(20.0), 0.1529, 5e-5);
  EXPECT_EQ(share_seen_at_eccentricity(5.79), 1.0);
  EXPECT_NEAR(frequency_seen_at_speed(10.0), 29.91, 5e-3);
  EXPECT_EQ(frequency_seen_at_speed(0.825), 60.0);
  EXPECT_EQ(frequency_seen_at_speed(118.4), 0.1);
  // 10° right of the fixation, both at 10°/s: 1 m away, along the circle about the eye.
  const double angle_rad = 10.0 / 180.0 * std::numbers::pi;
  const Vector3 ray(std::sin(angle_rad), 0.0, -std::cos(angle_rad));
  PairBounds pair{{0, 1}, {kViewer.eye + ray, 0.01}, {kViewer.eye + ray, 0.01}};
  pair.velocity_a = angle_rad * Vector3::UnitY();
  pair.velocity_b = pair.velocity_a;
  EXPECT_NEAR(measured("visible-frequency", pair), 14.00, 5e-3);
  PairBounds slower = pair;
  slower.velocity_b.setZero();
  EXPECT_GT(priority("visible-frequency", slower), priority("visible-frequency", pair));
  EXPECT_GT(priority("visible-frequency", pair, ScreenPoint{0.05, 0.0}),
            priority("visible-frequency", pair));
}

TEST(Metrics, APointStandsInTheFixationsPlace) {
  const PairBounds pair = pair_at({0.5, 0.0, 0.0});
  MetricOptions options;
  options.point = ScreenPoint{0.5, 0.0};
  for (const char* name : {"eccentricity", "visible-frequency"}) {
    const double at_point = measured(name, pair, options.point);
    for (const Fixation& fixation : {Fixation{}, Fixation{ScreenPoint{-0.5, 0.1}}}) {
      EXPECT_EQ(make_metric(name, options)->measure(pair, kViewer, fixation), at_point) << name;
      EXPECT_NE(measured(name, pair, fixation), at_point) << name;
    }
  }
}

MetricOptions terms(std::vector<WeightedTerm> of) {
  MetricOptions options;
  options.terms = std::move(of);
  return options;
}

TEST(Metrics, AWeightedSumBringsEachTermFromRelaxedToUrgent) {
  const MetricOptions both = terms({{"distance", 3.0, 1.0, 2.0}, {"eccentricity", 1.0, 0.0, 90.0}});
  const auto metric = make_metric("weighted", both);
  const auto at = [&](const Vector3& place) {
    return metric->measure(pair_at(place), kViewer, {});
  };
  EXPECT_NEAR(at({0.0, 0.0, -0.5}), 4.0, kAngleError_deg) << "1 m ahead";
  EXPECT_NEAR(at({0.0, 0.0, -0.75}), 3.0 * 0.75 + 1.0, kAngleError_deg);
  EXPECT_NEAR(at({0.0, 0.0, -9.0}), 1.0, kAngleError_deg) << "clamped";
  EXPECT_NEAR(at({0.0, 0.0, 0.4}), 4.0, kAngleError_deg) << "clamped";
  EXPECT_NEAR(at({2.0, 0.0, -1.5}), 0.5, kAngleError_deg) << "45 degrees, 2.8 m";
  EXPECT_GT(metric->priority(1.0), metric->priority(0.5)) << "high first";
}

TEST(Metrics, AWeightedSumHandsThePointToTheTermsThatTakeOne) {
  MetricOptions options = terms({{"distance", 1.0, 0.0, 1.0}, {"eccentricity", 1.0, 0.0, 90.0}});
  options.point = ScreenPoint{0.5, 0.0};
  const PairBounds pair = pair_at({0.5, 0.0, 0.0});
  EXPECT_GT(make_metric("weighted", options)->measure(pair, kViewer, ScreenPoint{-0.5, 0.0}), 1.0);
}

std::string refusal(const char* name, const MetricOptions& options = {}) {
  try {
    make_metric(name, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Metrics, EveryNameMakesAMetricAndOthersAreRefused) {
  for (const std::string_view name : metric_names()) {
    const MetricOptions options =
        needs_terms(name) ? terms({{"size", 1.0, 10.0, 0.0}}) : MetricOptions{};
    EXPECT_NE(make_metric(name, options), nullptr) << name;
  }
  EXPECT_EQ(refusal("loudness"),
            "scheduler: expected one of collision-speed, distance, eccentricity, gap, gap-bound, "
            "perceived, projected-centres, projected-gap, size, velocity, visible-frequency, "
            "weighted, got "
            "\"loudness\"");
}

TEST(Metrics, PerceivedIsTheProbabilityThatTheGapIsNoticed) {
  MetricOptions options;
  options.noticing = {10.0, 0.2, 0.1};
  const auto metric = make_metric("perceived", options);
  PairBounds pair = pair_at(Vector3::Zero());
  const auto noticed = [&](double gap_arcmin, const Fixation& fixation = {}) {
    pair.fit_error_m = 2.0 * 0.5 * std::tan(0.5 * gap_arcmin / 60.0 * std::numbers::pi / 180.0);
    return metric->measure(pair, kViewer, fixation);
  };
  EXPECT_NEAR(noticed(10.0), 0.45, 1e-9);  // the threshold: half of those that are not missed
  EXPECT_NEAR(noticed(1000.0), 0.9, 1e-9);
  EXPECT_EQ(noticed(0.0), 0.0);
  const double aside_m = 0.5 * std::tan(2.3 * std::numbers::pi / 180.0);
  EXPECT_NEAR(noticed(20.0, ScreenPoint{aside_m, 0.0}), 0.45, 1e-6);  // half the acuity is left
  pair.velocity_a = {0.2, 0.0, 0.0};
  EXPECT_LT(noticed(10.0), 0.4);
  EXPECT_GT(metric->priority(0.5), metric->priority(0.4));
}

TEST(Metrics, OptionsThatNobodyCanHaveAreRefused) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  MetricOptions options;
  options.point = ScreenPoint{kNan, 0.0};
  EXPECT_EQ(refusal("eccentricity", options),
            "scheduler: expected a point of finite numbers, got nan, 0.000000 m");
  options = {};
  options.noticing.threshold_arcmin = kNan;
  const std::string expected =
      "scheduler: expected a threshold and a width above 0, and a miss rate from 0 to 1, got ";
  EXPECT_EQ(refusal("perceived", options), expected + "nan, 0.200000 and 0.100000");
  options = {};
  options.noticing.miss_rate = 1.5;
  EXPECT_EQ(refusal("perceived", options), expected + "10.000000, 0.200000 and 1.500000");
}

TEST(Metrics, OptionsWithoutAUseAreRefused) {
  MetricOptions point;
  point.point = ScreenPoint{};
  EXPECT_EQ(refusal("size", point),
            "scheduler: expected no point, which \"size\" has no use for, got one");
  EXPECT_EQ(refusal("eccentricity", terms({{"size", 1.0, 1.0, 0.0}})),
            "scheduler: expected no terms, which \"eccentricity\" has no use for, got 1");
  point.terms = {{"size", 1.0, 1.0, 0.0}};
  EXPECT_EQ(refusal("weighted", point),
            "weighted scheduler: expected no point, which none of its terms has a use for, got "
            "one");
}

TEST(Metrics, AWeightedSumsProblemIsNamed) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::string start = "weighted scheduler: expected ";
  EXPECT_EQ(refusal("weighted"), start + "at least one term, got none");
  EXPECT_EQ(refusal("weighted", terms({{"size", 0.0, 1.0, 0.0}})),
            start + "a weight above 0 for \"size\", got 0.000000");
  EXPECT_EQ(refusal("weighted", terms({{"size", infinity, 1.0, 0.0}})),
            start + "a weight above 0 for \"size\", got inf");
  const std::string ends = start + "two different finite ends, urgent and relaxed, for \"size\", ";
  EXPECT_EQ(refusal("weighted", terms({{"size", 1.0, 2.0, 2.0}})),
            ends + "got 2.000000 and 2.000000");
  EXPECT_EQ(refusal("weighted", terms({{"size", 1.0, std::nan(""), 2.0}})),
            ends + "got nan and 2.000000");
  EXPECT_EQ(refusal("weighted", terms({{"weighted", 1.0, 1.0, 0.0}})),
            start + "terms that are no sums themselves, got \"weighted\"");
  EXPECT_EQ(refusal("weighted", terms({{"loudness", 1.0, 1.0, 0.0}})), refusal("loudness"));
}

}  // namespace impetus::metrics_test
