// What nodes know: occupancy, facing and group in closed form.
// SPDX-License-Identifier: MIT
#include "engine/trees/node_description.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/shapes/surface_distance.hpp"
#include "engine/trees/fit_error.hpp"
#include "tests/engine/one_of_each_kind.hpp"

namespace impetus::node_description_test {

constexpr std::uint64_t kSeed = 79;

/// The pieces of the mesh within a cube.
SurfacePart part_in(const TriangleMesh& mesh, const Vector3& centre, double half_m) {
  SurfacePart part = whole_surface(mesh);
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 along = Vector3::Unit(axis);
    part = cut(part, {along, centre[axis] - half_m}).first;
    part = cut(part, {-along, -centre[axis] - half_m}).first;
  }
  return part;
}

TEST(Occupancy, IsExactWhollyInsideAndWhollyOutside) {
  const SurfaceDistance cube(box_mesh({1.0, 1.0, 1.0}));
  EXPECT_EQ(occupancy_of(Sphere{{0.1, 0.0, 0.0}, 0.4}, cube), 1.0) << "touching from within";
  EXPECT_EQ(occupancy_of(Cube{{0.0, 0.0, 3.0}, 0.4}, cube), 0.0);
}

TEST(Occupancy, IsTheSharedVolumeOverTheNodes) {
  const SurfaceDistance cube(box_mesh({1.0, 1.0, 1.0}));
  const double round = 4.0 / 3.0 * std::numbers::pi * std::pow(0.75, 1.5);
  EXPECT_NEAR(occupancy_of(Sphere{Vector3::Zero(), std::sqrt(0.75)}, cube), 1.0 / round, 0.03);
  EXPECT_NEAR(occupancy_of(Sphere{{0.5, 0.0, 0.0}, 0.3}, cube), 0.5, 0.03);
  EXPECT_NEAR(occupancy_of(Cube{{0.5, 0.5, 0.5}, 0.3}, cube), 0.125, 0.03);
  EXPECT_NEAR(occupancy_of(Box{{0.5, 0.0, 0.0}, {0.4, 0.2, 0.1}}, cube), 0.5, 0.03);
  EXPECT_NEAR(occupancy_of(LineSwept{{0.0, 0.5, 0.0}, {0.2, 0.0, 0.0}, 0.1}, cube), 0.5, 0.03);
  EXPECT_NEAR(occupancy_of(Box{Vector3::Zero(), {1.0, 1.0, 1.0}}, cube), 0.125, 0.03);
}

TEST(Occupancy, EqualsBruteForceOverRandomPointsForEveryKind) {
  RandomStream random(kSeed, "brute force");
  const TriangleMesh mesh = about_centre_of_mass(l_block_mesh(1.0, 0.4));
  const SurfaceDistance solid(mesh);
  double squares = 0.0;
  int count = 0;
  for (int trial = 0; trial < 10; ++trial) {
    for (const Volume& volume : one_of_each_kind(random, random_in_cube(random, 0.4), 0.5)) {
      const Sphere bound = bounding_sphere(volume);
      int within = 0;
      int occupied = 0;
      while (within < 3'000) {
        const Vector3 point = bound.centre + random_in_cube(random, bound.radius_m);
        if (holds(volume, point)) {
          ++within;
          occupied += contains(mesh, point) ? 1 : 0;
        }
      }
      const double error = occupancy_of(volume, solid) - static_cast<double>(occupied) / within;
      EXPECT_LT(std::fabs(error), 0.06) << "seed " << kSeed << ", trial " << trial;
      squares += error * error;
      ++count;
    }
  }
  EXPECT_LT(std::sqrt(squares / count), 0.02) << "root mean square; .009 is the brute force's own";
}

TEST(DensityNormal, OfAPieceOfOneFaceIsTheFacesNormal) {
  const TriangleMesh mesh = box_mesh({1.0, 1.0, 1.0});
  const Vector3 normal = density_normal_of(part_in(mesh, {0.5, 0.1, 0.0}, 0.2));
  EXPECT_LT((normal - Vector3::UnitX()).norm(), 1e-12);
}

TEST(DensityNormal, AtACornerIsTheDiagonal) {
  const TriangleMesh mesh = box_mesh({1.0, 1.0, 1.0});
  const Vector3 normal = density_normal_of(part_in(mesh, {0.5, 0.5, 0.5}, 0.2));
  EXPECT_LT((normal - Vector3(1.0, 1.0, 1.0).normalized()).norm(), 1e-12);
}

TEST(DensityNormal, IsZeroWhereOppositeFacesCancelAndWithoutSurface) {
  const TriangleMesh plate = box_mesh({1.0, 1.0, 0.01});
  EXPECT_EQ(density_normal_of(part_in(plate, Vector3::Zero(), 0.2)), Vector3::Zero());
  EXPECT_EQ(density_normal_of(whole_surface(plate)), Vector3::Zero());
  EXPECT_EQ(density_normal_of({}), Vector3::Zero());
}

TEST(DensityNormal, AgreesWithCentralDifferencesOfTheOccupancy) {
  // ∇ρ ≈ (ρ(c + h e) − ρ(c − h e)) / 2h along x, y and z, of cubes about these points (eq. 4.8).
  const TriangleMesh mesh = icosphere_mesh(1.0, 4);
  const SurfaceDistance solid(mesh);
  RandomStream random(kSeed, "differences");
  for (int trial = 0; trial < 20; ++trial) {
    const double half_m = 0.15;
    const Vector3 centre = random_direction(random) * uniform_in(random, 0.95, 1.05);
    Vector3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3 step = half_m * Vector3::Unit(axis);
      gradient[axis] = (occupancy_of(Cube{centre + step, half_m}, solid) -
                        occupancy_of(Cube{centre - step, half_m}, solid)) /
                       (2.0 * half_m);
    }
    const Vector3 normal = density_normal_of(part_in(mesh, centre, half_m));
    EXPECT_GT(normal.dot(-gradient.normalized()), 0.98) << "seed " << kSeed << ", trial " << trial;
    EXPECT_GT(normal.dot(centre.normalized()), 0.98);
  }
}

TEST(NodeDescription, TheGroupIsThatOfMostOfTheSurface) {
  const TriangleMesh mesh = box_mesh({1.0, 1.0, 1.0});
  const NodeDescription description(mesh);
  const Cube node{{0.5, 0.45, 0.0}, 0.2};
  const std::int32_t on_x = description.of(node, part_in(mesh, {0.5, 0.0, 0.0}, 0.2)).group;
  const std::int32_t on_y = description.of(node, part_in(mesh, {0.0, 0.5, 0.0}, 0.2)).group;
  EXPECT_NE(on_x, on_y);
  EXPECT_EQ(description.of(node, part_in(mesh, {0.5, 0.4, 0.0}, 0.2)).group, on_x);
  EXPECT_EQ(description.of(node, part_in(mesh, {0.4, 0.5, 0.0}, 0.2)).group, on_y);
  EXPECT_EQ(description.of(node, {}).group, kNoGroup);
}

TEST(NodeDescription, TheFitErrorIsRoundedUp) {
  const TriangleMesh mesh = box_mesh({1.0, 1.0, 1.0});
  const NodeDescription description(mesh);
  RandomStream random(kSeed, "rounded");
  for (const Volume& volume : one_of_each_kind(random, {0.4, 0.1, 0.0}, 0.5)) {
    const double error_m = fit_error_m(volume, description.distance());
    const auto stated =
        static_cast<double>(description.of(volume, whole_surface(mesh)).fit_error_m);
    EXPECT_GE(stated, error_m);
    EXPECT_LE(stated, error_m * (1.0 + 1e-6));
  }
}

}  // namespace impetus::node_description_test
