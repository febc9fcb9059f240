// What is wrong with a surface: where it passes through itself, hangs in a corner, faces the wrong
// way or encloses nothing; the fast search against every pair.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

#include "engine/shapes/mesh_components.hpp"
#include "engine/shapes/self_intersections.hpp"
#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/mesh_oracles.hpp"

namespace impetus::mesh_defects_test {

void append(TriangleMesh& mesh, TriangleMesh other, const Vector3& offset) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vector3& vertex : other.vertices) {
    mesh.vertices.push_back(vertex + offset);
  }
  for (const auto& [a, b, c] : other.triangles) {
    mesh.triangles.push_back({first + a, first + b, first + c});
  }
}

TriangleMesh turned(TriangleMesh mesh) {
  for (auto& triangle : mesh.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

TriangleMesh two_triangles(const std::array<Vector3, 3>& a, const std::array<Vector3, 3>& b) {
  TriangleMesh mesh;
  mesh.vertices = {a[0], a[1], a[2], b[0], b[1], b[2]};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  return mesh;
}

TriangleMeeting meeting_of(const TriangleMesh& mesh) {
  return meeting(mesh, mesh.triangles[0], mesh.triangles[1]);
}

/// Random triangles whose corners are of a lattice of `steps` steps: many touch, share corners, lie
/// in one plane or have no area.
TriangleMesh lattice_soup(RandomStream& random, int triangles, int steps) {
  TriangleMesh mesh;
  const auto places = static_cast<std::uint32_t>(steps * steps * steps);
  for (std::uint32_t i = 0; i < places; ++i) {
    const auto n = static_cast<std::uint32_t>(steps);
    mesh.vertices.emplace_back(0.1 * (i % n), 0.1 * (i / n % n), 0.1 * (i / n / n));
  }
  const auto corner = [&random, places] {
    return static_cast<std::uint32_t>(uniform_in(random, 0.0, places)) % places;
  };
  for (int i = 0; i < triangles; ++i) {
    const std::uint32_t a = corner();
    const std::uint32_t b = corner();
    mesh.triangles.push_back({a, b, corner()});
  }
  return mesh;
}

TriangleMesh random_soup(RandomStream& random, int triangles, double size_m) {
  TriangleMesh mesh;
  for (int i = 0; i < triangles; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const Vector3 place = random_in_cube(random, 1.0);
    for (int corner = 0; corner < 3; ++corner) {
      mesh.vertices.push_back(place + random_in_cube(random, size_m));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TEST(SideOfPlane, IsExactWhereDoublesRound) {
  const Vector3 a(0.5, 0.25, 1.0);
  const Vector3 b(12.0, 3.5, -2.0);
  const Vector3 c(24.0, -8.0, 4.0);
  const Vector3 in_plane = a + 0.5 * (b - a) + 0.25 * (c - a);  // all exact in binary
  EXPECT_EQ(side_of_plane(a, b, c, in_plane), 0);
  const Vector3 above(in_plane.x(), in_plane.y(), std::nextafter(in_plane.z(), 100.0));
  const Vector3 below(in_plane.x(), in_plane.y(), std::nextafter(in_plane.z(), -100.0));
  EXPECT_EQ(side_of_plane(a, b, c, above) * side_of_plane(a, b, c, below), -1);
}

TEST(SideOfPlane, SwappingTwoPointsTurnsTheSign) {
  RandomStream random(3, "side_of_plane");
  for (int i = 0; i < 1'000; ++i) {
    const TriangleMesh soup = lattice_soup(random, 1, 3);
    const auto [a, b, c] = soup.triangles[0];
    const Vector3& p = soup.vertices[a];
    const Vector3& q = soup.vertices[b];
    const Vector3& r = soup.vertices[c];
    const Vector3 s = soup.vertices[static_cast<std::size_t>(i) % 27];
    ASSERT_EQ(side_of_plane(p, q, r, s), -side_of_plane(q, p, r, s)) << i;
    ASSERT_EQ(side_of_plane(p, q, r, s), -side_of_plane(s, q, r, p)) << i;
  }
}

TEST(TriangleMeeting, TrianglesThatPierceTouchOrOverlapInAPlaneCross) {
  const std::array<Vector3, 3> flat{Vector3(0, 0, 0), Vector3(4, 0, 0), Vector3(0, 4, 0)};
  EXPECT_EQ(
      meeting_of(two_triangles(flat, {Vector3(1, 1, -1), Vector3(1, 1, 1), Vector3(9, 9, 1)})),
      TriangleMeeting::kCrossing);
  EXPECT_EQ(meeting_of(two_triangles(flat, {Vector3(1, 1, 0), Vector3(1, 1, 1), Vector3(9, 9, 1)})),
            TriangleMeeting::kCrossing)
      << "a corner on the face";
  EXPECT_EQ(
      meeting_of(two_triangles(flat, {Vector3(-1, 1, 0), Vector3(9, 1, 0), Vector3(9, 2, 0)})),
      TriangleMeeting::kCrossing)
      << "through each other in one plane";
  EXPECT_EQ(
      meeting_of(two_triangles(flat, {Vector3(1, 1, 0), Vector3(1.5, 1, 0), Vector3(1, 1.5, 0)})),
      TriangleMeeting::kCrossing)
      << "one inside the other in one plane";
  EXPECT_EQ(
      meeting_of(two_triangles(flat, {Vector3(-1, -1, 0), Vector3(9, 9, 0), Vector3(-1, 9, 0)})),
      TriangleMeeting::kCrossing)
      << "an edge over a corner";
}

TEST(TriangleMeeting, TrianglesThatAreApartDoNotMeet) {
  const std::array<Vector3, 3> flat{Vector3(0, 0, 0), Vector3(4, 0, 0), Vector3(0, 4, 0)};
  const double above_m = 1e-300;
  EXPECT_EQ(
      meeting_of(two_triangles(flat, {Vector3(1, 1, above_m), Vector3(1, 1, 1), Vector3(9, 9, 1)})),
      TriangleMeeting::kNone);
  EXPECT_EQ(meeting_of(two_triangles(flat, {Vector3(4, 4, 0), Vector3(5, 4, 0), Vector3(4, 5, 0)})),
            TriangleMeeting::kNone)
      << "in one plane";
}

TEST(TriangleMeeting, NeighboursMeetOnlyWhenTheyFoldOntoEachOther) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {4, 4, 0}, {1, 1, 1}, {3, 3, 0}};
  const std::array<std::uint32_t, 3> flat{0, 1, 2};
  EXPECT_EQ(meeting(mesh, flat, {1, 2, 4}), TriangleMeeting::kNone) << "spread out over an edge";
  EXPECT_EQ(meeting(mesh, flat, {1, 2, 5}), TriangleMeeting::kNone) << "bent over an edge";
  EXPECT_EQ(meeting(mesh, flat, {1, 2, 3}), TriangleMeeting::kFolded) << "folded over an edge";
  EXPECT_EQ(meeting(mesh, flat, {0, 5, 4}), TriangleMeeting::kFolded) << "an edge along the face";
  EXPECT_EQ(meeting(mesh, flat, {2, 4, 6}), TriangleMeeting::kNone) << "only the corner";
  EXPECT_EQ(meeting(mesh, flat, {1, 0, 2}), TriangleMeeting::kNone) << "a duplicate";
}

TEST(SelfIntersections, TheSearchFindsWhatEveryPairFinds) {
  const std::uint64_t seed = 29;
  RandomStream random(seed, "self_intersections");
  for (int i = 0; i < 40; ++i) {
    const TriangleMesh soup =
        i % 2 == 0 ? lattice_soup(random, 120, 4) : random_soup(random, 200, 0.05 * (i + 1));
    const SelfIntersections fast = find_self_intersections(soup);
    const SelfIntersections slow = find_self_intersections_by_brute_force(soup);
    ASSERT_EQ(fast.crossing_pairs, slow.crossing_pairs) << "seed " << seed << ", mesh " << i;
    ASSERT_EQ(fast.folded_pairs, slow.folded_pairs) << "seed " << seed << ", mesh " << i;
    ASSERT_GT(slow.pairs(), 0);
  }
}

TEST(SelfIntersections, ASphereHasNoneAndTwoThatOverlapHaveSome) {
  TriangleMesh mesh = icosphere_mesh(1.0, 4);
  EXPECT_EQ(find_self_intersections(mesh).pairs(), 0);
  append(mesh, icosphere_mesh(1.0, 4), Vector3(0.7, 0.1, 0.0));
  EXPECT_GT(find_self_intersections(mesh).crossing_pairs, 100);
}

TEST(SelfIntersections, OfEightyThousandTrianglesAreFoundInSeconds) {
  const TriangleMesh mesh = icosphere_mesh(1.0, 6);
  ASSERT_EQ(mesh.triangles.size(), 81'920U);
  EXPECT_EQ(find_self_intersections(mesh).pairs(), 0);  // by brute force this would take minutes
}

TEST(Components, CubesThatShareACornerAreTwoAndPinchedOnce) {
  TriangleMesh mesh = box_mesh(Vector3::Constant(1.0));
  TriangleMesh other = box_mesh(Vector3::Constant(1.0));
  const Vector3 shared = mesh.vertices[0];
  const Vector3 offset = 2.0 * shared;
  append(mesh, other, offset);
  std::uint32_t twin = 8;
  while ((mesh.vertices[twin] - shared).norm() > 0.0) {
    ++twin;
    ASSERT_LT(twin, mesh.vertices.size());
  }
  EXPECT_EQ(find_components(mesh).pinched_vertices, 0);
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) {
      corner = corner == twin ? 0 : corner;
    }
  }
  const MeshComponents components = find_components(mesh);
  EXPECT_EQ(components.count, 2U);
  EXPECT_EQ(components.pinched_vertices, 1);
}

TEST(Orientation, ABodyLooksOutwardAndACavityInward) {
  const TriangleMesh small = icosphere_mesh(0.3, 1);
  TriangleMesh hollow = icosphere_mesh(1.0, 2);
  append(hollow, turned(small), Vector3::Zero());
  append(hollow, small, Vector3(5.0, 0.0, 0.0));
  EXPECT_EQ(orientation_of(hollow, find_components(hollow)).turned,
            (std::vector<bool>{false, false, false}));
  TriangleMesh wrong = turned(icosphere_mesh(1.0, 2));
  append(wrong, small, Vector3::Zero());
  append(wrong, turned(small), Vector3(5.0, 0.0, 0.0));
  EXPECT_EQ(orientation_of(wrong, find_components(wrong)).turned,
            (std::vector<bool>{true, true, true}));
}

TEST(Orientation, ANeedleIsABodyAtEverySizeAndASheetIsNone) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const TriangleMesh needle = box_mesh(scale * Vector3(1e-4, 1e-4, 1.0));
    EXPECT_FALSE(orientation_of(needle, find_components(needle)).flat[0]) << scale;
    const TriangleMesh sheet = box_mesh(scale * Vector3(1.0, 1e-8, 1.0));
    EXPECT_TRUE(orientation_of(sheet, find_components(sheet)).flat[0]) << scale;
  }
}

}  // namespace impetus::mesh_defects_test
