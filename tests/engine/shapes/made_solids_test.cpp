// Torus, knot and creature at every resolution: one closed surface of the right kind that never
// crosses itself; volumes against closed forms.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/shapes/solids/creature_mesh.hpp"
#include "engine/shapes/solids/level_set_mesh.hpp"
#include "engine/shapes/solids/prism_meshes.hpp"
#include "engine/shapes/solids/ring_meshes.hpp"
#include "engine/shapes/triangle_distance.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::made_solids_test {

/// Every edge is run along once each way: closed and consistently oriented.
bool closed_and_oriented(const TriangleMesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (!edges.insert({triangle[corner], triangle[(corner + 1) % 3]}).second) {
        return false;
      }
    }
  }
  return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
    return edges.contains({edge.second, edge.first});
  });
}

/// V − E + F, where E = 3/2 F
int euler_characteristic(const TriangleMesh& mesh) {
  return static_cast<int>(mesh.vertices.size()) - static_cast<int>(mesh.triangles.size()) / 2;
}

/// Pieces of surface; a vertex of no triangle counts as one.
int components(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> leader(mesh.vertices.size());
  std::iota(leader.begin(), leader.end(), 0U);
  const auto leader_of = [&](std::uint32_t vertex) {
    while (leader[vertex] != vertex) {
      vertex = leader[vertex] = leader[leader[vertex]];
    }
    return vertex;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    leader[leader_of(a)] = leader_of(b);
    leader[leader_of(b)] = leader_of(c);
  }
  int count = 0;
  for (std::uint32_t vertex = 0; vertex < leader.size(); ++vertex) {
    count += leader[vertex] == vertex ? 1 : 0;
  }
  return count;
}

/// Pairs of triangles that meet without sharing a vertex; by brute force over boxes that touch.
int self_crossings(const TriangleMesh& mesh) {
  const auto corners = [&](std::size_t triangle) -> Triangle {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
  };
  std::vector<std::pair<Vector3, Vector3>> boxes;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = corners(i);
    boxes.emplace_back(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
  }
  int crossings = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      const auto& of_j = mesh.triangles[j];
      const bool share = std::any_of(of_j.begin(), of_j.end(), [&](std::uint32_t vertex) {
        return std::count(mesh.triangles[i].begin(), mesh.triangles[i].end(), vertex) > 0;
      });
      const bool near = (boxes[i].first.array() <= boxes[j].second.array()).all() &&
                        (boxes[j].first.array() <= boxes[i].second.array()).all();
      if (near && !share && triangle_distance(corners(i), corners(j)).distance_m == 0.0) {
        ++crossings;
      }
    }
  }
  return crossings;
}

void expect_one_solid(const TriangleMesh& mesh, int characteristic) {
  EXPECT_TRUE(closed_and_oriented(mesh));
  EXPECT_TRUE(find_defects(mesh).none());
  EXPECT_EQ(components(mesh), 1);
  EXPECT_EQ(euler_characteristic(mesh), characteristic);
  EXPECT_GT(solid_of(mesh, 1.0).volume_m3, 0.0) << "outward";
}

TEST(SelfCrossings, AreSeenWhereTwoBoxesOverlap) {
  TriangleMesh mesh = box_mesh({1.0, 1.0, 1.0});
  EXPECT_EQ(self_crossings(mesh), 0);
  const TriangleMesh other = box_mesh({0.5, 0.6, 2.0});
  for (const auto& [a, b, c] : other.triangles) {
    mesh.triangles.push_back({a + 8, b + 8, c + 8});
  }
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  EXPECT_EQ(components(mesh), 2);
  EXPECT_GT(self_crossings(mesh), 0);
}

TEST(TorusMesh, IsOneClosedRingAtEveryResolution) {
  for (const auto& [segments, sides] : {std::pair{3, 3}, {12, 4}, {30, 10}, {7, 31}}) {
    const TriangleMesh mesh = torus_mesh(0.3, 0.1, segments, sides);
    EXPECT_EQ(mesh.triangles.size(), static_cast<std::size_t>(2 * segments * sides));
    expect_one_solid(mesh, 0);
  }
}

// The area of a regular n-gon in a circle is a share n/(2π) sin(2π/n) of the circle's; rings of
// sections that are similar polygons enclose that share along and across.
TEST(TorusMesh, HasTheVolumeOfATorusLessWhatItsPolygonsCutOff) {
  const double round = 2.0 * std::numbers::pi * std::numbers::pi * 0.3 * 0.1 * 0.1;  // 2π²Rr²
  const auto share = [](int n) {
    return n / (2.0 * std::numbers::pi) * std::sin(2.0 * std::numbers::pi / n);
  };
  for (const int sides : {6, 12, 24, 48}) {
    const double volume = solid_of(torus_mesh(0.3, 0.1, 3 * sides, sides), 1.0).volume_m3;
    EXPECT_NEAR(volume / (round * share(3 * sides) * share(sides)), 1.0, 1e-12) << sides;
  }
}

TEST(TorusMesh, NeverCrossesItselfHoweverThick) {
  for (const double tube_m : {0.1, 0.5, 0.99}) {
    for (const int sides : {4, 12}) {
      EXPECT_EQ(self_crossings(torus_mesh(1.0, tube_m, 3 * sides, sides)), 0) << tube_m;
    }
  }
}

TEST(KnotMesh, IsOneClosedTubeAtEveryResolution) {
  for (int sides = 4; sides <= 12; ++sides) {
    SCOPED_TRACE(sides);
    const TriangleMesh mesh = knot_mesh(0.3, 0.06, 8 * sides, sides);
    EXPECT_EQ(mesh.triangles.size(), static_cast<std::size_t>(16 * sides * sides));
    expect_one_solid(mesh, 0);
  }
}

TEST(KnotMesh, NeverCrossesItselfAtItsThickest) {
  for (int sides = 4; sides <= 12; ++sides) {
    EXPECT_EQ(self_crossings(knot_mesh(1.0, kThickestKnot, 8 * sides, sides)), 0) << sides;
  }
}

/// The length of the knot's curve for a reach of 1, as a polygon of many corners.
double trefoil_length() {
  constexpr int kCorners = 100'000;
  const auto corner = [](int i) -> Vector3 {
    const double t = 2.0 * std::numbers::pi * i / kCorners;
    const double from_axis = 1.0 + 0.45 * std::cos(3.0 * t);
    return Vector3(from_axis * std::cos(2.0 * t), from_axis * std::sin(2.0 * t),
                   0.45 * std::sin(3.0 * t)) /
           1.45;
  };
  double length = 0.0;
  for (int i = 0; i < kCorners; ++i) {
    length += (corner(i + 1) - corner(i)).norm();
  }
  return length;
}

// A tube of round sections across its curve has the volume π r² L. (Pappus)
TEST(KnotMesh, ApproachesTheVolumeOfARoundTubeByAFactorOfFourARound) {
  const double exact = std::numbers::pi * 0.2 * 0.2 * trefoil_length();
  double error = exact - solid_of(knot_mesh(1.0, 0.2, 128, 16), 1.0).volume_m3;
  for (const int sides : {32, 64, 128}) {
    const double finer = exact - solid_of(knot_mesh(1.0, 0.2, 8 * sides, sides), 1.0).volume_m3;
    EXPECT_GT(finer, 0.0);
    EXPECT_NEAR(error / finer, 4.0, 0.3) << sides;
    error = finer;
  }
}

TEST(CreatureMesh, IsOneClosedSurfaceWithoutHandlesAtEveryResolution) {
  for (int cells = 16; cells <= 48; cells += 4) {
    SCOPED_TRACE(cells);
    expect_one_solid(creature_mesh(0.5, cells), 2);
  }
}

TEST(CreatureMesh, IsClosedAlsoWhereItsGridIsTooCoarseForItsHorns) {
  for (const int cells : {8, 12}) {
    SCOPED_TRACE(cells);
    const TriangleMesh mesh = creature_mesh(0.5, cells);
    EXPECT_TRUE(closed_and_oriented(mesh));
    EXPECT_GT(solid_of(mesh, 1.0).volume_m3, 0.0);
  }
}

TEST(CreatureMesh, NeverCrossesItself) { EXPECT_EQ(self_crossings(creature_mesh(1.0, 16)), 0); }

TEST(CreatureMesh, IsAsLongAsAskedAndConcave) {
  for (const int cells : {16, 28}) {
    const TriangleMesh mesh = creature_mesh(0.7, cells);
    Vector3 least = mesh.vertices.front();
    Vector3 most = least;
    for (const Vector3& vertex : mesh.vertices) {
      least = least.cwiseMin(vertex);
      most = most.cwiseMax(vertex);
    }
    EXPECT_NEAR((most - least).x(), 0.7, 1e-15);
    EXPECT_LT(solid_of(mesh, 1.0).volume_m3, 0.25 * (most - least).prod()) << "limbs, not a lump";
  }
}

TEST(MadeSolids, AreTheSameTwice) {
  const auto same = [](const TriangleMesh& a, const TriangleMesh& b) {
    return a.vertices == b.vertices && a.triangles == b.triangles;
  };
  EXPECT_TRUE(same(torus_mesh(0.3, 0.1, 30, 10), torus_mesh(0.3, 0.1, 30, 10)));
  EXPECT_TRUE(same(knot_mesh(0.3, 0.05, 64, 8), knot_mesh(0.3, 0.05, 64, 8)));
  EXPECT_TRUE(same(creature_mesh(0.3, 16), creature_mesh(0.3, 16)));
}

TEST(LevelSetMesh, OfABallApproachesItsVolume) {
  const auto ball = [](const Vector3& point) { return point.norm() - 1.0; };
  const SampleGrid grid{Vector3::Constant(-1.25), 2.5 / 40, {40, 40, 40}};
  const TriangleMesh mesh = level_set_mesh(ball, grid);
  expect_one_solid(mesh, 2);
  // Vertices that keep away from the grid's points lie up to a tenth of an edge off the surface.
  EXPECT_NEAR(solid_of(mesh, 1.0).volume_m3 / (4.0 / 3.0 * std::numbers::pi), 1.0, 0.01);
}

// The value at a point decides its side by its sign alone: 0 is outside.
TEST(LevelSetMesh, IsASolidWhateverTheSignsAre) {
  RandomStream random(11, "level sets of noise");
  const SampleGrid grid{Vector3::Zero(), 1.0, {7, 6, 5}};
  for (int trial = 0; trial < 30; ++trial) {
    const TriangleMesh mesh = level_set_mesh(
        [&](const Vector3& p) {
          const bool within = (p.array() > 0.5).all() && p.x() < 6.5 && p.y() < 5.5 && p.z() < 4.5;
          return within ? std::round(uniform_in(random, -2.0, 2.0)) : 1.0;
        },
        grid);
    ASSERT_TRUE(closed_and_oriented(mesh));
    ASSERT_TRUE(find_defects(mesh).none());
    ASSERT_EQ(self_crossings(mesh), 0);
  }
}

/// An arrow head: one corner points inwards.
const std::vector<OutlinePoint> kArrow{{0, 0}, {3, 2}, {0, 4}, {1, 2}};

TEST(Prism, IsClosedAndAsLargeAsItsOutline) {
  std::vector<OutlinePoint> clockwise(kArrow.rbegin(), kArrow.rend());
  for (const auto& outline : {kArrow, clockwise}) {
    EXPECT_EQ(problem_of(outline), "");
    const TriangleMesh mesh = prism_mesh(outline, 0.5);
    EXPECT_TRUE(closed_and_oriented(mesh));
    EXPECT_EQ(euler_characteristic(mesh), 2);
    EXPECT_NEAR(solid_of(mesh, 1.0).mass_kg, 0.5 * 4.0,
                1e-12);  // the triangle's 6 less the notch's 2
  }
}

TEST(Prism, ADiscLiesWithinAHairOfItsCircle) {
  const TriangleMesh mesh = disc_mesh(2.0);
  EXPECT_TRUE(closed_and_oriented(mesh));
  EXPECT_NEAR(solid_of(mesh, 1.0).mass_kg, std::numbers::pi * 4.0 * 0.02, 1e-3 * 0.25);
}

}  // namespace impetus::made_solids_test
