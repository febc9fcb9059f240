// The medial sphere-tree: its parts tile the surface, its nodes hold them, and it is tight.
// SPDX-License-Identifier: MIT
#include "engine/trees/builders/medial_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/collision/pair_refinement.hpp"
#include "engine/shapes/mesh_distance.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/shapes/solids/creature_mesh.hpp"
#include "engine/shapes/solids/ring_meshes.hpp"
#include "engine/trees/builders/build_tree.hpp"
#include "engine/trees/builders/medial_balls.hpp"
#include "engine/trees/surface_part.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/mesh_oracles.hpp"

namespace impetus::medial_tree_test {

constexpr std::uint64_t kSeed = 1996;

TreeSettings medial(int depth, int branching = 8) { return {TreeKind::kMedial, depth, branching}; }

struct NamedSolid {
  const char* name;
  TriangleMesh mesh;
};

TriangleMesh scaled_mesh(TriangleMesh mesh, double by) {
  for (Vector3& vertex : mesh.vertices) {
    vertex *= by;
  }
  return mesh;
}

/// Two boxes that do not touch, in one mesh.
TriangleMesh two_bodies() {
  TriangleMesh both = box_mesh({0.4, 0.5, 0.6});
  TriangleMesh other = box_mesh({0.3, 0.3, 0.3});
  const auto shift = static_cast<std::uint32_t>(both.vertices.size());
  for (Vector3& vertex : other.vertices) {
    both.vertices.push_back(vertex + Vector3(1.0, 0.2, 0.0));
  }
  for (const auto& [a, b, c] : other.triangles) {
    both.triangles.push_back({a + shift, b + shift, c + shift});
  }
  return about_centre_of_mass(both);
}

std::vector<NamedSolid> solids() {
  return {
      {"box", box_mesh({1.0, 0.6, 0.35})},          {"thin plate", box_mesh({1.0, 0.8, 0.002})},
      {"needle", box_mesh({1.0, 1e-4, 1e-4})},      {"L-block", small_l_block()},
      {"torus", torus_mesh(0.5, 0.2, 24, 10)},      {"two bodies", two_bodies()},
      {"tiny", scaled_mesh(small_l_block(), 1e-6)}, {"huge", scaled_mesh(small_l_block(), 1e6)}};
}

void expect_held(const char* name, const BuiltTree& built) {
  ASSERT_EQ(built.parts.size(), static_cast<std::size_t>(built.tree.node_count())) << name;
  for (std::int32_t node = 0; node < built.tree.node_count(); ++node) {
    const Volume volume = built.tree.volume(node);
    for (const Vector3& corner : corners_of(built.parts[static_cast<std::size_t>(node)])) {
      ASSERT_TRUE(holds(volume, corner)) << name << ", node " << node;
    }
  }
}

void expect_tiled(const char* name, const BuiltTree& built, const TriangleMesh& mesh) {
  const auto part_of = [&](std::int32_t node) -> const SurfacePart& {
    return built.parts[static_cast<std::size_t>(node)];
  };
  EXPECT_EQ(area_m2(part_of(0)), area_m2(whole_surface(mesh))) << name;
  for (std::int32_t node = 0; node < built.tree.node_count(); ++node) {
    const auto& [first, count] = built.tree.links(node);
    double sum_m2 = 0.0;
    for (std::int32_t child = first; child < first + count; ++child) {
      sum_m2 += area_m2(part_of(child));
    }
    // Sums of up to some thousand areas: rounding stays far below 1e-11 of the whole.
    ASSERT_TRUE(count == 0 ||
                std::abs(sum_m2 - area_m2(part_of(node))) <= 1e-11 * area_m2(part_of(0)))
        << name << ", node " << node;
  }
}

TEST(MedialTree, EveryNodeHoldsItsPartAndThePartsOfChildrenTileTheirParents) {
  for (const auto& [name, mesh] : solids()) {
    const BuiltTree built = medial_tree(mesh, medial(2, 6));
    expect_held(name, built);
    expect_tiled(name, built, mesh);
  }
}

TEST(MedialTree, NoNodeHasMoreChildrenThanAskedAndEachLevelFitsBetter) {
  const TriangleMesh mesh = about_centre_of_mass(creature_mesh(1.0, 16));
  for (const int branching : {2, 5}) {
    const VolumeTree tree = medial_tree(mesh, medial(2, branching)).tree;
    EXPECT_EQ(tree.level_count(), 3);
    for (std::int32_t node = 0; node < tree.node_count(); ++node) {
      ASSERT_LE(tree.links(node).child_count, branching);
    }
    for (int level = 1; level < tree.level_count(); ++level) {
      EXPECT_LT(tree.fit_error_m(level), tree.fit_error_m(level - 1)) << branching;
    }
  }
}

TEST(MedialTree, FitsTighterThanTheOctreeAtEveryLevel) {
  const TriangleMesh mesh = about_centre_of_mass(creature_mesh(1.0, 16));
  const VolumeTree medial_spheres = build_tree(mesh, medial(2));
  const VolumeTree octree_spheres = build_tree(mesh, {TreeKind::kOctree, 2, 8});
  for (int level = 0; level < 3; ++level) {
    EXPECT_LE(medial_spheres.fit_error_m(level), octree_spheres.fit_error_m(level)) << level;
    RecordProperty(
        "medial over octree, level " + std::to_string(level),
        std::to_string(medial_spheres.fit_error_m(level) / octree_spheres.fit_error_m(level)));
  }
  EXPECT_LT(medial_spheres.fit_error_m(2), 0.5 * octree_spheres.fit_error_m(2));
}

TEST(MedialTree, IsTheSameEveryTime) {
  const VolumeTree once = build_tree(small_l_block(), medial(2));
  const VolumeTree again = build_tree(small_l_block(), medial(2));
  ASSERT_EQ(once.node_count(), again.node_count());
  for (std::int32_t node = 0; node < once.node_count(); ++node) {
    const auto a = std::get<Sphere>(once.volume(node));
    const auto b = std::get<Sphere>(again.volume(node));
    ASSERT_EQ(a.centre, b.centre);
    ASSERT_EQ(a.radius_m, b.radius_m);
    ASSERT_EQ(once.surface(node), again.surface(node));
  }
}

TEST(BuildTree, RefusesWhatIsNoSolidAndWhatNoTreeCanBe) {
  const auto refusal = [](const TriangleMesh& mesh, const TreeSettings& settings) {
    try {
      build_tree(mesh, settings);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  TriangleMesh open = box_mesh({1.0, 1.0, 1.0});
  open.triangles.pop_back();
  const char* not_solid = "tree: expected a closed mesh with its triangles facing outward";
  EXPECT_EQ(refusal(open, medial(1)), not_solid);
  EXPECT_EQ(refusal({}, medial(1)), not_solid);
  EXPECT_EQ(refusal(box_mesh({1.0, 1.0, 1.0}), medial(9)),
            "tree: expected a depth from 0 to 8, got 9");
  EXPECT_EQ(refusal(box_mesh({1.0, 1.0, 1.0}), medial(1, 1)),
            "tree: expected a branching from 2 to 64, got 1");
  EXPECT_EQ(refusal(box_mesh({1.0, 1.0, 1.0}), {TreeKind::kOctree, 1, 4}),
            "tree: expected a branching of 8 for an octree, got 4");
  EXPECT_EQ(refusal(box_mesh({1.0, 1.0, 1.0}), {TreeKind::kVoxel, 1, 9}),
            "tree: expected a branching of 8, 27 or 64 for voxels, got 9");
}

TEST(TreeKind, IsFoundByItsNameAndRefusedByNames) {
  for (const std::string& name : tree_kind_names()) {
    EXPECT_EQ(name_of(tree_kind(name)), name);
  }
  try {
    tree_kind("oak");
    ADD_FAILURE() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "tree: expected a kind among octree, medial, voxel, box, swept, heterogeneous, "
                 "got \"oak\"");
  }
}

TEST(MedialTree, TellsHowFarItHasCome) {
  std::vector<double> shares;
  build_tree(small_l_block(), medial(2), [&](double share) { shares.push_back(share); });
  ASSERT_GT(shares.size(), 5U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GE(shares.front(), 0.0);
  EXPECT_LE(shares.back(), 1.0);
}

TEST(MedialTree, MissesNoCollision) {
  RandomStream random(kSeed, "poses");
  for (const TriangleMesh& mesh : {small_l_block(), torus_mesh(0.1, 0.04, 16, 8)}) {
    const VolumeTree tree = build_tree(mesh, medial(2));
    PlacedTree a(tree);
    PlacedTree b(tree);
    int met = 0;
    for (int trial = 0; trial < 400; ++trial) {
      const Pose pose_a{Vector3::Zero(), random_turn(random)};
      const Pose pose_b{random_in_cube(random, 0.2), random_turn(random)};
      a.move_to(pose_a);
      b.move_to(pose_b);
      PairRefinement pair(a, b);
      while (!pair.resolved()) {
        pair.refine_one_block();
      }
      const bool exact = intersects(mesh, pose_a, mesh, pose_b);
      ASSERT_TRUE(!exact || !pair.overlapping().empty()) << "seed " << kSeed << ", pose " << trial;
      met += exact ? 1 : 0;
    }
    EXPECT_GT(met, 40);
  }
}

TEST(MedialBall, TouchesAtTheSampleAndHoldsNothingOfTheSurface) {
  const TriangleMesh mesh = torus_mesh(0.5, 0.2, 40, 16);
  const SurfaceDistance surface(mesh);
  for (const SurfaceSample& sample : samples_of(whole_surface(mesh), 200)) {
    const InnerPoint ball = medial_ball(surface, sample, 2.0);
    // The shrinking stops within a thousandth.
    EXPECT_NEAR((ball.point - sample.point).norm(), ball.depth_m, 2e-3 * ball.depth_m);
    // Beside the edges between flat faces it is smaller than the tube of radius .2.
    EXPECT_GT(ball.depth_m, 0.12);
  }
}

TEST(PowerCells, APieceIsNearestToItsSphereByPower) {
  RandomStream random(kSeed, "power");
  const SurfacePart whole = whole_surface(torus_mesh(0.5, 0.2, 24, 10));
  std::vector<Sphere> spheres;
  for (int i = 0; i < 7; ++i) {
    spheres.push_back({random_in_cube(random, 0.6), uniform_in(random, 0.1, 0.6)});
  }
  const std::vector<SurfacePart> cells = power_cells(whole, spheres);
  double sum_m2 = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    sum_m2 += area_m2(cells[i]);
    for (const Facet& facet : cells[i]) {
      Vector3 middle = Vector3::Zero();
      for (const Vector3& corner : facet.corners) {
        middle += corner / static_cast<double>(facet.corners.size());
      }
      if (doubled_area_vector(facet).norm() > 1e-9) {
        ASSERT_EQ(least_power(spheres, middle), i);
      }
    }
  }
  EXPECT_NEAR(sum_m2, area_m2(whole), 1e-12);
}

}  // namespace impetus::medial_tree_test
