// Trees of boxes, of swept spheres and of all kinds: covered by construction, tight, the same
// every time.
// SPDX-License-Identifier: MIT
#include "engine/trees/builders/fitted_tree.hpp"

#include <stdexcept>

#include "engine/shapes/mesh_distance.hpp"
#include "engine/shapes/surface_distance.hpp"
#include "engine/trees/builders/build_tree.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/built_solids.hpp"

namespace impetus::fitted_tree_test {

constexpr std::uint64_t kSeed = 3101;
constexpr TreeKind kFitted[] = {TreeKind::kBox, TreeKind::kSwept, TreeKind::kHeterogeneous};

TriangleMesh ring() { return torus_mesh(1.0, 0.3, 12, 6); }

/// Points on the surface of a volume of any kind: its bounding sphere's, drawn to it by bisection.
std::vector<Vector3> points_on(const Volume& volume, RandomStream& random, int count) {
  const Sphere bound = bounding_sphere(volume);
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i) {
    const Vector3 far = 1.001 * bound.radius_m * random_direction(random);
    double inside = 0.0;
    double outside = 1.0;
    for (int step = 0; step < 40; ++step) {
      const double middle = 0.5 * (inside + outside);
      (holds(volume, bound.centre + middle * far) ? inside : outside) = middle;
    }
    points.push_back(bound.centre + inside * far);
  }
  return points;
}

/// The greatest distance of such points from the solid, over the nodes that stand at `level`.
double measured_reach_m(const VolumeTree& tree, const SurfaceDistance& solid, int level) {
  RandomStream random(kSeed, "reach");
  double reach_m = 0.0;
  for (const std::int32_t node : tree.standing_at(level)) {
    for (const Vector3& point : points_on(tree.volume(node), random, 100)) {
      reach_m = std::max(reach_m, solid.signed_distance_m(point));
    }
  }
  return reach_m;
}

TEST(FittedTree, PartsTileTheSurfaceAndEveryNodeHoldsItsPart) {
  for (const auto& [name, mesh] : small_solids()) {
    for (const TreeKind kind : kFitted) {
      const BuiltTree built = build_fitted_tree(mesh, {kind, 2, 3});
      expect_covers(built, mesh, std::string(name) + ", " + name_of(kind));
    }
  }
}

TEST(FittedTree, CoversAnAnimalToo) {
  const TriangleMesh mesh = about_centre_of_mass(creature_mesh(1.0, 16));
  for (const TreeKind kind : kFitted) {
    expect_covers(build_fitted_tree(mesh, {kind, 1, 4}), mesh, name_of(kind));
  }
}

TEST(FittedTree, ACollisionPointLiesInNodesOfBothBodiesAtEveryLevel) {
  RandomStream random(kSeed, "collisions");
  const TriangleMesh mesh = about_centre_of_mass(l_block_mesh(2.0, 0.7));
  for (const TreeKind kind : kFitted) {
    const VolumeTree tree = build_tree(mesh, {kind, 2, 3});
    int met = 0;
    for (int trial = 0; trial < 300; ++trial) {
      const Pose a{Vector3::Zero(), random_turn(random)};
      const Pose b{1.4 * random_direction(random), random_turn(random)};
      const ClosestPoints closest = mesh_distance(mesh, a, mesh, b);
      if (closest.distance_m > 0.0) {
        continue;
      }
      ++met;
      const auto held = [&](const Pose& pose, int level) {
        const Vector3 point = pose.orientation.conjugate() * (closest.on_a - pose.position);
        const std::vector<std::int32_t> standing = tree.standing_at(level);
        return std::any_of(standing.begin(), standing.end(),
                           [&](std::int32_t node) { return holds(tree.volume(node), point); });
      };
      for (int level = 0; level < tree.level_count(); ++level) {
        ASSERT_TRUE(held(a, level) && held(b, level))
            << name_of(kind) << ", seed " << kSeed << ", pose " << trial << ", level " << level;
      }
    }
    EXPECT_GT(met, 30);
  }
}

TEST(FittedTree, ReachesLessLevelByLevelAndFarLessThanTheOctree) {
  const TriangleMesh mesh = ring();
  const SurfaceDistance solid(mesh);
  const double octree_m = measured_reach_m(build_tree(mesh, {TreeKind::kOctree, 2, 8}), solid, 2);
  for (const TreeKind kind : kFitted) {
    const VolumeTree tree = build_tree(mesh, {kind, 2, 8});
    ASSERT_EQ(tree.level_count(), 3);
    double coarser_m = measured_reach_m(tree, solid, 0);
    for (int level = 1; level < 3; ++level) {
      const double finer_m = measured_reach_m(tree, solid, level);
      EXPECT_LT(finer_m, 0.75 * coarser_m) << name_of(kind) << ", level " << level;
      coarser_m = finer_m;
    }
    EXPECT_LT(coarser_m, 0.5 * octree_m) << name_of(kind);
  }
}

TEST(FittedTree, ASphereOfABallIsTheWholeTree) {
  EXPECT_EQ(build_tree(icosphere_mesh(0.4, 5), {TreeKind::kSwept, 2, 3}).node_count(), 1);
}

TEST(FittedTree, ABoxOfABoxIsTheWholeTree) {
  const Quaternion turn = Quaternion(0.9, 0.3, -0.2, 0.1).normalized();
  const Vector3 sides(1.0, 0.6, 0.02);
  TriangleMesh mesh = box_mesh(sides);
  for (Vector3& vertex : mesh.vertices) {
    vertex = turn * vertex;
  }
  for (const TreeKind kind : {TreeKind::kBox, TreeKind::kHeterogeneous}) {
    const VolumeTree tree = build_fitted_tree(mesh, {kind, 5, 8}).tree;
    ASSERT_EQ(tree.node_count(), 1) << name_of(kind);
    EXPECT_NEAR(content_m3(tree.volume(0)), sides.prod(), 1e-9 * sides.prod());
  }
}

TEST(FittedTree, TwoBoxesAreAnLBlockExactly) {
  const TriangleMesh mesh = about_centre_of_mass(l_block_mesh(2.0, 0.7));
  for (const TreeKind kind : {TreeKind::kBox, TreeKind::kHeterogeneous}) {
    const VolumeTree tree = build_fitted_tree(mesh, {kind, 5, 8}).tree;
    ASSERT_EQ(tree.level_count(), 2) << name_of(kind);
    EXPECT_LT(measured_reach_m(tree, SurfaceDistance(mesh), 1), 1e-8) << name_of(kind);
  }
}

TEST(FittedTree, KindsHaveTheVolumesTheyAreNamedFor) {
  const TriangleMesh mesh = ring();
  const VolumeTree boxes = build_tree(mesh, {TreeKind::kBox, 1, 4});
  const VolumeTree swept = build_tree(mesh, {TreeKind::kSwept, 1, 4});
  for (std::int32_t node = 0; node < boxes.node_count(); ++node) {
    EXPECT_TRUE(std::holds_alternative<Box>(boxes.volume(node)));
  }
  for (std::int32_t node = 0; node < swept.node_count(); ++node) {
    EXPECT_LE(swept.volume(node).index(), 2U) << "a sphere, a line or a rectangle";
  }
  const VolumeTree ball = build_tree(icosphere_mesh(0.4, 2), {TreeKind::kHeterogeneous, 0, 8});
  EXPECT_TRUE(std::holds_alternative<Sphere>(ball.volume(0)));
}

TEST(FittedTree, NoNodeHasMoreChildrenThanTheBranchingNorIsDeeperThanAsked) {
  const TriangleMesh mesh = icosphere_mesh(0.4, 1);
  for (const int branching : {2, 5}) {
    const VolumeTree tree = build_tree(mesh, {TreeKind::kBox, 2, branching});
    EXPECT_EQ(tree.level_count(), 3);
    for (std::int32_t node = 0; node < tree.node_count(); ++node) {
      EXPECT_LE(tree.links(node).child_count, branching);
      EXPECT_NE(tree.links(node).child_count, 1);
    }
    EXPECT_EQ(tree.links(0).child_count, branching);
  }
  EXPECT_EQ(build_tree(mesh, {TreeKind::kSwept, 0, 8}).node_count(), 1);
}

TEST(FittedTree, IsTheSameEveryTime) {
  const TriangleMesh mesh = ring();
  for (const TreeKind kind : kFitted) {
    const VolumeTree once = build_tree(mesh, {kind, 2, 2});
    const VolumeTree again = build_tree(mesh, {kind, 2, 2});
    ASSERT_EQ(once.node_count(), again.node_count());
    for (std::int32_t node = 0; node < once.node_count(); ++node) {
      ASSERT_EQ(once.links(node), again.links(node));
      ASSERT_EQ(once.surface(node), again.surface(node));
      const Volume a = once.volume(node);
      const Volume b = again.volume(node);
      ASSERT_EQ(a.index(), b.index());
      ASSERT_EQ(bounding_sphere(a).centre, bounding_sphere(b).centre);
      ASSERT_EQ(bounding_sphere(a).radius_m, bounding_sphere(b).radius_m);
      ASSERT_EQ(content_m3(a), content_m3(b));
    }
  }
}

TEST(FittedTree, ProgressGrowsFromNothingToAllAndMayAbandonTheWork) {
  const TriangleMesh mesh = icosphere_mesh(0.4, 1);
  double last = 0.0;
  int calls = 0;
  build_tree(mesh, {TreeKind::kBox, 2, 4}, [&](double share) {
    EXPECT_GE(share, last);
    last = share;
    ++calls;
  });
  EXPECT_EQ(last, 1.0);
  EXPECT_GT(calls, 4);
  EXPECT_THROW(build_tree(mesh, {TreeKind::kBox, 2, 4}, [](double) { throw 5; }), int);
}

std::string refusal_of(const TriangleMesh& mesh, const TreeSettings& settings) {
  try {
    build_tree(mesh, settings);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(FittedTree, RefusesWhatIsNoSolid) {
  const TreeSettings settings{TreeKind::kBox, 2, 8};
  TriangleMesh open = box_mesh({1.0, 1.0, 1.0});
  open.triangles.pop_back();
  TriangleMesh inside_out = box_mesh({1.0, 1.0, 1.0});
  for (auto& triangle : inside_out.triangles) {
    std::swap(triangle[0], triangle[1]);
  }
  TriangleMesh flat = box_mesh({1.0, 1.0, 1.0});
  for (Vector3& vertex : flat.vertices) {
    vertex.z() *= 1e-14;
  }
  const std::string expected = ": expected a closed mesh with its triangles facing outward";
  EXPECT_EQ(refusal_of(open, settings), "tree" + expected);
  EXPECT_EQ(refusal_of(inside_out, {TreeKind::kSwept, 2, 8}), "tree" + expected);
  EXPECT_EQ(refusal_of({}, {TreeKind::kHeterogeneous, 2, 8}), "tree" + expected);
  EXPECT_EQ(refusal_of(open, {TreeKind::kVoxel, 2, 8}), "tree" + expected);
  EXPECT_EQ(refusal_of(flat, settings),
            "tree: expected a solid, got a mesh that encloses next to nothing");
  EXPECT_EQ(refusal_of(box_mesh({1.0, 1.0, 1.0}), {TreeKind::kBox, 9, 8}),
            "tree: expected a depth from 0 to 8, got 9");
  EXPECT_EQ(problem_of({TreeKind::kVoxel, 5, 64}), "");
  EXPECT_EQ(refusal_of(box_mesh({1.0, 1.0, 1.0}), {TreeKind::kVoxel, 6, 64}),
            "tree: expected a depth from 0 to 5 for voxels of branching 64, got 6");
}

}  // namespace impetus::fitted_tree_test
