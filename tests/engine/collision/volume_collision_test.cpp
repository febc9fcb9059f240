// Collision of trees whose nodes are of any kind: refinement against plain recursion, contacts
// both ways round, and walls.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/collision/contact_model.hpp"
#include "engine/world/starting_overlaps.hpp"
#include "tests/engine/once.hpp"
#include "tests/engine/random_volumes.hpp"

namespace impetus::volume_collision_test {

constexpr std::uint64_t kSeed = 44;
constexpr int kMixed = kKinds;  // nodes of every kind in one tree

/// A tree whose nodes sit where those of a random tree of spheres do, but are of another kind.
VolumeTree tree_of(RandomStream& random, int kind, int levels) {
  const VolumeTree spheres = random_tree(random, levels);
  std::vector<VolumeNode> nodes;
  std::vector<std::int32_t> starts;
  for (int level = 0; level < spheres.level_count(); ++level) {
    starts.push_back(spheres.level_begin(level));
  }
  for (std::int32_t node = 0; node < spheres.node_count(); ++node) {
    const Sphere place = bounding_sphere(spheres.volume(node));
    const int own_kind = kind == kMixed ? static_cast<int>(random.below(kKinds)) : kind;
    const Volume shape = random_volume(random, own_kind, Vector3::Zero());
    const double factor = place.radius_m / std::max(0.1, bounding_sphere(shape).radius_m);
    nodes.push_back({moved(scaled(shape, factor), place.centre),
                     spheres.links(node).first_child,
                     spheres.links(node).child_count,
                     {}});
  }
  return {nodes, starts};
}

struct Placed {
  const VolumeTree* tree;
  Pose pose;

  [[nodiscard]] Volume at(std::int32_t node) const { return placed(tree->volume(node), pose); }
};

std::vector<std::int32_t> nodes_one_deeper(const VolumeTree& tree, std::int32_t node) {
  const auto& [first, count] = tree.links(node);
  std::vector<std::int32_t> nodes;
  for (std::int32_t child = first; child < first + count; ++child) {
    nodes.push_back(child);
  }
  return count > 0 ? nodes : std::vector<std::int32_t>{node};
}

/// The oracle: descend both wherever the nodes overlap, with no frontier, cache or budget.
void descend(const Placed& a, const Placed& b, NodePair nodes, int levels,
             std::vector<NodePair>& found) {
  if (!overlap(a.at(nodes.a), b.at(nodes.b))) {
    return;
  }
  if (levels == 0) {
    found.push_back(nodes);
    return;
  }
  for (const std::int32_t i : nodes_one_deeper(*a.tree, nodes.a)) {
    for (const std::int32_t j : nodes_one_deeper(*b.tree, nodes.b)) {
      descend(a, b, {i, j}, levels - 1, found);
    }
  }
}

std::vector<NodePair> sorted(std::vector<NodePair> pairs) {
  std::sort(pairs.begin(), pairs.end(), [](const NodePair& x, const NodePair& y) {
    return std::pair(x.a, x.b) < std::pair(y.a, y.b);
  });
  return pairs;
}

class TreesOfKind : public ::testing::TestWithParam<int> {
 protected:
  TreesOfKind() : random_(kSeed, "trees of kind " + std::to_string(GetParam())) {}

  Pose any_pose(double distance_m) {
    return {distance_m * random_direction(random_), random_turn(random_)};
  }

  RandomStream random_;
};

TEST_P(TreesOfKind, RefinementFindsWhatPlainRecursionFinds) {
  int contacts = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const VolumeTree of_a = tree_of(random_, GetParam(), 4);
    const VolumeTree of_b = tree_of(random_, static_cast<int>(random_.below(kKinds + 1)), 3);
    const Placed at_a{&of_a, any_pose(0.2)};
    const Placed at_b{&of_b, any_pose(1.0)};
    PlacedTree a(of_a);
    PlacedTree b(of_b);
    a.move_to(at_a.pose);
    b.move_to(at_b.pose);
    PairRefinement pair(a, b);
    while (true) {
      std::vector<NodePair> found;
      descend(at_a, at_b, {0, 0}, pair.level(), found);
      ASSERT_EQ(sorted({pair.overlapping().begin(), pair.overlapping().end()}), sorted(found))
          << "seed " << kSeed << ": " << trial;
      contacts += static_cast<int>(found.size());
      if (pair.resolved()) {
        break;
      }
      pair.refine_one_block();
    }
  }
  EXPECT_GT(contacts, 100);
}

TEST_P(TreesOfKind, AContactIsTheSameBothWaysRound) {
  int contacts = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const VolumeTree of_a = tree_of(random_, GetParam(), 3);
    const VolumeTree of_b = tree_of(random_, static_cast<int>(random_.below(kKinds + 1)), 3);
    PlacedTree a(of_a);
    PlacedTree b(of_b);
    a.move_to(any_pose(0.2));
    b.move_to(any_pose(0.6));
    const PairRefinement pair(a, b);
    const PairRefinement swapped(b, a);
    ASSERT_EQ(pair.overlapping().empty(), swapped.overlapping().empty());
    if (pair.overlapping().empty()) {
      continue;
    }
    const Vector3 between = random_direction(random_);
    const TouchPoint x = average_contact({0, 1}, pair, a, b, {between, Vector3::Zero()}).touch;
    const TouchPoint y = average_contact({1, 0}, swapped, b, a, {-between, Vector3::Zero()}).touch;
    ASSERT_EQ(x.point, y.point);
    ASSERT_EQ(x.normal, -y.normal);
    ASSERT_EQ(x.depth_m, y.depth_m);
    ASSERT_NEAR(x.normal.norm(), 1.0, 1e-12);
    ++contacts;
  }
  EXPECT_GT(contacts, 10);
}

TEST_P(TreesOfKind, NodesOfAnOldPoseAreNeverSeenAgain) {
  const VolumeTree tree = tree_of(random_, GetParam(), 3);
  PlacedTree cached(tree);
  EXPECT_EQ(cached.of_spheres(), GetParam() == 0);
  for (int step = 0; step < 5; ++step) {
    const Placed now{&tree, any_pose(2.0)};
    cached.move_to(now.pose);
    for (std::int32_t node = 0; node < tree.node_count(); ++node) {
      for (int visit = 0; visit < 2; ++visit) {
        const Sphere seen = bounding_sphere(cached.world_volume(node));
        ASSERT_EQ(seen.centre, bounding_sphere(now.at(node)).centre);
        ASSERT_EQ(seen.radius_m, bounding_sphere(now.at(node)).radius_m);
      }
    }
  }
}

TEST_P(TreesOfKind, AWallIsTouchedByTheNodesThatReachIt) {
  const Enclosure walls = ClosedCube{1.0};
  int touched = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const VolumeTree tree = tree_of(random_, GetParam(), 3);
    const Placed now{&tree, any_pose(0.7)};
    PlacedTree cached(tree);
    cached.move_to(now.pose);
    const PairRefinement pair(cached, walls);
    ASSERT_EQ(pair.overlapping().empty(), !reaches_wall(walls, now.at(0)));
    for (const Contact& contact : wall_contacts(0, pair, {cached}, walls, {})) {
      const int wall = kEnclosure - contact.bodies.b;
      ASSERT_GE(wall, 0);
      ASSERT_EQ(contact.touch.depth_m, reach_beyond(walls, wall, now.at(0)));
      ++touched;
    }
  }
  EXPECT_GT(touched, 10);
}

INSTANTIATE_TEST_SUITE_P(Kinds, TreesOfKind, ::testing::Range(0, kMixed + 1), [](const auto& each) {
  return each.param == kMixed ? std::string("Mixed")
                              : std::string(kKindNames[static_cast<std::size_t>(each.param)]);
});

/// A solid box whose tree is one box, and so exact.
BodyModel box_body(const Vector3& half_m) {
  BodyModel model = ball(half_m.norm(), 1.0);
  model.tree = std::make_shared<VolumeTree>(
      single_node_tree(Box{Vector3::Zero(), half_m, Quaternion::Identity()}));
  return model;
}

TEST(VolumeWorld, ABoxFallsFlatOnAnotherAndBouncesWithoutTurning) {
  const BodyModel box = box_body({0.5, 0.1, 0.5});
  World world({box, box},
              {moving(box, {0.0, 0.5, 0.0}, {0.0, -1.0, 0.0}),
               moving(box, Vector3::Zero(), {0.0, 1.0, 0.0})},
              {.restitution = 1.0});
  while (world.states()[0].linear_momentum.y() < 0.0) {
    step_whole(world);
    ASSERT_GT(world.states()[0].pose.position.y(), 0.2) << "fell through";
  }
  EXPECT_NEAR(world.states()[0].linear_momentum.y(), 1.0, 1e-9);
  EXPECT_LT(world.states()[0].angular_momentum.norm(), 1e-9);
  EXPECT_LT(world.states()[1].angular_momentum.norm(), 1e-9);
}

TEST(VolumeWorld, StartingOverlapsAreThoseOfTheVolumesThemselves) {
  const BodyModel plate = box_body({1.0, 0.05, 1.0});
  const World apart({plate, plate}, {resting_at(Vector3::Zero()), resting_at({0.0, 0.2, 0.0})}, {});
  EXPECT_TRUE(overlapping_at_start(apart).empty()) << "their bounding spheres overlap";
  const World meeting({plate, plate}, {resting_at(Vector3::Zero()), resting_at({0.0, 0.09, 0.0})},
                      {});
  EXPECT_EQ(overlapping_at_start(meeting), (std::vector<BodyPair>{{0, 1}}));
}

}  // namespace impetus::volume_collision_test
