// What is measured of levels: closed forms of nodes about boxes and balls.
// SPDX-License-Identifier: MIT
#include "engine/trees/level_quality.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/trees/builders/build_tree.hpp"
#include "engine/trees/solid_grid.hpp"
#include "tests/engine/one_of_each_kind.hpp"

namespace impetus::level_quality_test {

constexpr double kPi = std::numbers::pi;

LevelQuality quality_of(const TriangleMesh& solid, const Volume& volume) {
  return measure_levels(solid, single_node_tree(volume)).front();
}

TEST(LevelQuality, OfASphereRoundACubeIsItsClosedForm) {
  const double radius = std::sqrt(0.75) + 1e-9;
  const LevelQuality quality =
      quality_of(box_mesh({1.0, 1.0, 1.0}), Sphere{Vector3::Zero(), radius});
  EXPECT_EQ(quality.nodes, 1);
  EXPECT_NEAR(quality.worst_protrusion_m, radius - 0.5, 0.03 * (radius - 0.5));
  EXPECT_EQ(quality.uncovered_area_m2, 0.0);
  EXPECT_NEAR(quality.outside_ratio, 4.0 / 3.0 * kPi * std::pow(radius, 3.0) - 1.0, 0.01);
  EXPECT_NEAR(quality.largest_node_m, 2.0 * radius, 1e-15);
  EXPECT_EQ(quality.bytes,
            sizeof(Sphere) + sizeof(NodeLinks) + sizeof(NodeSurface) + sizeof(std::uint32_t));
}

TEST(LevelQuality, OfABoxOfItselfIsNothingBeyond) {
  const LevelQuality quality =
      quality_of(box_mesh({1.0, 0.5, 0.25}), Box{Vector3::Zero(), {0.5, 0.25, 0.125}});
  EXPECT_LE(quality.worst_protrusion_m, 1e-8);
  EXPECT_LE(quality.mean_protrusion_m, 1e-15);
  EXPECT_EQ(quality.outside_ratio, 0.0);
  EXPECT_EQ(quality.uncovered_area_m2, 0.0);
}

TEST(LevelQuality, OfAConcentricBallIsTheStandOffEverywhere) {
  const LevelQuality quality = quality_of(icosphere_mesh(1.0, 4), Sphere{Vector3::Zero(), 1.3});
  EXPECT_NEAR(quality.worst_protrusion_m, 0.3, 0.01);
  EXPECT_NEAR(quality.mean_protrusion_m, 0.3, 0.003) << "the mesh lies within .002 of the sphere";
  EXPECT_NEAR(quality.outside_ratio, 1.3 * 1.3 * 1.3 - 1.0, 0.02);
}

TEST(LevelQuality, OfABoxLargerAllRoundIsItsClosedForm) {
  // Distance t over each face; over a face's margin more, which is most at corners: √3 t.
  const double t = 0.05;
  const LevelQuality quality =
      quality_of(box_mesh({1.0, 1.0, 1.0}), Box{Vector3::Zero(), Vector3::Constant(0.5 + t)});
  EXPECT_GE(quality.worst_protrusion_m, std::sqrt(3.0) * t * (1.0 - 1e-12));
  EXPECT_LE(quality.worst_protrusion_m, std::sqrt(3.0) * t * 1.02 + 1e-3);
  // Of a face of side 1+2t, share 1/(1+2t)² is at t; along edges the mean of √(t²+x²), x in 0..t,
  // is t (√2 + asinh 1)/2 = 1.1478 t; corners are a sixth of a percent and at about 1.28 t.
  const double side = 1.0 + 2.0 * t;
  const double expected = (1.0 * t + 4.0 * t * 1.1478 * t + 4.0 * t * t * 1.28 * t) / (side * side);
  EXPECT_NEAR(quality.mean_protrusion_m, expected, 0.01 * expected);
  EXPECT_NEAR(quality.outside_ratio, side * side * side - 1.0, 0.02);
}

TEST(LevelQuality, CountsWhereNodesOverlapOnce) {
  // Two balls about the ends of a bar: the union's volume is two balls less their lens.
  const double r = 0.6;
  const double d = 0.5;
  const double lens = kPi * (4.0 * r + d) * (2.0 * r - d) * (2.0 * r - d) / 12.0;
  const double balls = 2.0 * 4.0 / 3.0 * kPi * r * r * r;
  const TriangleMesh bar = box_mesh({0.7, 0.1, 0.1});
  const std::vector<Volume> two{Sphere{{d / 2.0, 0.0, 0.0}, r}, Sphere{{-d / 2.0, 0.0, 0.0}, r}};
  EXPECT_NEAR(outside_volume_m3(bar, two, 128), balls - lens - 0.007, 0.01);
  std::vector<Volume> doubled = two;
  doubled.insert(doubled.end(), two.begin(), two.end());
  EXPECT_EQ(outside_volume_m3(bar, doubled, 128), outside_volume_m3(bar, two, 128));
}

TEST(LevelQuality, TheGridFindsTheVolumeOfEveryKindAndLeavesOutTheSolid) {
  RandomStream random(73, "kinds");
  const TriangleMesh far = [] {
    TriangleMesh mesh = box_mesh({0.1, 0.1, 0.1});
    for (Vector3& vertex : mesh.vertices) {
      vertex.x() += 50.0;
    }
    return mesh;
  }();
  for (const Volume& volume : one_of_each_kind(random, {0.1, 0.2, 0.3}, 1.0)) {
    EXPECT_NEAR(outside_volume_m3(far, {volume}, 96) / content_m3(volume), 1.0, 0.01)
        << "kind " << volume.index();
  }
  const TriangleMesh block = about_centre_of_mass(l_block_mesh(2.0, 0.7));
  const double solid_m3 = solid_of(block, 1.0).volume_m3;
  const Sphere round{Vector3::Zero(), 2.0};
  EXPECT_NEAR(content_m3(round) - outside_volume_m3(block, {round}, 128), solid_m3,
              0.01 * content_m3(round));
}

TEST(LevelQuality, FallsFromLevelToLevelAndAddsUp) {
  const TriangleMesh solid = about_centre_of_mass(l_block_mesh(2.0, 0.7));
  const VolumeTree tree = build_tree(solid, {TreeKind::kOctree, 4, 8});
  std::vector<double> shares;
  const std::vector<LevelQuality> levels =
      measure_levels(solid, tree, [&](double share) { shares.push_back(share); });
  ASSERT_EQ(levels.size(), static_cast<std::size_t>(tree.level_count()));
  std::size_t bytes = 0;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const LevelQuality& here = levels[level];
    EXPECT_EQ(here.nodes,
              static_cast<std::int32_t>(tree.standing_at(static_cast<int>(level)).size()));
    EXPECT_EQ(here.uncovered_area_m2, 0.0);
    EXPECT_LE(here.mean_protrusion_m, here.worst_protrusion_m);
    EXPECT_LE(here.worst_protrusion_m, tree.fit_error_m(static_cast<int>(level)) * 1.02);
    bytes += here.bytes;
    if (level > 0) {
      EXPECT_LT(here.mean_protrusion_m, levels[level - 1].mean_protrusion_m);
      EXPECT_LT(here.outside_ratio, levels[level - 1].outside_ratio);
    }
  }
  EXPECT_LE(bytes, tree.bytes());
  constexpr std::size_t kReadableBeyond = 4 * (kLanes - 1) * sizeof(double);
  EXPECT_GT(bytes, tree.bytes() - 200 - kReadableBeyond) << "but for what is kept by level";
  EXPECT_EQ(shares.front(), 0.0);
  EXPECT_EQ(shares.back(), 1.0);
}

TEST(LevelQuality, ProgressMayAbandonIt) {
  const TriangleMesh solid = box_mesh({1.0, 1.0, 1.0});
  const VolumeTree tree = single_node_tree(Sphere{Vector3::Zero(), 1.0});
  EXPECT_THROW(measure_levels(solid, tree, [](double) { throw std::runtime_error("enough"); }),
               std::runtime_error);
}

}  // namespace impetus::level_quality_test
