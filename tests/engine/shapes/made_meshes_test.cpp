// Meshes made in memory: closed, outward, of known volume and inertia.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/shapes/surface_distance.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/mesh_oracles.hpp"

namespace impetus::made_meshes_test {

TEST(BoxMesh, IsClosedWithTheMassOfABox) {
  const TriangleMesh mesh = box_mesh({0.2, 0.4, 0.6});
  EXPECT_TRUE(find_defects(mesh).none());
  EXPECT_EQ(mesh.triangles.size(), 12U);
  const MassProperties mass = solid_of(mesh, 1'000.0);
  EXPECT_NEAR(mass.mass_kg, 48.0, 48.0 * 1e-12);
  // m (b² + c²) / 12
  EXPECT_NEAR(mass.inertia(0, 0), 48.0 * (0.16 + 0.36) / 12.0, 1e-12);
  EXPECT_NEAR(mass.inertia(1, 1), 48.0 * (0.04 + 0.36) / 12.0, 1e-12);
  EXPECT_NEAR(mass.inertia(2, 2), 48.0 * (0.04 + 0.16) / 12.0, 1e-12);
}

TEST(LBlockMesh, IsClosedAndOfTwentyTriangles) {
  const TriangleMesh mesh = l_block_mesh(2.0, 0.7);
  EXPECT_TRUE(find_defects(mesh).none());
  EXPECT_EQ(mesh.triangles.size(), 20U);
  EXPECT_EQ(mesh.vertices.size(), 12U);
}

/// The closed form: the square plate of a × a less the square of (a − t)², both t thick.
MassProperties l_block_in_closed_form(double a, double t, double density) {
  const double plate = density * a * a * t;
  const double hole = density * (a - t) * (a - t) * t;
  const double plate_at = a / 2.0;
  const double hole_at = (a + t) / 2.0;
  MassProperties result;
  result.mass_kg = plate - hole;
  const double centre = (plate * plate_at - hole * hole_at) / result.mass_kg;
  result.centre = {centre, centre, 0.0};
  const double d_plate = plate_at - centre;
  const double d_hole = hole_at - centre;
  const double edge = a - t;
  const double xx = plate * ((a * a + t * t) / 12.0 + d_plate * d_plate) -
                    hole * ((edge * edge + t * t) / 12.0 + d_hole * d_hole);
  const double zz = plate * (a * a / 6.0 + 2.0 * d_plate * d_plate) -
                    hole * (edge * edge / 6.0 + 2.0 * d_hole * d_hole);
  const double xy = -(plate * d_plate * d_plate - hole * d_hole * d_hole);
  result.inertia << xx, xy, 0.0, xy, xx, 0.0, 0.0, 0.0, zz;
  return result;
}

TEST(LBlockMesh, HasTheMassCentreAndInertiaOfItsClosedForm) {
  for (const auto& [arm, thickness] : {std::pair{2.0, 0.7}, {1.0, 0.1}, {0.3, 0.29}}) {
    const MassProperties found = solid_of(l_block_mesh(arm, thickness), 800.0);
    const MassProperties exact = l_block_in_closed_form(arm, thickness, 800.0);
    EXPECT_NEAR(found.mass_kg / exact.mass_kg, 1.0, 1e-12);
    EXPECT_LT((found.centre - exact.centre).norm(), 1e-12);
    EXPECT_LT((found.inertia - exact.inertia).norm(), 1e-12 * exact.inertia.norm());
  }
}

TEST(AboutCentreOfMass, MovesTheCentreToTheOriginAndKeepsTheInertia) {
  const TriangleMesh mesh = l_block_mesh(2.0, 0.7);
  const MassProperties before = solid_of(mesh, 1.0);
  const MassProperties after = solid_of(about_centre_of_mass(mesh), 1.0);
  EXPECT_GT(before.centre.norm(), 0.5);
  EXPECT_LT(after.centre.norm(), 1e-15);
  EXPECT_LT((after.inertia - before.inertia).norm(), 1e-14);
}

TEST(IcosphereMesh, IsClosedWithItsVerticesOnTheSphere) {
  std::size_t triangles = 20;
  for (int subdivisions = 0; subdivisions <= 3; ++subdivisions, triangles *= 4) {
    const TriangleMesh mesh = icosphere_mesh(0.3, subdivisions);
    EXPECT_TRUE(find_defects(mesh).none()) << subdivisions;
    EXPECT_EQ(mesh.triangles.size(), triangles);
    for (const Vector3& vertex : mesh.vertices) {
      EXPECT_NEAR(vertex.norm(), 0.3, 1e-15);
    }
  }
}

TEST(IcosphereMesh, ApproachesTheSphereFromWithinByAFactorOfFourARound) {
  // The volume's error of an inscribed mesh goes with the square of its edges.
  const double exact = 4.0 / 3.0 * std::numbers::pi;
  double error = exact - solid_of(icosphere_mesh(1.0, 1), 1.0).volume_m3;
  for (int subdivisions = 2; subdivisions <= 5; ++subdivisions) {
    const double finer = exact - solid_of(icosphere_mesh(1.0, subdivisions), 1.0).volume_m3;
    EXPECT_GT(finer, 0.0);
    EXPECT_NEAR(error / finer, 4.0, 0.3) << subdivisions;
    error = finer;
  }
}

TEST(PointInSolid, AgreesWithTheInequalitiesOfAnLBlock) {
  RandomStream random(3, "points in an L");
  const TriangleMesh mesh = l_block_mesh(2.0, 0.7);
  int within = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    const Vector3 p(uniform_in(random, -0.5, 2.5), uniform_in(random, -0.5, 2.5),
                    uniform_in(random, -0.6, 0.6));
    const bool in_outline =
        p.x() > 0.0 && p.y() > 0.0 && p.x() < 2.0 && p.y() < 2.0 && (p.x() < 0.7 || p.y() < 0.7);
    const bool inside = in_outline && std::fabs(p.z()) < 0.35;
    ASSERT_EQ(contains(mesh, p), inside) << p.transpose();
    within += inside ? 1 : 0;
  }
  EXPECT_GT(within, 2'000);
}

TEST(PointInSolid, DistanceToTheSurfaceOfABoxIsThatOfItsNearestFace) {
  const TriangleMesh mesh = box_mesh({2.0, 2.0, 2.0});
  EXPECT_NEAR(distance_to_surface(mesh, {0.0, 0.0, 0.0}), 1.0, 1e-15);
  EXPECT_NEAR(distance_to_surface(mesh, {0.25, 0.7, -0.5}), 0.3, 1e-15);
  EXPECT_NEAR(distance_to_surface(mesh, {4.0, 5.0, 1.0}), 5.0, 1e-15) << "an edge";
  EXPECT_NEAR(distance_to_surface(mesh, {3.0, -2.0, 3.0}), 3.0, 1e-15) << "a corner";
}

}  // namespace impetus::made_meshes_test
