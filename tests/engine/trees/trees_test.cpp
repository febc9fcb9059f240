// Trees: only breadth-first orders are trees.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <stdexcept>

#include "engine/trees/volume_tree.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::trees_test {

using Nodes = std::vector<VolumeNode>;

VolumeNode leaf() { return {Sphere{Vector3::Zero(), 1.0}, 0, 0, {}}; }

VolumeNode inner(std::int32_t first_child, std::int32_t child_count) {
  return {Sphere{Vector3::Zero(), 1.0}, first_child, child_count, {}};
}

void expect_refused(Nodes nodes, std::vector<std::int32_t> starts) {
  try {
    const VolumeTree tree(nodes, std::move(starts));
    ADD_FAILURE() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "volume tree: nodes are not in breadth-first order by level");
  }
}

TEST(VolumeTree, ASphereIsATreeOfOneNodeAndOneLevel) {
  const VolumeTree tree = single_node_tree(Sphere{Vector3(3.0, 0.0, 4.0), 0.5});
  EXPECT_EQ(tree.node_count(), 1);
  EXPECT_EQ(tree.level_count(), 1);
  EXPECT_EQ(tree.bounding_radius_m(), 5.5) << "about the centre of mass";
}

TEST(VolumeTree, CountsLevelsOfAnUnevenTree) {
  // root -> (n1 -> n3 n4), n2 a leaf
  const VolumeTree tree({inner(1, 2), inner(3, 2), leaf(), leaf(), leaf()}, {0, 1, 3});
  EXPECT_EQ(tree.level_count(), 3);
  EXPECT_EQ(tree.node_count(), 5);
}

TEST(VolumeTree, RefusesNodesOutOfBreadthFirstOrder) {
  expect_refused({}, {});
  expect_refused({inner(2, 1), leaf(), leaf()}, {0, 1});  // skips node 1
  expect_refused({inner(0, 1)}, {0});                     // its own parent
  expect_refused({inner(1, 2), inner(4, 1), inner(3, 1), leaf(), leaf()}, {0, 1, 3});
  expect_refused({inner(1, 2), leaf()}, {0, 1});          // a child too few
  expect_refused({inner(1, 1), leaf(), leaf()}, {0, 1});  // a node nobody owns
  expect_refused({inner(1, -1), leaf()}, {0, 1});         // a negative count
}

TEST(VolumeTree, RefusesLevelsThatDoNotMatchItsNodes) {
  const Nodes nodes{inner(1, 2), inner(3, 1), leaf(), leaf()};
  EXPECT_NO_THROW((VolumeTree(nodes, {0, 1, 3})));
  expect_refused(nodes, {});
  expect_refused(nodes, {0, 1});
  expect_refused(nodes, {0, 2, 3});
  expect_refused(nodes, {1, 1, 3});
  expect_refused(nodes, {0, 1, 3, 4});
}

TEST(VolumeTree, BoundingRadiusBoundsEveryNodeOfANestedTree) {
  RandomStream random(21, "bounding radius");
  for (int trial = 0; trial < 50; ++trial) {
    const VolumeTree tree = random_tree(random, 5);
    for (std::int32_t index = 0; index < tree.node_count(); ++index) {
      const auto volume = std::get<Sphere>(tree.volume(index));
      ASSERT_LE(volume.centre.norm() + volume.radius_m, tree.bounding_radius_m());
    }
  }
}

}  // namespace impetus::trees_test
