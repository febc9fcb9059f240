// What a gap can be at most, beside what it is.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "engine/numerics/random_stream.hpp"
#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/run/collision_truth.hpp"

namespace impetus::most_gap_test {

constexpr std::uint64_t kSeed = 20250711;

class MostGap : public testing::Test {
 protected:
  Vector3 drawn(double reach) {
    const auto draw = [&] { return reach * (2.0 * random_.uniform() - 1.0); };
    const double x = draw();
    const double y = draw();
    return {x, y, draw()};
  }

  Pose drawn_pose() {
    const Vector3 place = drawn(0.1);
    const Vector3 turn = drawn(1.0);
    return {place, Quaternion(random_.uniform(), turn.x(), turn.y(), turn.z()).normalized()};
  }

  static DrawnBody looking_like(const TriangleMesh& mesh) {
    return {"body", 0.0, {}, std::make_shared<const TriangleMesh>(mesh)};
  }

  RandomStream random_{kSeed, "most gap"};
  const Viewer viewer_ = viewer_at(assumed_screen(), 0.0);
};

TEST_F(MostGap, IsNeverLessThanTheGapAndMostlyNotTwiceAsMuch) {
  const DrawnBody block = looking_like(about_centre_of_mass(l_block_mesh(0.02, 0.007)));
  const DrawnBody ball = looking_like(icosphere_mesh(0.01, 3));
  std::vector<double> shares;
  for (int trial = 0; trial < 300; ++trial) {
    const DrawnBody& a = trial % 2 == 0 ? block : ball;
    const Pose at_a = drawn_pose();
    const Pose at_b = drawn_pose();
    const double gap_arcmin = measure_truth(a, at_a, ball, at_b, viewer_).gap_arcmin;
    const double most_arcmin = most_gap_arcmin(a, at_a, ball, at_b, viewer_);
    ASSERT_GE(most_arcmin, gap_arcmin) << "seed " << kSeed << ", trial " << trial;
    shares.push_back(gap_arcmin / most_arcmin);
  }
  std::nth_element(shares.begin(), shares.begin() + 150, shares.end());
  EXPECT_GT(shares[150], 0.5);
}

TEST_F(MostGap, IsTheGapOfBallsSideBySideAndNoLessOfBallsAnywhere) {
  const DrawnBody ball{"ball", 0.01, {}, nullptr};
  for (int trial = 0; trial < 300; ++trial) {
    const Pose at_a = drawn_pose();
    const Pose at_b = drawn_pose();
    ASSERT_GE(most_gap_arcmin(ball, at_a, ball, at_b, viewer_),
              measure_truth(ball, at_a, ball, at_b, viewer_).gap_arcmin)
        << "seed " << kSeed << ", trial " << trial;
  }
  const Pose left{Vector3(-0.011, 0.0, 0.0), Quaternion::Identity()};
  const Pose right{Vector3(0.011, 0.0, 0.0), Quaternion::Identity()};
  const double gap_arcmin = measure_truth(ball, left, ball, right, viewer_).gap_arcmin;
  // Seen from 57 cm as if from the balls' nearer side, a centimetre before their gap.
  EXPECT_NEAR(most_gap_arcmin(ball, left, ball, right, viewer_) / gap_arcmin, 57.0 / 56.0, 1e-3);
}

TEST_F(MostGap, OfABodyAboutTheEyeIsAHalfTurn) {
  const DrawnBody ball{"ball", 0.01, {}, nullptr};
  const Pose at_eye{viewer_.eye, Quaternion::Identity()};
  const Pose before{viewer_.eye + Vector3(0.0, 0.0, -0.1), Quaternion::Identity()};
  EXPECT_EQ(most_gap_arcmin(ball, at_eye, ball, before, viewer_), 180.0 * 60.0);
}

TEST_F(MostGap, OfAWallIsTheTruthsGap) {
  const ClosedCube cube{0.1};
  const DrawnBody block = looking_like(about_centre_of_mass(l_block_mesh(0.02, 0.007)));
  for (int trial = 0; trial < 60; ++trial) {
    const Pose pose = drawn_pose();
    const int wall = trial % kWallCount;
    ASSERT_EQ(wall_gap_arcmin(block, pose, cube, wall, viewer_),
              measure_wall_truth(block, pose, cube, wall, viewer_).gap_arcmin)
        << "seed " << kSeed << ", trial " << trial;
  }
}

}  // namespace impetus::most_gap_test
