// How finely crowds are drawn: which mesh stands for a body, and how true the coarser ones are.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <set>

#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/shapes/solids/creature_mesh.hpp"
#include "engine/shapes/triangle_distance.hpp"
#include "experiments/scenes/coarser_meshes.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::drawn_levels_test {

constexpr double kLengthM = 0.022;

const TriangleMesh& creature() {
  static const TriangleMesh mesh = creature_mesh(kLengthM, 16);
  return mesh;
}

const DrawnLevels& creature_levels() {
  static const DrawnLevels levels = coarser_meshes(creature());
  return levels;
}

// ---------------------------------------------------------------- the meshes

TEST(CoarserMeshes, AreClosedAndHaveHalfTheTrianglesEach) {
  ASSERT_GE(creature_levels().size(), 5U);
  std::size_t finer = creature().triangles.size();
  double deviation_m = 0.0;
  for (const DrawnLevel& level : creature_levels()) {
    EXPECT_TRUE(find_defects(*level.mesh).none());
    EXPECT_LE(level.mesh->triangles.size(), finer / 2);
    EXPECT_GE(level.mesh->triangles.size(), 2 * finer / 5);
    EXPECT_GT(level.deviation_m, deviation_m);
    finer = level.mesh->triangles.size();
    deviation_m = level.deviation_m;
  }
}

TEST(CoarserMeshes, AreTheSameEveryTime) {
  const DrawnLevels again = coarser_meshes(creature());
  ASSERT_EQ(again.size(), creature_levels().size());
  for (std::size_t level = 0; level < again.size(); ++level) {
    EXPECT_EQ(again[level].mesh->vertices, creature_levels()[level].mesh->vertices);
    EXPECT_EQ(again[level].mesh->triangles, creature_levels()[level].mesh->triangles);
    EXPECT_EQ(again[level].deviation_m, creature_levels()[level].deviation_m);
  }
}

TEST(CoarserMeshes, OfAMeshOfFewTrianglesThereAreNone) {
  EXPECT_TRUE(coarser_meshes(l_block_mesh(2.0, 0.7)).empty());
}

Triangle corners_of(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  return {mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]};
}

double distance_by_brute_force(const Vector3& point, const TriangleMesh& mesh) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const auto& triangle : mesh.triangles) {
    const Vector3 nearest = closest_on_triangle(corners_of(mesh, triangle), point);
    least_m = std::min(least_m, (nearest - point).norm());
  }
  return least_m;
}

/// √(mean d²) over points drawn evenly over the surface of `from`.
double mean_deviation_by_brute_force(const TriangleMesh& from, const TriangleMesh& to,
                                     std::mt19937& random) {
  std::vector<double> areas;
  for (const auto& triangle : from.triangles) {
    const Triangle at = corners_of(from, triangle);
    areas.push_back((at[1] - at[0]).cross(at[2] - at[0]).norm());
  }
  std::discrete_distribution<std::size_t> triangles(areas.begin(), areas.end());
  std::uniform_real_distribution<double> uniform;
  constexpr int kPoints = 4000;
  double sum_m2 = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const Triangle at = corners_of(from, from.triangles[triangles(random)]);
    const double root = std::sqrt(uniform(random));
    const double share = uniform(random);
    const Vector3 point =
        (1.0 - root) * at[0] + root * (1.0 - share) * at[1] + root * share * at[2];
    const double distance_m = distance_by_brute_force(point, to);
    sum_m2 += distance_m * distance_m;
  }
  return std::sqrt(sum_m2 / kPoints);
}

TEST(CoarserMeshes, DeviateAsFarAsASampleOfTheirSurfacesSays) {
  constexpr unsigned kSeed = 20261121;
  std::mt19937 random(kSeed);
  for (const std::size_t index : {2U, 4U}) {  // 322 and 80 triangles
    const DrawnLevel& level = creature_levels()[index];
    const double sampled_m =
        std::max(mean_deviation_by_brute_force(creature(), *level.mesh, random),
                 mean_deviation_by_brute_force(*level.mesh, creature(), random));
    // Seven points stand for a triangle; the sample scatters by a few per cent.
    EXPECT_NEAR(level.deviation_m, sampled_m, 0.2 * sampled_m) << "seed " << kSeed;
  }
}

// ---------------------------------------------------------------- the choice

TEST(MeshAsSeen, IsTheCoarsestWithinHalfAPixel) {
  constexpr unsigned kSeed = 6;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> log_px_per_metre(0.0, 7.0);
  const auto own = std::make_shared<const TriangleMesh>(creature());
  std::set<const TriangleMesh*> chosen;
  for (int i = 0; i < 1000; ++i) {
    const double px_per_metre = std::pow(10.0, log_px_per_metre(random));
    const TriangleMesh* expected = own.get();
    for (const DrawnLevel& level : creature_levels()) {
      if (level.deviation_m * px_per_metre <= 0.5) {
        expected = level.mesh.get();
      }
    }
    const TriangleMesh* mesh = mesh_as_seen(own, &creature_levels(), px_per_metre).get();
    EXPECT_EQ(mesh, expected) << "seed " << kSeed << ", " << px_per_metre << " px per metre";
    chosen.insert(mesh);
  }
  EXPECT_EQ(chosen.size(), creature_levels().size() + 1) << "every mesh has its distance";
}

TEST(MeshAsSeen, WithoutCoarserOnesIsItsOwn) {
  const auto own = std::make_shared<const TriangleMesh>(creature());
  EXPECT_EQ(mesh_as_seen(own, nullptr, 1e-9), own);
}

// ---------------------------------------------------------------- the scene

TEST(DrawnScene, OnlyACrowdHasCoarserMeshesAndOneSetOfThem) {
  json scene = json::parse(shipped("stimuli/creatures-in-a-cube.json"));
  scene["engine"]["tree"] = {{"kind", "octree"}};
  const StagedScene few = built(changed(scene, "/crowd/count", 20));
  const StagedScene many = built(changed(scene, "/crowd/count", 50));
  for (const DrawnBody& look : few.looks) {
    EXPECT_EQ(look.coarser, nullptr);
  }
  ASSERT_NE(many.looks.front().coarser, nullptr);
  EXPECT_FALSE(many.looks.front().coarser->empty());
  for (const DrawnBody& look : many.looks) {
    EXPECT_EQ(look.coarser, many.looks.front().coarser);
  }
}

}  // namespace impetus::drawn_levels_test
