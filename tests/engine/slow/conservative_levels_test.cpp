// Trees of every kind against the exact surfaces: 10,000 random poses of pairs of meshes, by FCL,
// the Flexible Collision Library (Pan et al. 2012).
//
//   conservative  exact surfaces that intersect are never called separate, at any level
//   converging    false collisions fall with every level
//   bounded       whoever is called touching is no further apart than both fit errors allow
//
// SPDX-License-Identifier: MIT
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "engine/collision/pair_refinement.hpp"
#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/shapes/solids/creature_mesh.hpp"
#include "engine/shapes/solids/ring_meshes.hpp"
#include "engine/shapes/surface_distance.hpp"
#include "engine/trees/builders/build_tree.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::conservative_levels_test {

constexpr std::uint64_t kSeed = 510;
constexpr int kPoses = 10'000;
constexpr int kDepth = 3;

using Surface = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<Surface> surface_of(const TriangleMesh& mesh) {
  auto surface = std::make_shared<Surface>();
  surface->beginModel(static_cast<int>(mesh.triangles.size()),
                      static_cast<int>(mesh.vertices.size()));
  for (const auto& [i, j, k] : mesh.triangles) {
    surface->addTriangle(mesh.vertices[i], mesh.vertices[j], mesh.vertices[k]);
  }
  surface->endModel();
  return surface;
}

struct Solid {
  TriangleMesh mesh;
  std::shared_ptr<Surface> surface;
  std::vector<VolumeTree> trees;  ///< one of each kind
};

Solid solid(const TriangleMesh& shape) {
  Solid made{about_centre_of_mass(shape), nullptr, {}};
  made.surface = surface_of(made.mesh);
  for (const std::string& kind : tree_kind_names()) {
    made.trees.push_back(build_tree(made.mesh, {tree_kind(kind), kDepth}));
  }
  return made;
}

std::vector<Solid> all_solids() {
  std::vector<Solid> solids;
  solids.push_back(solid(box_mesh({0.5, 0.3, 0.2})));
  solids.push_back(solid(l_block_mesh(1.0, 0.35)));
  solids.push_back(solid(icosphere_mesh(0.4, 2)));
  solids.push_back(solid(torus_mesh(0.4, 0.12, 20, 10)));
  solids.push_back(solid(creature_mesh(1.0, 16)));
  return solids;
}

fcl::CollisionObjectd placed_surface(const Solid& solid, const Pose& pose) {
  return {solid.surface, pose.orientation.toRotationMatrix(), pose.position};
}

/// Zero when the surfaces intersect.
double exact_distance_m(const Solid& a, const Pose& at_a, const Solid& b, const Pose& at_b) {
  fcl::CollisionObjectd object_a = placed_surface(a, at_a);
  fcl::CollisionObjectd object_b = placed_surface(b, at_b);
  fcl::CollisionResultd collision;
  if (fcl::collide(&object_a, &object_b, fcl::CollisionRequestd(), collision) > 0) {
    return 0.0;
  }
  fcl::DistanceResultd distance;
  return fcl::distance(&object_a, &object_b, fcl::DistanceRequestd(), distance);
}

bool one_inside_the_other(const Solid& a, const Pose& at_a, const Solid& b, const Pose& at_b) {
  const auto in = [](const Vector3& point, const Pose& from, const Solid& other, const Pose& to) {
    const Vector3 world = from.transform(point);
    return contains(other.mesh, to.orientation.conjugate() * Vector3(world - to.position));
  };
  return in(a.mesh.vertices.front(), at_a, b, at_b) || in(b.mesh.vertices.front(), at_b, a, at_a);
}

struct Tally {
  int separate{0};                    ///< exactly
  std::vector<int> false_collisions;  ///< by level
};

/// Follows the descent of one pair of trees level by level.
void check_levels(const VolumeTree& of_a, const Pose& at_a, const VolumeTree& of_b,
                  const Pose& at_b, double distance_m, Tally& tally, const std::string& place) {
  PlacedTree a(of_a);
  PlacedTree b(of_b);
  a.move_to(at_a);
  b.move_to(at_b);
  PairRefinement pair(a, b);
  tally.separate += distance_m > 0.0 ? 1 : 0;
  for (int level = 0; level <= kDepth; ++level) {
    while (pair.level() < level && !pair.resolved()) {
      pair.refine_one_block();
    }
    const bool touching = !pair.overlapping().empty();
    if (distance_m == 0.0) {
      ASSERT_TRUE(touching) << place << ", level " << level << ": missed";
    } else if (touching) {
      ++tally.false_collisions[static_cast<std::size_t>(level)];
      const double allowed_m = of_a.fit_error_m(level) + of_b.fit_error_m(level);
      ASSERT_LE(distance_m, allowed_m * (1.0 + 1e-9) + 1e-9) << place << ", level " << level;
    }
  }
}

TEST(ConservativeLevels, NoTouchIsMissedAndFalseOnesFallWithEveryLevel) {
  const std::vector<Solid> solids = all_solids();
  const std::size_t kinds = tree_kind_names().size();
  const Tally none{0, std::vector<int>(kDepth + 1, 0)};
  std::vector<Tally> of_kind(kinds, none);
  Tally mixed = none;
  RandomStream random(kSeed, "poses");
  int intersecting = 0;
  for (int trial = 0; trial < kPoses; ++trial) {
    const Solid& a = solids[random.below(solids.size())];
    const Solid& b = solids[random.below(solids.size())];
    const Pose at_a{random_in_cube(random, 1.0), random_turn(random)};
    const double reach_m =
        a.trees.front().bounding_radius_m() + b.trees.front().bounding_radius_m();
    const Pose at_b{
        at_a.position + uniform_in(random, 0.3, 1.0) * reach_m * random_direction(random),
        random_turn(random)};
    const double distance_m = exact_distance_m(a, at_a, b, at_b);
    if (distance_m > 0.0 && one_inside_the_other(a, at_a, b, at_b)) {
      continue;  // solids that touch, surfaces that do not
    }
    intersecting += distance_m == 0.0 ? 1 : 0;
    const std::string place = "seed " + std::to_string(kSeed) + ", pose " + std::to_string(trial);
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      check_levels(a.trees[kind], at_a, b.trees[kind], at_b, distance_m, of_kind[kind],
                   place + ", " + tree_kind_names()[kind]);
    }
    const std::size_t one = random.below(kinds);
    const std::size_t other = random.below(kinds);
    check_levels(a.trees[one], at_a, b.trees[other], at_b, distance_m, mixed,
                 place + ", " + tree_kind_names()[one] + " and " + tree_kind_names()[other]);
    if (HasFatalFailure()) {
      return;
    }
  }
  EXPECT_GT(intersecting, kPoses / 5);
  of_kind.push_back(mixed);
  for (std::size_t kind = 0; kind <= kinds; ++kind) {
    const Tally& tally = of_kind[kind];
    std::string row = kind < kinds ? tree_kind_names()[kind] : "mixed";
    for (int level = 0; level <= kDepth; ++level) {
      const int count = tally.false_collisions[static_cast<std::size_t>(level)];
      row += " " + std::to_string(count);
      if (level > 0) {
        EXPECT_LT(count, tally.false_collisions[static_cast<std::size_t>(level) - 1]) << row;
      }
    }
    std::printf("%s of %d separate\n", row.c_str(), tally.separate);
  }
}

}  // namespace impetus::conservative_levels_test
