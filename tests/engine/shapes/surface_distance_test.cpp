// Signed distance to a surface: equal to brute force, and its sign to the winding number.
// SPDX-License-Identifier: MIT
#include "engine/shapes/surface_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/shapes/solids/creature_mesh.hpp"
#include "engine/shapes/solids/ring_meshes.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/mesh_oracles.hpp"

namespace impetus::surface_distance_test {

constexpr std::uint64_t kSeed = 53;

TEST(SurfaceDistance, EqualsBruteForceAndHasTheSignOfTheWindingNumber) {
  RandomStream random(kSeed, "distance");
  const std::vector<TriangleMesh> solids{l_block_mesh(2.0, 0.7), knot_mesh(0.6, 0.14, 48, 6),
                                         creature_mesh(2.0, 16)};
  for (std::size_t solid = 0; solid < solids.size(); ++solid) {
    const TriangleMesh& mesh = solids[solid];
    const SurfaceDistance distance(mesh);
    int inside = 0;
    for (int trial = 0; trial < 1'000; ++trial) {
      const Vector3 point = random_in_cube(random, 1.2);
      const double expected_m = distance_to_surface(mesh, point);
      ASSERT_EQ(distance.nearest(point).distance_m, expected_m) << solid << ", trial " << trial;
      ASSERT_EQ(distance.signed_distance_m(point) < 0.0, contains(mesh, point))
          << "solid " << solid << ", seed " << kSeed << ", trial " << trial;
      ASSERT_EQ(std::fabs(distance.signed_distance_m(point)), expected_m);
      inside += contains(mesh, point) ? 1 : 0;
    }
    EXPECT_GT(inside, 10) << "solid " << solid;
  }
}

TEST(SurfaceDistance, ANearestPointLiesOnItsTriangle) {
  RandomStream random(kSeed, "nearest");
  const TriangleMesh mesh = creature_mesh(2.0, 16);
  const SurfaceDistance distance(mesh);
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3 point = random_in_cube(random, 1.2);
    const NearestOnSurface found = distance.nearest(point);
    const auto& [a, b, c] = mesh.triangles[found.triangle];
    const Triangle triangle{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    ASSERT_EQ(closest_on_triangle(triangle, point), found.point);
    ASSERT_EQ((point - found.point).norm(), found.distance_m);
  }
}

TEST(SurfaceDistance, TheSignHoldsBesideSharpEdgesAndCorners) {
  // Nearest to a corner whose faces disagree, the nearest face alone says the wrong side.
  const SurfaceDistance distance(l_block_mesh(2.0, 0.7));
  const TriangleMesh mesh = l_block_mesh(2.0, 0.7);
  RandomStream random(kSeed, "corners");
  for (const Vector3& vertex : mesh.vertices) {
    for (int trial = 0; trial < 200; ++trial) {
      const Vector3 point = vertex + 0.05 * random_direction(random);
      ASSERT_EQ(distance.signed_distance_m(point) < 0.0, contains(mesh, point));
    }
  }
}

}  // namespace impetus::surface_distance_test
