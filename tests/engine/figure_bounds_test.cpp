// The top bound of a figure, over poses.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/engine/figure_scenes.hpp"

namespace impetus::figure_bounds_test {

/// How far any part's bound reaches from the root's centre of mass.
double reach_of(const FigureScene& scene, const std::vector<Pose>& poses) {
  double reach = 0.0;
  for (std::size_t part = 0; part < poses.size(); ++part) {
    reach = std::max(reach, (poses[part].position - poses[0].position).norm() +
                                scene.models[part].tree->bounding_radius_m());
  }
  return reach;
}

TEST(FigureBounds, TheTopBoundHoldsOverAHundredThousandPosesWithinTheLimits) {
  RandomStream random(1, "poses");
  const FigureScene limbs = limbs_of_16();
  const double bound_m = top_bound_m(limbs.figure, limbs.models);
  double farthest = 0.0;
  for (int i = 0; i < 100'000; ++i) {
    const Pose root{random_in_cube(random, 1.0), random_turn(random)};
    farthest = std::max(farthest, reach_of(limbs, poses_of(limbs.figure, root,
                                                           random_angles(limbs.figure, random))));
  }
  EXPECT_LE(farthest, bound_m);
  EXPECT_GT(farthest, 0.75 * bound_m);  // and is no mere large number
}

TEST(FigureBounds, AStraightChainReachesIt) {
  const FigureScene chain = chain_of(8);
  const std::vector<Pose> poses = poses_of(chain.figure, {}, rest_angles(chain.figure));
  EXPECT_NEAR(reach_of(chain, poses), top_bound_m(chain.figure, chain.models), 1e-12);
}

TEST(FigureBounds, APartsOwnRadiusCountsWhereNothingReachesFurther) {
  const FigureScene alone = chain_of(1);
  EXPECT_EQ(top_bound_m(alone.figure, alone.models), alone.models[0].tree->bounding_radius_m());
}

}  // namespace impetus::figure_bounds_test
