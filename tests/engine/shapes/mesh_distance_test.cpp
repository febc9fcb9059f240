// The exact oracle against other oracles: separating axes, projections in turn, known gaps.
// SPDX-License-Identifier: MIT
#include "engine/shapes/mesh_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/shapes/surface_distance.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/mesh_oracles.hpp"

namespace impetus::mesh_distance_test {

constexpr std::uint64_t kSeed = 608;

Pose at_place(double x, double y, double z) { return {Vector3(x, y, z), Quaternion::Identity()}; }

Triangle random_triangle(RandomStream& random, const Vector3& about) {
  return {about + random_in_cube(random, 1.0), about + random_in_cube(random, 1.0),
          about + random_in_cube(random, 1.0)};
}

/// The distance of two convex sets by projecting on each in turn, which converges to it from above
/// (Cheney and Goldstein 1959).
double distance_by_projections(const Triangle& a, const Triangle& b) {
  Vector3 p = a[0];
  Vector3 q = b[0];
  for (int round = 0; round < 20'000; ++round) {
    q = closest_on_triangle(b, p);
    p = closest_on_triangle(a, q);
  }
  return (p - q).norm();
}

Vector3 point_of(const Triangle& triangle, double u, double v) {
  return triangle[0] + u * (triangle[1] - triangle[0]) + v * (triangle[2] - triangle[0]);
}

TEST(ClosestOnTriangle, IsOnTheTriangleAndNoPointOfItIsCloser) {
  RandomStream random(kSeed, "point and triangle");
  for (int trial = 0; trial < 2'000; ++trial) {
    const Triangle triangle = random_triangle(random, Vector3::Zero());
    const Vector3 point = random_in_cube(random, 3.0);
    const Vector3 closest = closest_on_triangle(triangle, point);
    // In a convex set the closest point c is the one with (p − c)·(x − c) ≤ 0 for all corners x.
    for (const Vector3& corner : triangle) {
      ASSERT_LE((point - closest).dot(corner - closest), 1e-12) << trial;
    }
    const Vector3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    ASSERT_NEAR(normal.dot(closest - triangle[0]), 0.0, 1e-12) << "in the plane";
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 edge = triangle[(i + 1) % 3] - triangle[i];
      ASSERT_GE(normal.dot(edge.cross(closest - triangle[i])), -1e-12) << "within the edges";
    }
  }
}

TEST(SegmentDistance, CrossesBesideParallelAndEndToEnd) {
  const auto gap = [](const Vector3& a0, const Vector3& a1, const Vector3& b0, const Vector3& b1) {
    return segment_distance(a0, a1, b0, b1).distance_m;
  };
  EXPECT_EQ(gap({-1, 0, 0}, {1, 0, 0}, {0, -1, 2}, {0, 1, 2}), 2.0) << "crossing, 2 above";
  EXPECT_EQ(gap({0, 0, 0}, {1, 0, 0}, {0.5, 3, 0}, {9, 3, 0}), 3.0) << "parallel";
  EXPECT_EQ(gap({0, 0, 0}, {1, 0, 0}, {4, 4, 0}, {9, 4, 0}), 5.0) << "parallel, past the end";
  EXPECT_EQ(gap({0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 0, 0}), 1.0) << "in line";
  EXPECT_EQ(gap({0, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 2, 0}), 1.0) << "a point";
}

TEST(TriangleDistance, AgreesWithProjectionsInTurn) {
  RandomStream random(kSeed, "triangles");
  int apart = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const Triangle a = random_triangle(random, Vector3::Zero());
    const Triangle b = random_triangle(random, random_in_cube(random, 2.0));
    const ClosestPoints found = triangle_distance(a, b);
    // The projections converge slowly where the triangles nearly touch.
    ASSERT_NEAR(found.distance_m, distance_by_projections(a, b), 1e-3) << trial;
    ASSERT_LE(found.distance_m, distance_by_projections(a, b) + 1e-12) << trial;
    ASSERT_NEAR((found.on_a - found.on_b).norm(), found.distance_m, 1e-12);
    ASSERT_LT((closest_on_triangle(a, found.on_a) - found.on_a).norm(), 1e-12);
    ASSERT_LT((closest_on_triangle(b, found.on_b) - found.on_b).norm(), 1e-12);
    apart += found.distance_m > 0.0 ? 1 : 0;
  }
  EXPECT_GT(apart, 50);
  EXPECT_LT(apart, 150);
}

TEST(TriangleDistance, CrossingIsDistanceZeroAtACommonPoint) {
  RandomStream random(kSeed, "crossing triangles");
  int crossing = 0;
  for (int trial = 0; trial < 5'000; ++trial) {
    const Triangle a = random_triangle(random, Vector3::Zero());
    const Triangle b = random_triangle(random, random_in_cube(random, 1.0));
    const ClosestPoints found = triangle_distance(a, b);
    ASSERT_EQ(triangles_cross(a, b), triangles_cross(b, a));
    ASSERT_EQ(triangles_cross(a, b), found.distance_m == 0.0) << trial;
    crossing += found.distance_m == 0.0 ? 1 : 0;
    if (found.distance_m > 0.0) {
      for (int sample = 0; sample < 20; ++sample) {
        const double u = random.uniform();
        const double s = random.uniform();
        const Vector3 p = point_of(a, u, (1.0 - u) * random.uniform());
        const Vector3 q = point_of(b, s, (1.0 - s) * random.uniform());
        ASSERT_GE((p - q).norm(), found.distance_m - 1e-14);
      }
    }
  }
  EXPECT_GT(crossing, 300);
}

/// Half the box's extent along `axis`.
double half_extent(const Vector3& sides, const Quaternion& turn, const Vector3& axis) {
  const Matrix3 rotation = turn.toRotationMatrix();
  double sum = 0.0;
  for (int side = 0; side < 3; ++side) {
    sum += 0.5 * sides[side] * std::fabs(axis.dot(rotation.col(side)));
  }
  return sum;
}

/// The largest gap over the 15 axes that can separate two boxes (Gottschalk 1996).
double widest_gap(const Vector3& sides, const Pose& a, const Pose& b) {
  std::vector<Vector3> axes;
  const Matrix3 of_a = a.orientation.toRotationMatrix();
  const Matrix3 of_b = b.orientation.toRotationMatrix();
  for (int i = 0; i < 3; ++i) {
    axes.push_back(of_a.col(i));
    axes.push_back(of_b.col(i));
    for (int j = 0; j < 3; ++j) {
      axes.push_back(of_a.col(i).cross(of_b.col(j)).normalized());
    }
  }
  double widest = -1e9;
  for (const Vector3& axis : axes) {
    const double gap = std::fabs(axis.dot(a.position - b.position)) -
                       half_extent(sides, a.orientation, axis) -
                       half_extent(sides, b.orientation, axis);
    widest = std::max(widest, gap);
  }
  return widest;
}

TEST(Intersects, AgreesWithTheSeparatingAxesOfTwoBoxes) {
  RandomStream random(kSeed, "boxes");
  const Vector3 sides(1.0, 0.6, 0.4);
  const TriangleMesh mesh = box_mesh(sides);
  int met = 0;
  for (int trial = 0; trial < 5'000; ++trial) {
    const Pose a{random_in_cube(random, 0.5), random_turn(random)};
    const Pose b{random_in_cube(random, 0.5), random_turn(random)};
    const double gap = widest_gap(sides, a, b);
    if (std::fabs(gap) < 1e-9) {
      continue;
    }
    const bool overlap = gap < 0.0;
    // Equal boxes never hold each other, so overlapping solids have crossing surfaces.
    ASSERT_EQ(intersects(mesh, a, mesh, b), overlap) << trial;
    const ClosestPoints closest = mesh_distance(mesh, a, mesh, b);
    ASSERT_EQ(closest.distance_m == 0.0, overlap) << trial;
    ASSERT_GE(closest.distance_m, gap - 1e-12) << "never below the gap along an axis";
    met += overlap ? 1 : 0;
  }
  EXPECT_GT(met, 500);
  EXPECT_LT(met, 4'500);
}

TEST(MeshDistance, OfBoxesFaceToFaceEdgeToEdgeAndCornerToCorner) {
  const TriangleMesh cube = box_mesh({2.0, 2.0, 2.0});
  EXPECT_EQ(mesh_distance(cube, {}, cube, at_place(5.0, 0.5, 0.25)).distance_m, 3.0);
  EXPECT_EQ(mesh_distance(cube, {}, cube, at_place(5.0, 6.0, 0.5)).distance_m, 5.0);
  EXPECT_NEAR(mesh_distance(cube, {}, cube, at_place(3.0, 4.0, 4.0)).distance_m, 3.0, 1e-15);
  const ClosestPoints corners = mesh_distance(cube, {}, cube, at_place(3.0, 4.0, 4.0));
  EXPECT_EQ(corners.on_a, Vector3(1.0, 1.0, 1.0));
  EXPECT_EQ(corners.on_b, Vector3(2.0, 3.0, 3.0));
}

TEST(MeshDistance, SeesIntoTheNotchOfAnLBlock) {
  // A small cube in the notch, 0.3 from both inner faces: far less than from any bounding volume.
  const TriangleMesh block = l_block_mesh(2.0, 0.7);
  const TriangleMesh cube = box_mesh({0.2, 0.2, 0.2});
  EXPECT_NEAR(mesh_distance(block, {}, cube, at_place(1.1, 1.1, 0.0)).distance_m, 0.3, 1e-15);
  EXPECT_FALSE(intersects(block, {}, cube, at_place(1.1, 1.1, 0.0)));
  EXPECT_TRUE(intersects(block, {}, cube, at_place(0.75, 1.1, 0.0)));
  EXPECT_FALSE(intersects(block, {}, cube, at_place(0.35, 0.35, 0.0))) << "inside, nothing crosses";
}

TEST(MeshDistance, PointsLieOnBothSurfacesAndNoVerticesAreCloser) {
  RandomStream random(kSeed, "meshes");
  const TriangleMesh block = small_l_block();
  const TriangleMesh ball = icosphere_mesh(0.05, 1);
  for (int trial = 0; trial < 200; ++trial) {
    const Pose a{random_in_cube(random, 0.05), random_turn(random)};
    const Pose b{0.3 * random_direction(random), random_turn(random)};
    const ClosestPoints found = mesh_distance(block, a, ball, b);
    ASSERT_GT(found.distance_m, 0.0);
    ASSERT_NEAR((found.on_a - found.on_b).norm(), found.distance_m, 1e-15);
    const Vector3 in_block = a.orientation.conjugate() * (found.on_a - a.position);
    const Vector3 in_ball = b.orientation.conjugate() * (found.on_b - b.position);
    ASSERT_LT(distance_to_surface(block, in_block), 1e-15);
    ASSERT_LT(distance_to_surface(ball, in_ball), 1e-15);
    for (const Vector3& vertex : ball.vertices) {
      const Vector3 seen_from_a = a.orientation.conjugate() * (b.transform(vertex) - a.position);
      ASSERT_GE(distance_to_surface(block, seen_from_a), found.distance_m - 1e-15);
    }
  }
}

}  // namespace impetus::mesh_distance_test
