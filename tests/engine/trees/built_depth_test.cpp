// Trees of which the finer levels are not built: those that are, are those of the whole tree.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "engine/trees/builders/build_tree.hpp"
#include "engine/volumes/rounded_box.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/built_solids.hpp"

namespace impetus::built_depth_test {

TreeSettings built_to(TreeSettings whole, int level) {
  whole.built_depth = level;
  return whole;
}

/// The same kind with the same numbers; the form is a function of both.
bool are_one(const Volume& x, const Volume& y) {
  const RoundedBox of_x = rounded_box(x);
  const RoundedBox of_y = rounded_box(y);
  return x.index() == y.index() && of_x.centre == of_y.centre && of_x.axes == of_y.axes &&
         of_x.half_extents_m == of_y.half_extents_m && of_x.radius_m == of_y.radius_m;
}

/// Links of the last level that was built lead nowhere; all else is the same.
void expect_upper_levels(const VolumeTree& part, const VolumeTree& whole, int level,
                         const std::string& what) {
  ASSERT_EQ(part.level_count(), std::min(level + 1, whole.level_count())) << what;
  for (int each = 0; each < part.level_count(); ++each) {
    ASSERT_EQ(part.level_begin(each), whole.level_begin(each)) << what;
    ASSERT_EQ(part.level_end(each), whole.level_end(each)) << what;
    EXPECT_EQ(part.fit_error_m(each), whole.fit_error_m(each)) << what;
    EXPECT_EQ(part.least_half_thickness_m(each), whole.least_half_thickness_m(each)) << what;
    for (std::int32_t node = part.level_begin(each); node < part.level_end(each); ++node) {
      ASSERT_TRUE(are_one(part.volume(node), whole.volume(node))) << what << ", node " << node;
      ASSERT_EQ(part.surface(node), whole.surface(node)) << what << ", node " << node;
      const NodeLinks links = each == level ? NodeLinks{} : whole.links(node);
      ASSERT_EQ(part.links(node), links) << what << ", node " << node;
    }
  }
  EXPECT_EQ(part.bounding_radius_m(), whole.bounding_radius_m()) << what;
}

TEST(BuiltDepth, TheLevelsThatAreBuiltAreThoseOfTheWholeTreeForEveryKind) {
  const TriangleMesh block = about_centre_of_mass(l_block_mesh(2.0, 0.7));
  const TriangleMesh ring = torus_mesh(1.0, 0.3, 12, 6);
  for (const TriangleMesh* mesh : {&block, &ring}) {
    for (const std::string& name : tree_kind_names()) {
      const bool any = name != "octree" && name != "voxel";
      const TreeSettings settings{tree_kind(name), /*depth=*/2, /*branching=*/any ? 3 : 8};
      const VolumeTree whole = build_tree(*mesh, settings);
      for (const int level : {0, 1}) {
        expect_upper_levels(build_tree(*mesh, built_to(settings, level)), whole, level,
                            name + " built to " + std::to_string(level));
      }
    }
  }
}

TEST(BuiltDepth, ADepthBeyondTheTreesOwnBuildsItWhole) {
  const TriangleMesh block = about_centre_of_mass(l_block_mesh(2.0, 0.7));
  const TreeSettings settings{TreeKind::kOctree, 2, 8};
  EXPECT_EQ(build_tree(block, built_to(settings, 5)).node_count(),
            build_tree(block, settings).node_count());
}

TEST(BuiltDepth, IsRefusedBelowTheRoot) {
  EXPECT_EQ(problem_of(built_to({TreeKind::kOctree, 2, 8}, -1)),
            "tree: expected a depth to build from 0 to 8, got -1");
}

/// Blocks at level 1 of trees of three levels, or of the first two of them.
World blocks_at_level_1(TreeSettings tree, int least_level) {
  Schedule schedule;
  schedule.lists = {{1.0, least_level, /*greatest_level=*/1}};
  World world = enclosed_l_blocks(27, /*depth=*/0, schedule);
  std::vector<BodyModel> models = world.models();
  const auto shared = std::make_shared<VolumeTree>(build_tree(small_l_block(), tree));
  for (BodyModel& model : models) {
    model.tree = shared;
  }
  return {models, world.states(), world.settings()};
}

TEST(BuiltDepth, StepsAreTheSameBitsWhereNothingReachesWhatWasNotBuilt) {
  for (const std::string& name : tree_kind_names()) {
    const bool any = name != "octree" && name != "voxel";
    const TreeSettings settings{tree_kind(name), 2, any ? 3 : 8};
    for (const int least_level : {0, 1}) {
      World whole = blocks_at_level_1(settings, least_level);
      World part = blocks_at_level_1(built_to(settings, 1), least_level);
      std::size_t collisions = 0;
      for (int step = 0; step < 240; ++step) {
        FixedWork meter(least_level == 0 ? 200 : kUnlimitedTests);
        const StepReport& expected = whole.step(step_of(kStep_s), meter);
        const StepReport& report = part.step(step_of(kStep_s), meter);
        ASSERT_EQ(report.state.hash, expected.state.hash) << name << ", step " << step;
        ASSERT_EQ(report.work_spent, expected.work_spent) << name << ", step " << step;
        ASSERT_EQ(report.work_granted, expected.work_granted) << name << ", step " << step;
        collisions += report.collisions.size();
      }
      EXPECT_GT(collisions, 50U) << name;
    }
  }
}

}  // namespace impetus::built_depth_test
