// The octree: coverage proved by clipping, conservative against the triangle oracle, resumable.
// SPDX-License-Identifier: MIT
#include "engine/trees/builders/octree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/collision/pair_refinement.hpp"
#include "engine/shapes/mesh_distance.hpp"
#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/shapes/surface_distance.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/mesh_oracles.hpp"

namespace impetus::octree_test {

constexpr std::uint64_t kSeed = 419;

struct NamedSolid {
  const char* name;
  TriangleMesh mesh;
  int depth;
};

std::vector<NamedSolid> solids() {
  return {{"box", box_mesh({1.0, 0.6, 0.35}), 4},
          {"dyadic box", box_mesh({1.0, 0.5, 0.25}), 4},
          {"L-block", about_centre_of_mass(l_block_mesh(2.0, 0.7)), 5},
          {"dyadic L-block", about_centre_of_mass(l_block_mesh(2.0, 0.5)), 4},
          {"icosphere", icosphere_mesh(0.4, 2), 4}};
}

/// A second clipper than the builder's, in extended precision.
using Exact = Eigen::Matrix<long double, 3, 1>;
using Polygon = std::vector<Exact>;

Polygon half_of(const Polygon& polygon, int axis, long double at, long double sign) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Exact& from = polygon[i];
    const Exact& to = polygon[(i + 1) % polygon.size()];
    const long double h_from = sign * (from[axis] - at);
    const long double h_to = sign * (to[axis] - at);
    if (h_from >= 0.0L) {
      kept.push_back(from);
    }
    if (h_from * h_to < 0.0L) {
      kept.push_back(from + h_from / (h_from - h_to) * (to - from));
    }
  }
  return kept;
}

/// The cell is grown by the builder's snapping distance, 1e-13 of the size.
Polygon clipped_to(const Bounds& cell, const TriangleMesh& mesh, std::size_t triangle) {
  constexpr long double kGrown = 3e-13L;
  Polygon polygon;
  for (const std::uint32_t vertex : mesh.triangles[triangle]) {
    polygon.push_back(mesh.vertices[vertex].cast<long double>());
  }
  for (int axis = 0; axis < 3; ++axis) {
    polygon = half_of(polygon, axis, cell.least[axis] - kGrown, 1.0L);
    polygon = half_of(polygon, axis, cell.most[axis] + kGrown, -1.0L);
  }
  return polygon;
}

Bounds shrunk(const Bounds& cell) {
  const Vector3 by = Vector3::Constant(1e-12);
  return {cell.least + by, cell.most - by};
}

long double area_of(const Polygon& polygon) {
  Exact twice = Exact::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    twice += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
  }
  return twice.norm() / 2.0L;
}

bool holds(const Sphere& sphere, const Polygon& polygon) {
  // A polygon lies in a sphere when its corners do.
  return std::all_of(polygon.begin(), polygon.end(), [&](const Exact& corner) {
    return (corner - sphere.centre.cast<long double>()).norm() <=
           static_cast<long double>(sphere.radius_m);
  });
}

Sphere sphere_of(const VolumeTree& tree, std::int32_t node) {
  return std::get<Sphere>(tree.volume(node));
}

TEST(Octree, EveryLevelCoversTheWholeSurface) {
  // Proof: within its cell each node holds the surface clipped to that cell, and the clipped areas
  // add up to the triangle's. Facets on a wall between cells may count twice, never not at all.
  for (const auto& [name, mesh, depth] : solids()) {
    const Octree octree = build_octree(mesh, depth);
    ASSERT_EQ(octree.cells.size(), static_cast<std::size_t>(octree.tree.node_count()));
    ASSERT_GT(octree.tree.level_count(), 3) << name;
    for (int level = 0; level < octree.tree.level_count(); ++level) {
      const std::vector<std::int32_t> nodes = octree.tree.standing_at(level);
      for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        long double held = 0.0L;
        for (const std::int32_t index : nodes) {
          const Bounds& cell = octree.cells[static_cast<std::size_t>(index)];
          const Polygon polygon = clipped_to(cell, mesh, triangle);
          if (holds(sphere_of(octree.tree, index), polygon)) {
            held += area_of(polygon);
          }
        }
        Polygon whole;
        for (const std::uint32_t vertex : mesh.triangles[triangle]) {
          whole.push_back(mesh.vertices[vertex].cast<long double>());
        }
        ASSERT_GT(held, area_of(whole) * (1.0L - 1e-15L))
            << name << ", level " << level << ", triangle " << triangle;
      }
    }
  }
}

TEST(Octree, EveryNodeHoldsAllOfTheSurfaceInItsCell) {
  for (const auto& [name, mesh, depth] : solids()) {
    const Octree octree = build_octree(mesh, depth);
    for (std::int32_t index = 0; index < octree.tree.node_count(); ++index) {
      const Bounds& cell = octree.cells[static_cast<std::size_t>(index)];
      for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const Polygon polygon = clipped_to(cell, mesh, triangle);
        // What reaches in by no more than the snapping belongs to the neighbour.
        const bool within = !clipped_to(shrunk(cell), mesh, triangle).empty();
        if (within) {
          ASSERT_TRUE(holds(sphere_of(octree.tree, index), polygon)) << name << ", node " << index;
        }
      }
    }
  }
}

TEST(Octree, AChildsPartLiesInItsParents) {
  for (const auto& [name, mesh, depth] : solids()) {
    const Octree octree = build_octree(mesh, depth);
    for (std::int32_t index = 0; index < octree.tree.node_count(); ++index) {
      const NodeLinks& node = octree.tree.links(index);
      const Bounds& outer = octree.cells[static_cast<std::size_t>(index)];
      for (std::int32_t child = node.first_child; child < node.first_child + node.child_count;
           ++child) {
        const Bounds& inner = octree.cells[static_cast<std::size_t>(child)];
        ASSERT_TRUE((inner.least.array() >= outer.least.array()).all()) << name;
        ASSERT_TRUE((inner.most.array() <= outer.most.array()).all()) << name;
        ASSERT_TRUE((inner.least.array() < inner.most.array()).all()) << name;
      }
    }
  }
}

TEST(Octree, CoversTheInsideToo) {
  RandomStream random(kSeed, "inside");
  for (const auto& [name, mesh, depth] : solids()) {
    const VolumeTree tree = octree(mesh, depth);
    for (int level = 0; level < tree.level_count(); ++level) {
      const std::vector<std::int32_t> nodes = tree.standing_at(level);
      for (int trial = 0; trial < 200; ++trial) {
        const Vector3 point = random_in_cube(random, 1.0);
        const bool held = std::any_of(nodes.begin(), nodes.end(), [&](std::int32_t index) {
          return overlap(sphere_of(tree, index), Sphere{point, 0.0});
        });
        ASSERT_TRUE(held || !contains(mesh, point)) << name << ", level " << level;
      }
    }
  }
}

TEST(Octree, RootLiesAboutTheCentreOfMassAndTouchesTheFarthestVertex) {
  const TriangleMesh mesh = about_centre_of_mass(l_block_mesh(2.0, 0.7));
  const Sphere root = sphere_of(octree(mesh, 2), 0);
  double farthest = 0.0;
  for (const Vector3& vertex : mesh.vertices) {
    farthest = std::max(farthest, vertex.norm());
  }
  EXPECT_EQ(root.centre, Vector3::Zero());
  EXPECT_GE(root.radius_m, farthest);
  EXPECT_NEAR(root.radius_m, farthest, 1e-10) << "but for the margin";
}

TEST(Octree, FitErrorBoundsHowFarNodesReachBeyondTheSolidAndFallsWithDepth) {
  RandomStream random(kSeed, "fit error");
  for (const auto& [name, mesh, depth] : solids()) {
    const VolumeTree tree = octree(mesh, depth);
    for (int level = 0; level < tree.level_count(); ++level) {
      double worst = 0.0;
      for (const std::int32_t index : tree.standing_at(level)) {
        const Sphere sphere = sphere_of(tree, index);
        for (int sample = 0; sample < 30; ++sample) {
          const Vector3 point = sphere.centre + sphere.radius_m * random_direction(random);
          if (!contains(mesh, point)) {
            worst = std::max(worst, distance_to_surface(mesh, point));
          }
        }
      }
      EXPECT_LE(worst, tree.fit_error_m(level)) << name << ", level " << level;
      EXPECT_GT(worst, 0.3 * tree.fit_error_m(level)) << name << ": a bound that says little";
      // A cell round an inner corner may fit no better than its parent; a sphere's root cannot be
      // bettered. Over two levels everything else does.
      if (level > 2) {
        EXPECT_LT(tree.fit_error_m(level), 0.7 * tree.fit_error_m(level - 2)) << name << level;
      }
    }
    EXPECT_EQ(tree.fit_error_m(99), tree.fit_error_m(tree.level_count() - 1));
  }
}

TEST(Octree, IsTheSameEveryTimeAndQuick) {
  const TriangleMesh mesh = small_l_block();
  const auto start = std::chrono::steady_clock::now();
  const VolumeTree once = octree(mesh, 4);
  const auto end = std::chrono::steady_clock::now();
  RecordProperty("ms",
                 std::to_string(std::chrono::duration<double, std::milli>(end - start).count()));
  const VolumeTree again = octree(mesh, 4);
  ASSERT_EQ(once.node_count(), again.node_count());
  for (std::int32_t index = 0; index < once.node_count(); ++index) {
    ASSERT_EQ(sphere_of(once, index).centre, sphere_of(again, index).centre);
    ASSERT_EQ(sphere_of(once, index).radius_m, sphere_of(again, index).radius_m);
  }
}

/// What the trees say at each level, deepest first to stop at 'separated'.
void expect_conservative(const TriangleMesh& mesh, int depth, double spread, int poses) {
  RandomStream random(kSeed, "conservative");
  const VolumeTree tree = octree(mesh, depth);
  PlacedTree a(tree);
  PlacedTree b(tree);
  int met = 0;
  int said = 0;
  for (int trial = 0; trial < poses; ++trial) {
    const Pose pose_a{Vector3::Zero(), random_turn(random)};
    const Pose pose_b{spread * random_direction(random) * std::cbrt(random.uniform()),
                      random_turn(random)};
    a.move_to(pose_a);
    b.move_to(pose_b);
    PairRefinement pair(a, b);
    while (!pair.resolved()) {
      pair.refine_one_block();
    }
    const bool exact = intersects(mesh, pose_a, mesh, pose_b);
    ASSERT_TRUE(!exact || !pair.overlapping().empty()) << "seed " << kSeed << ", pose " << trial;
    met += exact ? 1 : 0;
    said += pair.overlapping().empty() ? 0 : 1;
  }
  EXPECT_GT(met, poses / 10);
  EXPECT_LT(said, poses * 9 / 10) << "everything is called a collision";
  ::testing::Test::RecordProperty("exact", met);
  ::testing::Test::RecordProperty("called", said);
}

TEST(Octree, MissesNoCollisionOfTwoLBlocks) {
  expect_conservative(about_centre_of_mass(l_block_mesh(2.0, 0.7)), 4, 2.8, 5'000);
}

TEST(Octree, MissesNoCollisionOfTwoBoxes) {
  expect_conservative(box_mesh({1.0, 0.6, 0.35}), 4, 1.3, 5'000);
}

TEST(Octree, FindsABodyInsideAnother) {
  const VolumeTree outer = octree(box_mesh({1.0, 1.0, 1.0}), 4);
  const VolumeTree inner = octree(box_mesh({0.01, 0.01, 0.01}), 2);
  PlacedTree a(outer);
  PlacedTree b(inner);
  b.move_to({Vector3(0.11, 0.23, -0.17), Quaternion::Identity()});
  PairRefinement pair(a, b);
  while (!pair.resolved()) {
    pair.refine_one_block();
  }
  EXPECT_FALSE(pair.overlapping().empty());
}

TEST(Octree, InterruptedThenResumedEqualsUninterrupted) {
  RandomStream random(kSeed, "resumed");
  const VolumeTree tree = octree(small_l_block(), 4);
  PlacedTree a(tree);
  PlacedTree b(tree);
  std::size_t contacts = 0;
  for (int trial = 0; trial < 40; ++trial) {
    a.move_to({Vector3::Zero(), random_turn(random)});
    b.move_to({0.16 * random_direction(random), random_turn(random)});
    PairRefinement whole(a, b);
    while (!whole.resolved()) {
      whole.refine_one_block();
    }
    PairRefinement sliced(a, b);
    while (!sliced.resolved()) {
      PairRefinement resumed = sliced;  // as if put away after this block
      resumed.refine_one_block();
      sliced = resumed;
    }
    ASSERT_EQ(sliced.overlapping(), whole.overlapping());
    ASSERT_EQ(sliced.level(), whole.level());
    contacts += whole.overlapping().size();
  }
  EXPECT_GT(contacts, 100U);
}

TEST(Octree, StopsAtTheGreatestLevelAndSaysSo) {
  const VolumeTree tree = octree(small_l_block(), 4);
  PlacedTree a(tree);
  PlacedTree b(tree);
  b.move_to({Vector3(0.05, 0.0, 0.0), Quaternion::Identity()});
  for (int greatest = 0; greatest <= 6; ++greatest) {
    PairRefinement pair(a, b, greatest);
    while (!pair.resolved()) {
      pair.refine_one_block();
    }
    EXPECT_EQ(pair.level(), std::min(greatest, 4));
    EXPECT_EQ(pair.stop_reason(), greatest < 4 ? StopReason::kGreatestLevel : StopReason::kFinest);
  }
}

std::string refusal_of(const TriangleMesh& mesh, int depth) {
  try {
    octree(mesh, depth);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Octree, RefusesWhatIsNoSolid) {
  TriangleMesh open = box_mesh({1.0, 1.0, 1.0});
  open.triangles.pop_back();
  TriangleMesh inside_out = box_mesh({1.0, 1.0, 1.0});
  for (auto& triangle : inside_out.triangles) {
    std::swap(triangle[0], triangle[1]);
  }
  const std::string not_closed = "octree: expected a closed mesh with its triangles facing outward";
  EXPECT_EQ(refusal_of(open, 2), not_closed);
  EXPECT_EQ(refusal_of(inside_out, 2), not_closed);
  EXPECT_EQ(refusal_of({}, 2), not_closed);
  EXPECT_EQ(refusal_of(box_mesh({1.0, 1.0, 1.0}), 9),
            "octree: expected a depth from 0 to 8, got 9");
  EXPECT_EQ(refusal_of(box_mesh({1.0, 1.0, 1.0}), -1),
            "octree: expected a depth from 0 to 8, got -1");
}

}  // namespace impetus::octree_test
