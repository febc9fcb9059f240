// Mass properties of polyhedra against closed forms, at home and a million diameters away.
// SPDX-License-Identifier: MIT
#include "engine/shapes/mass_properties.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/shapes/solids/block_meshes.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/split_flat.hpp"

namespace impetus::mass_properties_test {

constexpr std::uint64_t kSeed = 83;

struct KnownSolid {
  std::string name;
  TriangleMesh mesh;
  double volume_m3;
  Vector3 centre;
  Matrix3 inertia;  ///< about the centre, at density 1
};

Matrix3 diagonal(double xx, double yy, double zz) { return Vector3(xx, yy, zz).asDiagonal(); }

TriangleMesh moved_mesh(TriangleMesh mesh, const Vector3& way) {
  for (Vector3& vertex : mesh.vertices) {
    vertex += way;
  }
  return mesh;
}

/// Of semi-axis a: the eight faces of |x| + |y| + |z| = a.
TriangleMesh octahedron(double a) {
  TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    mesh.vertices.emplace_back(a * Vector3::Unit(axis));
    mesh.vertices.emplace_back(-a * Vector3::Unit(axis));
  }
  for (std::uint32_t x : {0U, 1U}) {
    for (std::uint32_t y : {2U, 3U}) {
      for (std::uint32_t z : {4U, 5U}) {
        const bool even = (x + y + z) % 2 == 0;
        mesh.triangles.push_back(even ? std::array{x, y, z} : std::array{y, x, z});
      }
    }
  }
  return mesh;
}

/// The right triangle (0,0), (a,0), (0,b), from z = 0 to h.
TriangleMesh prism(double a, double b, double h) {
  return {{{0.0, 0.0, 0.0}, {a, 0.0, 0.0}, {0.0, b, 0.0}, {0.0, 0.0, h}, {a, 0.0, h}, {0.0, b, h}},
          {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}}};
}

/// Tonon's tetrahedron: the printed vertices; volume by their determinant, the rest by
/// rational arithmetic.
TriangleMesh tetrahedron() {
  return {{{8.3322, -11.86875, 0.93355},
           {0.75523, 5.0, 16.37072},
           {52.61236, 5.0, -5.3858},
           {2.0, 5.0, 3.0}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

/// The outer cube's surface with a cavity's, turned inwards.
TriangleMesh hollow_cube() {
  TriangleMesh mesh = box_mesh({1.0, 1.0, 1.0});
  const TriangleMesh cavity = box_mesh({0.8, 0.8, 0.9});
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), cavity.vertices.begin(), cavity.vertices.end());
  for (const auto& [a, b, c] : cavity.triangles) {
    mesh.triangles.push_back({first + a, first + c, first + b});
  }
  return mesh;
}

/// The square a × a less the square of (a − t)², t thick, from the inner corner.
KnownSolid l_block(double a, double t) {
  const double plate = a * a * t;
  const double hole = (a - t) * (a - t) * t;
  const double volume = t * t * (2.0 * a - t);
  const double centre = (plate * a / 2.0 - hole * (a + t) / 2.0) / volume;
  const double d_plate = a / 2.0 - centre;
  const double d_hole = (a + t) / 2.0 - centre;
  const double edge = a - t;
  const double xx = plate * ((a * a + t * t) / 12.0 + d_plate * d_plate) -
                    hole * ((edge * edge + t * t) / 12.0 + d_hole * d_hole);
  const double zz = plate * (a * a / 6.0 + 2.0 * d_plate * d_plate) -
                    hole * (edge * edge / 6.0 + 2.0 * d_hole * d_hole);
  const double xy = hole * d_hole * d_hole - plate * d_plate * d_plate;
  Matrix3 inertia = diagonal(xx, xx, zz);
  inertia(0, 1) = xy;
  inertia(1, 0) = xy;
  return {"L-block", l_block_mesh(a, t), volume, {centre, centre, 0.0}, inertia};
}

std::vector<KnownSolid> known_solids() {
  std::vector<KnownSolid> solids;
  // m s²/6
  solids.push_back({"cube", box_mesh({2.0, 2.0, 2.0}), 8.0, Vector3::Zero(),
                    Matrix3::Identity() * (8.0 * 4.0 / 6.0)});
  // m (b² + c²)/12
  solids.push_back({"box", box_mesh({2.0, 0.5, 0.25}), 0.25, Vector3::Zero(),
                    0.25 / 12.0 * diagonal(0.3125, 4.0625, 4.25)});
  solids.push_back({"needle", box_mesh({16384.0, 1.0, 1.0}), 16384.0, Vector3::Zero(),
                    16384.0 / 12.0 * diagonal(2.0, 268435457.0, 268435457.0)});
  solids.push_back(l_block(2.0, 0.5));
  // V = 4/3 a³, I = m a²/5 (Σ x² over it is m a²/10 along each axis)
  solids.push_back({"octahedron", octahedron(1.5), 4.5, Vector3::Zero(),
                    Matrix3::Identity() * (4.5 * 2.25 / 5.0)});
  // About the centroid Σx² = m a²/18, Σy² = m b²/18, Σxy = −m ab/36, Σz² = m h²/12.
  const double m = 3.0 * 2.0 / 2.0 * 1.5;
  Matrix3 inertia = m * diagonal(4.0 / 18.0 + 2.25 / 12.0, 9.0 / 18.0 + 2.25 / 12.0, 13.0 / 18.0);
  inertia(0, 1) = m * 6.0 / 36.0;
  inertia(1, 0) = m * 6.0 / 36.0;
  solids.push_back({"prism", prism(3.0, 2.0, 1.5), m, {1.0, 2.0 / 3.0, 0.75}, inertia});
  const double cavity = 0.8 * 0.8 * 0.9;
  const double across = 1.0 / 6.0 - cavity * (0.64 + 0.81) / 12.0;
  const double along = 1.0 / 6.0 - cavity * 1.28 / 12.0;
  solids.push_back({"hollow cube", hollow_cube(), 1.0 - cavity, Vector3::Zero(),
                    diagonal(across, across, along)});
  Matrix3 tonon = diagonal(43520.3332853933, 194711.2925907936, 191168.76488607793);
  tonon(0, 1) = tonon(1, 0) = -11996.20139323408;
  tonon(0, 2) = tonon(2, 0) = 46343.16738139439;
  tonon(1, 2) = tonon(2, 1) = -4417.661569685615;
  const TriangleMesh tetra = tetrahedron();
  const Vector3 to_1 = tetra.vertices[1] - tetra.vertices[0];
  const Vector3 to_2 = tetra.vertices[2] - tetra.vertices[0];
  const Vector3 to_3 = tetra.vertices[3] - tetra.vertices[0];
  solids.push_back({"Tonon's tetrahedron",
                    tetra,
                    std::fabs(to_1.dot(to_2.cross(to_3))) / 6.0,
                    {15.9249475, 0.7828125, 3.7296175},
                    tonon});
  return solids;
}

double diameter_m(const TriangleMesh& mesh) {
  double greatest = 0.0;
  for (const Vector3& a : mesh.vertices) {
    for (const Vector3& b : mesh.vertices) {
      greatest = std::max(greatest, (a - b).norm());
    }
  }
  return greatest;
}

/// `relative` to the volume, the diameter and the greatest number of the inertia.
void expect_known(const KnownSolid& known, const MassProperties& found, double relative) {
  EXPECT_NEAR(found.volume_m3 / known.volume_m3, 1.0, relative) << known.name;
  EXPECT_LE((found.centre - known.centre).norm(), relative * diameter_m(known.mesh)) << known.name;
  const double greatest = known.inertia.cwiseAbs().maxCoeff();
  EXPECT_LE((found.inertia - known.inertia).cwiseAbs().maxCoeff(), relative * greatest)
      << known.name;
  EXPECT_EQ(found.inertia, Matrix3(found.inertia.transpose())) << known.name;
}

TEST(MassProperties, OfPolyhedraAreTheirClosedForms) {
  for (const KnownSolid& known : known_solids()) {
    ASSERT_TRUE(find_defects(known.mesh).none()) << known.name;
    expect_known(known, solid_of(known.mesh, 1.0), 1e-12);
  }
}

TEST(MassProperties, AreAsExactFromWhicheverVertexTheyAreTaken) {
  // The first triangle's first vertex is the origin of the sums.
  RandomStream random(kSeed, "orders");
  for (KnownSolid known : known_solids()) {
    for (int trial = 0; trial < 20; ++trial) {
      random.shuffle(known.mesh.triangles);
      for (auto& triangle : known.mesh.triangles) {
        std::rotate(triangle.begin(), triangle.begin() + random.below(3), triangle.end());
      }
      expect_known(known, solid_of(known.mesh, 1.0), 1e-12);
    }
  }
}

TEST(MassProperties, AreAsExactFromTwelveThousandTriangles) {
  for (KnownSolid known : known_solids()) {
    while (known.mesh.triangles.size() < 8'000) {
      known.mesh = split_flat(known.mesh);
    }
    // Halved sides are exact but for the tetrahedron's and the hollow cube's last bits.
    const MassProperties found = solid_of(known.mesh, 1.0);
    EXPECT_NEAR(found.volume_m3 / known.volume_m3, 1.0, 1e-12) << known.name;
    EXPECT_LE((found.inertia - known.inertia).cwiseAbs().maxCoeff(),
              1e-12 * known.inertia.cwiseAbs().maxCoeff())
        << known.name;
  }
}

TEST(MassProperties, MovedAMillionDiametersLoseOnlyWhatTheCoordinatesLost) {
  // A coordinate of 1e6 diameters is rounded by at most 2⁻⁵³ of itself, 1.2e-10 diameters; the
  // volume of a solid that is thin by a factor of s loses s times that, the inertia about the
  // third and fifth powers of length.
  RandomStream random(kSeed, "moved");
  for (const KnownSolid& known : known_solids()) {
    if (known.name == "needle") {
      continue;  // thinner than its coordinates' rounding allows a share of
    }
    for (int trial = 0; trial < 20; ++trial) {
      const Vector3 way = 1e6 * diameter_m(known.mesh) * random_direction(random);
      MassProperties found = solid_of(moved_mesh(known.mesh, way), 1.0);
      found.centre -= way;
      expect_known(known, found, 1e-8);
    }
  }
}

TEST(MassProperties, MovedExactlyAreTheSameBits) {
  // Steps of a power of two that the coordinates, eighths, can take without rounding.
  const Vector3 way(0x1p21, -0x1p22, 0x1p20);
  for (const TriangleMesh& mesh : {box_mesh({2.0, 0.5, 0.25}), octahedron(1.5),
                                   prism(3.0, 2.0, 1.5), l_block_mesh(2.0, 0.5)}) {
    const MassProperties near = solid_of(mesh, 1.0);
    const MassProperties far = solid_of(moved_mesh(mesh, way), 1.0);
    EXPECT_EQ(far.volume_m3, near.volume_m3);
    EXPECT_EQ(far.inertia, near.inertia);
    EXPECT_LT((far.centre - way - near.centre).norm(), 0x1p-30);
  }
}

TEST(MassProperties, DensityScalesMassAndInertiaAlone) {
  for (const KnownSolid& known : known_solids()) {
    const MassProperties one = solid_of(known.mesh, 1.0);
    const MassProperties eight = solid_of(known.mesh, 8.0);
    EXPECT_EQ(eight.mass_kg, 8.0 * one.mass_kg);
    EXPECT_EQ(eight.volume_m3, one.volume_m3);
    EXPECT_EQ(eight.centre, one.centre);
    EXPECT_LE((eight.inertia - 8.0 * one.inertia).norm(), 1e-14 * eight.inertia.norm());
  }
}

}  // namespace impetus::mass_properties_test
