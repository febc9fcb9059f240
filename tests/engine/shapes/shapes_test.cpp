// Shapes: spheres that touch, solids of known mass, and surfaces that are none.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/triangle_mesh.hpp"
#include "engine/volumes/sphere.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::shapes_test {

/// A box as a closed mesh of 12 outward triangles, centred at `centre`.
TriangleMesh box(const Vector3& centre, const Vector3& sides) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 signs(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
    mesh.vertices.push_back(centre + signs.cwiseProduct(sides));
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriangleMesh cube(double side_m) { return box(Vector3::Zero(), Vector3::Constant(side_m)); }

/// `mesh` with the surface of `cavity` turned inwards.
TriangleMesh hollowed(TriangleMesh mesh, const TriangleMesh& cavity) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), cavity.vertices.begin(), cavity.vertices.end());
  for (const auto& triangle : cavity.triangles) {
    mesh.triangles.push_back({first + triangle[0], first + triangle[2], first + triangle[1]});
  }
  return mesh;
}

TriangleMesh moved_mesh(TriangleMesh mesh, const Vector3& offset) {
  for (Vector3& vertex : mesh.vertices) {
    vertex += offset;
  }
  return mesh;
}

/// The example of Tonon 2004.
TriangleMesh tonon_tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices = {{8.3322, -11.86875, 0.93355},
                   {0.75523, 5.0, 16.37072},
                   {52.61236, 5.0, -5.3858},
                   {2.0, 5.0, 3.0}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

TEST(Sphere, OverlapsWhenTheCentresAreNearerThanTheRadii) {
  const Sphere a{{0.0, 0.0, 0.0}, 0.5};
  EXPECT_TRUE(overlap(a, {{0.75, 0.0, 0.0}, 0.5}));
  EXPECT_TRUE(overlap(a, {{1.0, 0.0, 0.0}, 0.5})) << "touching counts";
  EXPECT_FALSE(overlap(a, {{std::nextafter(1.0, 2.0), 0.0, 0.0}, 0.5}));
  EXPECT_TRUE(overlap(a, a)) << "coincident";
  EXPECT_TRUE(overlap(a, {{0.1, 0.0, 0.0}, 0.0})) << "a point inside";
}

TEST(Sphere, ANotFiniteSphereOverlapsNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(overlap({{nan, 0.0, 0.0}, 0.5}, {{0.0, 0.0, 0.0}, 0.5}));
}

TEST(Sphere, NormalRunsFromBToAAndDepthIsTheOverlap) {
  const TouchPoint at = touch({{3.0, 0.0, 0.0}, 2.0}, {{0.0, 0.0, 0.0}, 1.5}, Vector3::UnitZ());
  EXPECT_EQ(at.normal, Vector3::UnitX());
  EXPECT_EQ(at.depth_m, 0.5);
  // p = (R_b c_a + R_a c_b) / (R_a + R_b)
  EXPECT_DOUBLE_EQ(at.point.x(), 1.5 * 3.0 / 3.5);
}

TEST(Sphere, TangentSpheresTouchInTheTangentPoint) {
  const TouchPoint at = touch({{0.0, 4.0, 0.0}, 1.0}, {{0.0, 0.0, 0.0}, 3.0}, Vector3::UnitZ());
  EXPECT_EQ(at.point, Vector3(0.0, 3.0, 0.0));
  EXPECT_EQ(at.depth_m, 0.0);
}

TEST(Sphere, SeparateSpheresHaveNegativeDepth) {
  const TouchPoint at = touch({{0.0, 4.0, 0.0}, 1.0}, {{0.0, 0.0, 0.0}, 1.0}, Vector3::UnitZ());
  EXPECT_EQ(at.depth_m, -2.0);
}

TEST(Sphere, CoincidentCentresUseTheFallback) {
  const Sphere ball{{1.0, 2.0, 3.0}, 0.5};
  const TouchPoint at = touch(ball, ball, Vector3::UnitY());
  EXPECT_EQ(at.normal, Vector3::UnitY());
  EXPECT_EQ(at.point, ball.centre);
  EXPECT_EQ(at.depth_m, 1.0);
  const Sphere point{{1.0, 2.0, 3.0}, 0.0};
  EXPECT_EQ(touch(point, point, Vector3::UnitY()).point, point.centre);
}

TEST(Sphere, SwappingTheSpheresTurnsTheNormalAndKeepsThePoint) {
  RandomStream random(11, "touch");
  for (int i = 0; i < 1'000; ++i) {
    const Sphere a{random_in_cube(random, 1.0), uniform_in(random, 0.0, 1.0)};
    const Sphere b{random_in_cube(random, 1.0), uniform_in(random, 0.1, 1.0)};
    const TouchPoint ab = touch(a, b, Vector3::UnitX());
    const TouchPoint ba = touch(b, a, Vector3::UnitX());
    ASSERT_EQ(ab.normal, Vector3(-ba.normal));
    ASSERT_EQ(ab.point, ba.point);
    ASSERT_EQ(ab.depth_m, ba.depth_m);
  }
}

TEST(SolidSphere, HasTheTextbookMassAndInertia) {
  const MassProperties solid = solid_sphere(0.3, 1200.0);
  const double volume_m3 = 4.0 / 3.0 * std::numbers::pi * 0.027;
  EXPECT_NEAR(solid.volume_m3, volume_m3, 1e-15);
  EXPECT_NEAR(solid.mass_kg, 1200.0 * volume_m3, 1e-12);
  EXPECT_NEAR(solid.inertia(1, 1), 0.4 * 1200.0 * volume_m3 * 0.09, 1e-12);
  EXPECT_EQ(solid.inertia(0, 1), 0.0);
  EXPECT_EQ(solid.centre, Vector3::Zero());
}

TEST(SolidOf, ACubeHasASixthOfItsMassTimesItsSideSquared) {
  const MassProperties solid = solid_of(cube(2.0), 3.0);
  EXPECT_NEAR(solid.volume_m3, 8.0, 1e-14);
  EXPECT_NEAR(solid.mass_kg, 24.0, 1e-13);
  EXPECT_LT(solid.centre.norm(), 1e-15);
  // m s² / 6; a dozen roundings of numbers below 100
  EXPECT_LT((solid.inertia - Matrix3::Identity() * (24.0 * 4.0 / 6.0)).norm(), 1e-13);
}

TEST(SolidOf, AHollowCubeIsTheDifferenceOfTwoBoxes) {
  const Vector3 sides(0.8, 0.8, 0.9);
  const TriangleMesh mesh = hollowed(cube(1.0), box(Vector3::Zero(), sides));
  ASSERT_TRUE(find_defects(mesh).none());
  const MassProperties solid = solid_of(mesh, 1.0);
  // m (b² + c²) / 12 of each box
  const double cavity_kg = 0.8 * 0.8 * 0.9;
  const double across = (1.0 + 1.0) / 12.0 - cavity_kg * (0.64 + 0.81) / 12.0;
  const double along = (1.0 + 1.0) / 12.0 - cavity_kg * (0.64 + 0.64) / 12.0;
  EXPECT_NEAR(solid.mass_kg, 1.0 - cavity_kg, 1e-15);
  EXPECT_LT((solid.inertia.diagonal() - Vector3(across, across, along)).norm(), 1e-15);
  EXPECT_LT(solid.centre.norm(), 1e-15);
}

/// Centre of mass, then inertia xx, yy, zz, xy, xz, yz at density 1.
struct Known {
  Vector3 centre;
  std::array<double, 6> inertia;
};

/// From the printed vertices by rational arithmetic (second moments V/20 Σ p pᵀ about the
/// centroid).
const Known kTononExact{{15.9249475, 0.7828125, 3.7296175},
                        {43520.3332853933, 194711.2925907936, 191168.76488607793,
                         -11996.20139323408, 46343.16738139439, -4417.661569685615}};

/// As published. Its vertices are printed with one digit too few: the mean of their x is
/// 15.9249475, not 15.92492.
const Known kTononPublished{
    {15.92492, 0.78281, 3.72962},
    {43520.33257, 194711.28938, 191168.76173, -11996.20119, 46343.16662, -4417.6615}};

/// Tolerances relative to the largest number of their kind.
void expect_known(const MassProperties& solid, const Known& known, double relative) {
  EXPECT_LT((solid.centre - known.centre).norm(), relative * 16.0);
  const Matrix3& inertia = solid.inertia;
  const std::array<double, 6> values{inertia(0, 0), inertia(1, 1), inertia(2, 2),
                                     inertia(0, 1), inertia(0, 2), inertia(1, 2)};
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(values[i], known.inertia[i], relative * 194711.0) << "number " << i;
  }
  EXPECT_EQ(inertia, Matrix3(inertia.transpose()));
}

TEST(SolidOf, TononsTetrahedronHasItsExactInertia) {
  ASSERT_TRUE(find_defects(tonon_tetrahedron()).none());
  // A few hundred roundings of the largest number.
  expect_known(solid_of(tonon_tetrahedron(), 1.0), kTononExact, /*relative=*/1e-14);
}

TEST(SolidOf, TononsTetrahedronHasThePublishedInertiaAsFarAsItsVerticesArePrinted) {
  // 2.75e-5 in 15.9 (see kTononPublished).
  expect_known(solid_of(tonon_tetrahedron(), 1.0), kTononPublished, /*relative=*/2e-6);
}

TEST(SolidOf, TononsTetrahedronAMillionDiametersAwayLosesOnlyWhatItsCoordinatesLost) {
  // Diameter about 55: coordinates near 5.5e7 are rounded by 4e-9, 1e-10 of the diameter; inertia
  // grows with the fifth power of length.
  const Vector3 offset(5.5e7, -5.5e7, 5.5e7);
  MassProperties solid = solid_of(moved_mesh(tonon_tetrahedron(), offset), 1.0);
  solid.centre -= offset;
  expect_known(solid, kTononExact, /*relative=*/1e-9);
}

TEST(SolidOf, ACubeWithExactCoordinatesIsTheSameAnywhere) {
  const Vector3 offset(0x1p21, -0x1p22, 0x1p20);
  const MassProperties near = solid_of(cube(2.0), 1.0);
  const MassProperties far = solid_of(moved_mesh(cube(2.0), offset), 1.0);
  EXPECT_EQ(far.mass_kg, near.mass_kg);
  EXPECT_EQ(far.inertia, near.inertia);
  EXPECT_EQ(far.centre, offset + near.centre);
}

TEST(SolidOf, InsideOutMeansNegativeVolume) {
  TriangleMesh mesh = cube(1.0);
  for (auto& triangle : mesh.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  EXPECT_TRUE(find_defects(mesh).none());
  EXPECT_NEAR(solid_of(mesh, 1.0).volume_m3, -1.0, 1e-15);
}

TEST(SolidOf, NoTrianglesIsNoMass) { EXPECT_EQ(solid_of({}, 1.0).mass_kg, 0.0); }

TEST(FindDefects, AClosedCubeHasNone) { EXPECT_TRUE(find_defects(cube(1.0)).none()); }

TEST(FindDefects, AMissingTriangleOpensThreeEdges) {
  TriangleMesh mesh = cube(1.0);
  mesh.triangles.pop_back();
  const MeshDefects defects = find_defects(mesh);
  EXPECT_EQ(defects.open_edges, 3);
  EXPECT_EQ(defects.misoriented_edges, 0);
  EXPECT_FALSE(defects.none());
}

TEST(FindDefects, ATurnedTriangleMisorientsThreeEdges) {
  TriangleMesh mesh = cube(1.0);
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  const MeshDefects defects = find_defects(mesh);
  EXPECT_EQ(defects.misoriented_edges, 3);
  EXPECT_EQ(defects.open_edges, 0);
}

TEST(FindDefects, ADoubledTriangleCrowdsThreeEdges) {
  TriangleMesh mesh = cube(1.0);
  mesh.triangles.push_back(mesh.triangles.front());
  EXPECT_EQ(find_defects(mesh).crowded_edges, 3);
}

TEST(FindDefects, ATriangleWithoutAreaIsDegenerate) {
  TriangleMesh mesh = cube(1.0);
  mesh.vertices.push_back(0.5 * (mesh.vertices[0] + mesh.vertices[1]));
  mesh.triangles.push_back({0, 1, 8});
  mesh.triangles.push_back({2, 2, 3});
  EXPECT_EQ(find_defects(mesh).degenerate_triangles, 2);
}

TEST(FindDefects, AVertexThatIsNotFiniteIsBad) {
  TriangleMesh mesh = cube(1.0);
  mesh.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
  mesh.vertices[5].z() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(find_defects(mesh).bad_vertices, 2);
}

TEST(FindDefects, ATriangleOfAVertexThatThereIsNotIsCountedAndNotRead) {
  TriangleMesh mesh = cube(1.0);
  mesh.triangles.push_back({0, 1, 8});
  mesh.triangles.push_back({0, 1, std::numeric_limits<std::uint32_t>::max()});
  const MeshDefects defects = find_defects(mesh);
  EXPECT_EQ(defects.unknown_vertices, 2);
  EXPECT_EQ(defects.crowded_edges + defects.open_edges + defects.degenerate_triangles, 0);
  EXPECT_FALSE(defects.none());
}

}  // namespace impetus::shapes_test
