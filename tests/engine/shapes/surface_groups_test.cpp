// Fewer triangles, the same closed solid; and the nearly plane pieces of surfaces.
// SPDX-License-Identifier: MIT
#include "engine/shapes/surface_groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/mesh_reduction.hpp"
#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/shapes/solids/creature_mesh.hpp"
#include "engine/shapes/solids/ring_meshes.hpp"
#include "engine/shapes/surface_distance.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/split_flat.hpp"

namespace impetus::surface_groups_test {

double volume_m3(const TriangleMesh& mesh) { return solid_of(mesh, 1.0).volume_m3; }

std::size_t group_count(const TriangleMesh& mesh) {
  const std::vector<std::int32_t> groups = surface_groups(mesh);
  EXPECT_EQ(groups.size(), mesh.triangles.size());
  return std::set<std::int32_t>(groups.begin(), groups.end()).size();
}

Vector3 area_vector(const TriangleMesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Vector3& origin = mesh.vertices[a];
  return 0.5 * (mesh.vertices[b] - origin).cross(mesh.vertices[c] - origin);
}

struct Reduced {
  std::string name;
  TriangleMesh mesh;
  std::size_t triangles;
  double volume_kept;  ///< within this share
};

TEST(ReducedMesh, StaysClosedOfTheSameTopologyAndNearTheVolume) {
  const std::vector<Reduced> cases{{"icosphere", icosphere_mesh(1.0, 4), 500, 0.01},
                                   {"icosphere", icosphere_mesh(1.0, 4), 100, 0.05},
                                   {"torus", torus_mesh(1.0, 0.3, 48, 24), 400, 0.03},
                                   {"knot", knot_mesh(0.6, 0.14, 96, 12), 1'000, 0.01},
                                   {"creature", creature_mesh(2.0, 20), 1'000, 0.02}};
  for (const auto& [name, mesh, triangles, volume_kept] : cases) {
    const TriangleMesh reduced = reduced_mesh(mesh, triangles);
    EXPECT_LE(reduced.triangles.size(), triangles) << name;
    EXPECT_GT(reduced.triangles.size(), triangles - 4) << name;
    EXPECT_TRUE(find_defects(reduced).none()) << name;
    EXPECT_NEAR(volume_m3(reduced) / volume_m3(mesh), 1.0, volume_kept) << name;
    // V − E + F, with E = 3/2 F
    const auto euler = [](const TriangleMesh& of) {
      return 2 * static_cast<int>(of.vertices.size()) - static_cast<int>(of.triangles.size());
    };
    EXPECT_EQ(euler(reduced), euler(mesh)) << name;
  }
}

TEST(ReducedMesh, ItsVerticesLieNearTheSurfaceItCameFrom) {
  const TriangleMesh mesh = creature_mesh(2.0, 20);
  const SurfaceDistance surface(mesh);
  for (const Vector3& vertex : reduced_mesh(mesh, 800).vertices) {
    EXPECT_LT(surface.nearest(vertex).distance_m, 0.02) << "of a length of 2";
  }
}

TEST(ReducedMesh, AFinelyCutBoxComesBackToTwelveTriangles) {
  TriangleMesh mesh = box_mesh({1.0, 0.6, 0.3});
  for (int i = 0; i < 4; ++i) {
    mesh = split_flat(mesh);
  }
  const TriangleMesh reduced = reduced_mesh(mesh, 12);
  EXPECT_EQ(reduced.triangles.size(), 12U);
  EXPECT_NEAR(volume_m3(reduced), 0.18, 0.01 * 0.18);
}

TEST(ReducedMesh, KeepsWhatHasNoMoreTrianglesAndStopsWhereTheShapeWouldFold) {
  const TriangleMesh box = box_mesh({1.0, 1.0, 1.0});
  EXPECT_EQ(reduced_mesh(box, 12).vertices, box.vertices);
  const TriangleMesh least = reduced_mesh(icosphere_mesh(1.0, 2), 0);
  EXPECT_GE(least.triangles.size(), 4U);
  EXPECT_TRUE(find_defects(least).none());
}

TEST(ReducedMesh, ScalesAndMovesWithTheMesh) {
  // By a power of two all arithmetic is the same.
  TriangleMesh mesh = torus_mesh(1.0, 0.3, 32, 16);
  const TriangleMesh expected = reduced_mesh(mesh, 300);
  for (Vector3& vertex : mesh.vertices) {
    vertex *= 0x1p-20;
  }
  const TriangleMesh small = reduced_mesh(mesh, 300);
  ASSERT_EQ(small.triangles, expected.triangles);
  for (std::size_t i = 0; i < small.vertices.size(); ++i) {
    ASSERT_EQ(small.vertices[i], Vector3(0x1p-20 * expected.vertices[i]));
  }
}

TEST(SurfaceGroups, AFaceIsAGroup) {
  EXPECT_EQ(group_count(box_mesh({1.0, 1.0, 1.0})), 6U);
  EXPECT_EQ(group_count(box_mesh({1.0, 1.0, 0.02})), 6U) << "a plate";
  EXPECT_EQ(group_count(l_block_mesh(2.0, 0.7)), 8U);
}

TEST(SurfaceGroups, HowFinelyAFaceIsCutDoesNotMatter) {
  TriangleMesh box = box_mesh({1.0, 0.7, 0.4});
  TriangleMesh block = l_block_mesh(2.0, 0.7);
  for (int i = 0; i < 3; ++i) {
    box = split_flat(box);
    block = split_flat(block);
  }
  ASSERT_GT(box.triangles.size(), kFineMesh);
  EXPECT_EQ(group_count(box), 6U);
  EXPECT_EQ(group_count(block), 8U);
}

TEST(SurfaceGroups, TrianglesOfAGroupFaceNearlyTheSameWay) {
  for (const TriangleMesh& mesh : {icosphere_mesh(1.0, 2), torus_mesh(1.0, 0.4, 20, 10)}) {
    ASSERT_LE(mesh.triangles.size(), kFineMesh);
    const std::vector<std::int32_t> groups = surface_groups(mesh);
    std::map<std::int32_t, Vector3> sums;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      sums.try_emplace(groups[i], Vector3::Zero()).first->second += area_vector(mesh, i);
    }
    for (std::size_t i = 0; i < groups.size(); ++i) {
      // The mean moves as the group grows, so the first ones may end a little farther from it.
      EXPECT_GT(area_vector(mesh, i).normalized().dot(sums.at(groups[i]).normalized()),
                kGroupCosine - 0.1);
    }
    EXPECT_GT(sums.size(), 8U);
    EXPECT_LT(sums.size(), mesh.triangles.size() / 4);
  }
}

TEST(SurfaceGroups, OfAFineMeshMostlyFaceTheSameWayToo) {
  const TriangleMesh mesh = creature_mesh(2.0, 20);
  ASSERT_GT(mesh.triangles.size(), kFineMesh);
  const std::vector<std::int32_t> groups = surface_groups(mesh);
  std::map<std::int32_t, Vector3> sums;
  double whole_m2 = 0.0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    sums.try_emplace(groups[i], Vector3::Zero()).first->second += area_vector(mesh, i);
    whole_m2 += area_vector(mesh, i).norm();
  }
  double aligned_m2 = 0.0;
  for (const auto& [group, sum] : sums) {
    aligned_m2 += sum.norm();
  }
  // The area-weighted mean cosine between triangles and their groups.
  EXPECT_GT(aligned_m2 / whole_m2, 0.85);
  EXPECT_LE(sums.size(), kReducedMesh);
  EXPECT_GT(sums.size(), 20U);
}

TEST(SurfaceGroups, AreNumberedAndTheSameEveryTime) {
  const TriangleMesh mesh = l_block_mesh(2.0, 0.7);
  const std::vector<std::int32_t> groups = surface_groups(mesh);
  EXPECT_EQ(*std::min_element(groups.begin(), groups.end()), 0);
  EXPECT_EQ(*std::max_element(groups.begin(), groups.end()), 7);
  EXPECT_EQ(surface_groups(mesh), groups);
}

}  // namespace impetus::surface_groups_test
