// The oracles of first touch, and of a ball and a mesh, against what is known by other means.
// SPDX-License-Identifier: MIT
#include "engine/shapes/mesh_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::ball_distance_test {

constexpr std::uint64_t kSeed = 8;

/// From the origin, about which the mesh is, to the facet that comes nearest to it.
double nearest_facet_m(const TriangleMesh& mesh) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3 closest = closest_on_triangle(
        {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, Vector3::Zero());
    nearest_m = std::min(nearest_m, closest.norm());
  }
  return nearest_m;
}

TEST(BallDistance, IsThatOfAFineMeshOfTheBallToWithinItsFacets) {
  const TriangleMesh solid = small_l_block();
  constexpr double kRadius_m = 0.05;
  const TriangleMesh ball_mesh = icosphere_mesh(kRadius_m, 3);
  const double facets_m = kRadius_m - nearest_facet_m(ball_mesh);
  RandomStream random(kSeed, "balls");
  for (int trial = 0; trial < 50; ++trial) {
    const Pose pose{random_in_cube(random, 0.1), random_turn(random)};
    const Vector3 centre = pose.position + 0.4 * random_direction(random);
    const ClosestPoints exact = ball_distance(solid, pose, centre, kRadius_m);
    const ClosestPoints faceted = mesh_distance(solid, pose, ball_mesh, {centre, {1, 0, 0, 0}});
    EXPECT_LE(exact.distance_m, faceted.distance_m + 1e-12) << "seed " << kSeed << ", " << trial;
    EXPECT_GE(exact.distance_m, faceted.distance_m - facets_m) << trial;
    EXPECT_NEAR((exact.on_a - exact.on_b).norm(), exact.distance_m, 1e-12);
    EXPECT_NEAR((exact.on_b - centre).norm(), kRadius_m, 1e-12);
  }
}

TEST(BallDistance, IsNothingWhereTheBallReachesTheSurface) {
  const TriangleMesh box = box_mesh({1.0, 1.0, 1.0});
  EXPECT_EQ(ball_distance(box, {}, {0.9, 0.0, 0.0}, 0.41).distance_m, 0.0);
  EXPECT_NEAR(ball_distance(box, {}, {0.9, 0.0, 0.0}, 0.39).distance_m, 0.01, 1e-12);
}

TEST(FirstTouch, OfBoxesThatMoveAtEachOtherIsTheirGap) {
  const TriangleMesh box = box_mesh({1.0, 1.0, 1.0});
  const auto at = [&](double way_m) {
    return mesh_distance(box, {{way_m, 0.1, 0.2}, {1, 0, 0, 0}}, box, {{3.0, 0, 0}, {1, 0, 0, 0}});
  };
  constexpr double kGap_m = 1e-6;
  const auto found = first_touch(at, kGap_m, 10.0);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->way_m, 2.0, kGap_m);
  EXPECT_GE(found->closest.distance_m, 0.5 * kGap_m * (1.0 - 1e-6));
  EXPECT_LE(found->closest.distance_m, kGap_m);
}

TEST(FirstTouch, IsNoneOfWhatPassesByOrIsTooFarOrCrossesAtTheStart) {
  const TriangleMesh box = box_mesh({1.0, 1.0, 1.0});
  const auto way_of = [&](double aside_m, double start_m, double farthest_m) {
    return first_touch(
               [&](double way_m) {
                 return mesh_distance(box, {{start_m + way_m, aside_m, 0}, {1, 0, 0, 0}}, box, {});
               },
               1e-6, farthest_m)
        .has_value();
  };
  EXPECT_TRUE(way_of(0.5, -3.0, 10.0));
  EXPECT_FALSE(way_of(1.1, -3.0, 10.0));
  EXPECT_FALSE(way_of(0.5, -3.0, 1.9));
  EXPECT_FALSE(way_of(0.5, -0.3, 10.0));
}

}  // namespace impetus::ball_distance_test
