// The gap between a drawn body and a wall of the closed cube.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "engine/numerics/random_stream.hpp"
#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/run/collision_truth.hpp"

namespace impetus::wall_truth_test {

const ClosedCube kCube{0.05};
const DrawnBody kBall{"ball", 0.01, {}, nullptr};

Viewer front() { return viewer_at(assumed_screen(), 0.0); }

CollisionTruth ball_truth(const Vector3& place, int wall) {
  return measure_wall_truth(kBall, {place, Quaternion::Identity()}, kCube, wall, front());
}

TEST(WallTruth, OfABallIsWhatIsLeftToTheWall) {
  const CollisionTruth truth = ball_truth({0.038, 0.0, 0.0}, 0);
  // 5 cm to the wall − 3.8 cm to the centre − 1 cm of radius, in the screen's plane.
  EXPECT_NEAR(truth.gap_m, 0.002, 1e-15);
  const double expected_rad = std::atan(0.05 / 0.57) - std::atan(0.048 / 0.57);
  EXPECT_NEAR(truth.gap_arcmin, expected_rad * 3437.7468, 1e-3);
  EXPECT_NEAR(truth.gap_px, 0.002 * 1280 / 0.376, 1e-9);
  EXPECT_LE(truth.hidden_share, 1.0 / 64);  // from the side the ball bulges before its edge: a ray
}

TEST(WallTruth, IsNothingWhereTheBodyTouchesOrReachesBeyond) {
  for (const double x_m : {0.04, 0.041}) {
    EXPECT_NEAR(ball_truth({x_m, 0.0, 0.0}, 0).visible_arcmin(), 0.0, 1e-9);
  }
}

TEST(WallTruth, BehindItTheBodyHidesItsGap) {
  EXPECT_EQ(ball_truth({0.0, 0.0, -0.038}, 5).hidden_share, 1.0);
}

TEST(WallTruth, BeforeItTheGapIsSeenEndOn) {
  const CollisionTruth truth = ball_truth({0.0, 0.0, 0.038}, 4);
  EXPECT_NEAR(truth.gap_m, 0.002, 1e-15);
  EXPECT_NEAR(truth.gap_arcmin, 0.0, 1e-9);
  EXPECT_EQ(truth.hidden_share, 0.0);
}

/// A slab 2 m wide whose inner face is the wall.
Pose slab_behind(int wall) {
  return {-inward_normal(wall) * (kCube.half_edge_m + 1.0), Quaternion::Identity()};
}

// Oracle: the distance of two meshes, of which one is a slab in the wall's place.
TEST(WallTruth, OfAMeshIsItsDistanceFromASlabInTheWallsPlace) {
  RandomStream stream(20250711, "wall truth");
  const auto block =
      std::make_shared<const TriangleMesh>(about_centre_of_mass(l_block_mesh(0.02, 0.007)));
  const DrawnBody look{"block", 0.02, {}, block};
  const DrawnBody slab{
      "slab", 2.0, {}, std::make_shared<const TriangleMesh>(box_mesh({2.0, 2.0, 2.0}))};
  const auto draw = [&] { return 2.0 * stream.uniform() - 1.0; };
  for (int trial = 0; trial < 60; ++trial) {
    const int wall = trial % kWallCount;
    const Pose pose{0.02 * Vector3(draw(), draw(), draw()),
                    Quaternion(draw(), draw(), draw(), draw()).normalized()};
    const CollisionTruth truth = measure_wall_truth(look, pose, kCube, wall, front());
    const CollisionTruth oracle = measure_truth(look, pose, slab, slab_behind(wall), front());
    // Rounding of coordinates near 1 m.
    EXPECT_NEAR(truth.gap_m, oracle.gap_m, 1e-12) << "wall " << wall << ", trial " << trial;
    EXPECT_NEAR(truth.gap_arcmin, oracle.gap_arcmin, 1e-6);
  }
}

}  // namespace impetus::wall_truth_test
