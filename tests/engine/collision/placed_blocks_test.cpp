// Memory that trees share for where their nodes are.
// SPDX-License-Identifier: MIT
#include "engine/collision/placed_blocks.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <vector>

#include "engine/collision/placed_tree.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::placed_blocks_test {

VolumeTree wide_tree(int children) {
  std::vector<VolumeNode> nodes{{Sphere{Vector3::Zero(), 10.0}, 1, children, {}}};
  for (int i = 0; i < children; ++i) {
    nodes.push_back({Sphere{Vector3(0.1 * i, 0.2, -0.3 * i), 1.0}, 0, 0, {}});
  }
  return {nodes, {0, 1}};
}

void expect_placed(PlacedTree& tree, const Pose& pose) {
  for (std::int32_t node = 0; node < tree.tree().node_count(); ++node) {
    const Sphere own = std::get<Sphere>(tree.tree().volume(node));
    const SphereLanes lanes = tree.world_lanes(node);
    ASSERT_EQ(Vector3(*lanes.x, *lanes.y, *lanes.z), pose.transform(own.centre)) << node;
    ASSERT_EQ(*lanes.radius_m, own.radius_m) << node;
    ASSERT_EQ(tree.world_sphere(node).centre, pose.transform(own.centre)) << node;
  }
}

void place_all(PlacedTree& tree, const Pose& pose) {
  tree.move_to(pose);
  tree.place_siblings(0, 1);
  tree.place_siblings(1, tree.tree().node_count() - 1);
}

TEST(SiblingBlocks, HoldEightChildrenOfANodeAtMost) {
  const SiblingBlocks blocks(
      std::vector<NodeLinks>{{1, 2}, {3, 9}, {12, 1}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}});
  EXPECT_EQ(blocks.count(), 5U);
  const std::vector<std::uint32_t> expected{0, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 3, 4};
  const std::vector<std::uint32_t> lanes{0, 0, 1, 0, 1, 2, 3, 4, 5, 6, 7, 0, 0};
  for (std::int32_t node = 0; node < 13; ++node) {
    EXPECT_EQ(blocks.block_of(node), expected[at(node)]) << node;
    EXPECT_EQ(blocks.lane_of(node), lanes[at(node)]) << node;
  }
}

TEST(BlockStore, GivesEachBlockOnceUntilItIsCleared) {
  BlockStore store;
  std::set<PlacedBlock*> first;
  for (int i = 0; i < 100; ++i) {
    EXPECT_TRUE(first.insert(&store.take()).second) << i;
  }
  store.clear();
  std::set<PlacedBlock*> again;
  for (int i = 0; i < 100; ++i) {
    again.insert(&store.take());
  }
  EXPECT_EQ(again, first) << "no memory is taken for what there was room for";
}

TEST(PlacedTree, TreesThatShareMemoryDoNotWriteOverEachOther) {
  RandomStream random(1, "shared memory");
  const VolumeTree tree = wide_tree(19);
  BlockStore store;
  std::vector<PlacedTree> placed(5, PlacedTree(tree));
  for (int step = 0; step < 6; ++step) {
    store.clear();
    for (PlacedTree& one : placed) {
      one.take_memory_from(store);
    }
    std::vector<Pose> poses(placed.size());
    for (int pose = 0; pose < 3; ++pose) {  // as on a way within a step, in any order
      for (std::size_t i = 0; i < placed.size(); ++i) {
        if (pose == 0 || random.below(2) == 0) {
          poses[i] = {random_in_cube(random, 5.0), random_turn(random)};
          place_all(placed[i], poses[i]);
        }
      }
    }
    for (std::size_t i = 0; i < placed.size(); ++i) {
      expect_placed(placed[i], poses[i]);
    }
  }
}

TEST(PlacedTree, ANewPoseNeedsNoMoreMemory) {
  const VolumeTree tree = wide_tree(8);
  BlockStore store;
  PlacedTree placed(tree);
  placed.take_memory_from(store);
  place_all(placed, {Vector3::UnitX(), Quaternion::Identity()});
  const double* first = placed.world_lanes(1).x;
  place_all(placed, {Vector3::UnitY(), Quaternion::Identity()});
  EXPECT_EQ(placed.world_lanes(1).x, first);
}

TEST(PlacedTree, ACopyHasMemoryOfItsOwn) {
  const VolumeTree tree = wide_tree(8);
  const Pose here{Vector3::UnitX(), Quaternion::Identity()};
  const Pose there{Vector3::UnitY(), Quaternion::Identity()};
  auto store = std::make_unique<BlockStore>();
  PlacedTree placed(tree);
  placed.take_memory_from(*store);
  place_all(placed, here);
  PlacedTree copy(placed);
  PlacedTree assigned(tree);
  place_all(assigned, there);
  assigned = placed;
  store.reset();  // what was lent to the first
  for (PlacedTree* each : {&copy, &assigned}) {
    EXPECT_EQ(each->world_sphere(1).centre, here.transform({0.0, 0.2, 0.0}));
    place_all(*each, there);
    expect_placed(*each, there);
  }
}

TEST(PlacedTree, CountsWhatItTransforms) {
  const VolumeTree tree = wide_tree(19);
  PlacedTree placed(tree);
  place_all(placed, {});
  EXPECT_EQ(placed.nodes_transformed(), 20);
  placed.place_siblings(1, 19);
  EXPECT_EQ(placed.nodes_transformed(), 20) << "they are placed";
}

TEST(PlacedTree, OfPairsThatAreApartTheRootsAloneAreTransformed) {
  const VolumeTree spheres = wide_tree(8);
  const VolumeTree boxes({{Box{}, 1, 2, {}}, {Box{}, 0, 0, {}}, {Box{}, 0, 0, {}}}, {0, 1});
  PlacedTree a(spheres);
  PlacedTree b(spheres);
  PlacedTree c(spheres);
  PlacedTree box(boxes);
  b.move_to({{100.0, 0.0, 0.0}, Quaternion::Identity()});
  box.move_to({{0.0, 100.0, 0.0}, Quaternion::Identity()});
  EXPECT_EQ(PairRefinement(a, b).overlapping().size(), 0U);
  EXPECT_EQ(PairRefinement(box, c).overlapping().size(), 0U);
  for (const PlacedTree* each : {&a, &b, &c, &box}) {
    EXPECT_EQ(each->nodes_transformed(), 1);
  }
}

}  // namespace impetus::placed_blocks_test
