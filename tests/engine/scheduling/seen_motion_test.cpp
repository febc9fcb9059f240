// What a moving, turning eye sees of moving bodies, and the logarithm that measures it.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/scheduling/metrics.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::seen_motion_test {

constexpr std::uint64_t kSeed = 51;
constexpr ScreenGeometry kScreen{0.5, 0.3, 1600, 900, 0.5};
constexpr double kPerRadian = 180.0 / std::numbers::pi;

Viewer moving_viewer(RandomStream& random) {
  Viewer viewer = viewer_at(kScreen, uniform_in(random, -180.0, 180.0));
  viewer.velocity = random_in_cube(random, 3.0);
  viewer.turning = random_in_cube(random, 2.0);
  return viewer;
}

/// Before the eye, so that it has an image.
Vector3 place_before(const Viewer& viewer, RandomStream& random) {
  return viewer.eye - uniform_in(random, 0.5, 4.0) * viewer.eye.normalized() +
         uniform_in(random, -0.4, 0.4) * viewer.right + uniform_in(random, -0.4, 0.4) * viewer.up;
}

TEST(SeenMotion, ABodyThatMovesAndTurnsWithTheEyeStandsStill) {
  RandomStream random(kSeed, "with the eye");
  for (int trial = 0; trial < 1'000; ++trial) {
    const Viewer viewer = moving_viewer(random);
    const Vector3 place = place_before(viewer, random);
    const Vector3 carried = viewer.velocity + viewer.turning.cross(place - viewer.eye);
    // Two roundings of speeds up to 20 m/s, over half a metre.
    EXPECT_LT(angular_speed_deg_s(viewer, place, carried), 1e-12);
    EXPECT_LT(seen_velocity(viewer, place, carried).norm(), 1e-14);
  }
}

TEST(SeenMotion, TurningAloneMovesWhatIsStraightAheadByItself) {
  Viewer viewer = viewer_at(kScreen, 0.0);
  viewer.turning = Vector3(0.0, 0.25, 0.0);
  // ‖X × (ω × X)‖ / ‖X‖² = ‖ω‖ for X across ω, at any distance.
  for (const double z : {0.0, -1.0, -20.0}) {
    EXPECT_NEAR(angular_speed_deg_s(viewer, {0.0, 0.0, z}, Vector3::Zero()), 0.25 * kPerRadian,
                1e-13);
  }
  // Turning to the left moves everything to the right.
  EXPECT_GT(seen_velocity(viewer, {0.0, 0.0, -3.0}, Vector3::Zero()).x(), 0.0);
}

TEST(SeenMotion, MovingPastHalvesWithTwiceTheDistance) {
  Viewer viewer = viewer_at(kScreen, 0.0);
  viewer.velocity = Vector3(0.3, 0.0, 0.0);
  EXPECT_NEAR(angular_speed_deg_s(viewer, Vector3::Zero(), Vector3::Zero()), 0.6 * kPerRadian,
              1e-13);
  EXPECT_NEAR(angular_speed_deg_s(viewer, {0, 0, -0.5}, Vector3::Zero()), 0.3 * kPerRadian, 1e-13);
}

TEST(SeenMotion, OfABodyBeforeAnEyeAtRestIsThatOfItsImageInDegrees) {
  RandomStream random(kSeed, "images");
  for (int trial = 0; trial < 1'000; ++trial) {
    Viewer viewer = moving_viewer(random);
    viewer.velocity.setZero();
    viewer.turning.setZero();
    const Vector3 place = place_before(viewer, random);
    const Vector3 velocity = random_in_cube(random, 1.0);
    constexpr double kShort_s = 1e-4;
    const double turned_deg =
        visual_angle_deg(viewer, place - kShort_s * velocity, place + kShort_s * velocity);
    // Central differences, degrees: error of h² and of rounding over h.
    EXPECT_NEAR(angular_speed_deg_s(viewer, place, velocity), turned_deg / (2.0 * kShort_s), 1e-4);
  }
}

TEST(SeenMotion, AnEyeAtRestChangesNoBit) {
  RandomStream random(kSeed, "at rest");
  for (int trial = 0; trial < 1'000; ++trial) {
    const Viewer viewer = viewer_at(kScreen, uniform_in(random, -180.0, 180.0));
    const Vector3 place = random_in_cube(random, 3.0);
    const Vector3 velocity = random_in_cube(random, 3.0);
    const Vector3 from_eye = place - viewer.eye;
    EXPECT_EQ(angular_speed_deg_s(viewer, place, velocity),
              degrees(from_eye.cross(velocity).norm() / from_eye.squaredNorm()));
  }
}

TEST(SeenMotion, OfAPairRelativeToEachOtherTheCameraCancels) {
  RandomStream random(kSeed, "camera cancels");
  const auto collision_speed = make_metric("collision-speed");
  const auto velocity = make_metric("velocity");
  for (int trial = 0; trial < 100; ++trial) {
    const Viewer moving = moving_viewer(random);
    Viewer resting = moving;
    resting.velocity.setZero();
    resting.turning.setZero();
    const Vector3 place = place_before(moving, random);
    PairBounds pair{{0, 1}, {place, 0.01}, {place + Vector3(0.02, 0.0, 0.0), 0.01}};
    pair.velocity_a = random_in_cube(random, 1.0);
    pair.velocity_b = random_in_cube(random, 1.0);
    EXPECT_EQ(collision_speed->measure(pair, moving, {}),
              collision_speed->measure(pair, resting, {}));
    EXPECT_NE(velocity->measure(pair, moving, {}), velocity->measure(pair, resting, {}));
  }
}

TEST(Logarithm, AgreesWithTheLongDoubleLibraryOverAllMagnitudes) {
  RandomStream random(kSeed, "logarithms");
  for (int trial = 0; trial < 200'000; ++trial) {
    const double x =
        std::ldexp(1.0 + random.uniform(), static_cast<int>(random.below(2'000)) - 1'000);
    const auto exact = static_cast<double>(std::log10(static_cast<long double>(x)));
    EXPECT_NEAR(log10_of(x), exact, 1e-15 * std::max(1.0, std::fabs(exact))) << x;
  }
  EXPECT_EQ(log10_of(1.0), 0.0);
  EXPECT_NEAR(log10_of(std::numeric_limits<double>::denorm_min()), -323.306215343115805, 1e-12);
  EXPECT_EQ(log10_of(0.0), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(log10_of(std::numeric_limits<double>::infinity()),
            std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(log10_of(-1.0)));
  EXPECT_TRUE(std::isnan(log10_of(std::nan(""))));
}

}  // namespace impetus::seen_motion_test
