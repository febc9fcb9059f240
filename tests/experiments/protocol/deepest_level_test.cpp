// Trees are built as deep as any condition of a protocol can reach, and no deeper.
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/run/live_run.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::deepest_level_test {

/// The gap study, whose factor is the level; its trees could have 4 levels beyond the root.
Protocol gap_at_levels(const json& levels, const json& demonstrations = json::array()) {
  const std::string name = "protocols/gap.json";
  const std::string scene_name = "stimuli/two-l-blocks.json";
  json protocol = json::parse(shipped(name));
  protocol["design"]["factors"][0]["levels"] = levels;
  for (json& condition : protocol["design"]["practice"]) {
    condition["level"] = levels[0];
  }
  if (!demonstrations.empty()) {
    protocol["session"]["demonstrations"] = demonstrations;
  }
  return make_protocol(parse_json(name, protocol.dump()),
                       parse_json(scene_name, shipped(scene_name)));
}

int levels_of(const StagedScene& scene) { return scene.world.models()[0].tree->level_count(); }

int levels_staged(const Protocol& protocol) {
  const ProtocolScenes scenes(protocol, 0.0);
  return levels_of(scenes.stage(cells(protocol.design).front(), assumed_screen()));
}

TEST(DeepestLevel, TreesHaveTheLevelsThatSomeConditionReaches) {
  EXPECT_EQ(levels_staged(gap_at_levels({0, 2, 4})), 5);
  EXPECT_EQ(levels_staged(gap_at_levels({0, 2})), 3);
  EXPECT_EQ(levels_staged(gap_at_levels({0, 1})), 2);
}

TEST(DeepestLevel, ADemonstrationReachesAsDeepAsACondition) {
  const json demonstrations = json::array({{{"id", "fine"},
                                            {"title", "Fine"},
                                            {"paragraphs", {"Finer than any trial."}},
                                            {"set", {{"/engine/level", 3}}}}});
  const Protocol protocol = gap_at_levels({0, 1}, demonstrations);
  EXPECT_EQ(deepest_level_of(protocol), 3);
  const ProtocolScenes scenes(protocol, 0.0);
  EXPECT_EQ(levels_of(scenes.stage_demonstration("fine", assumed_screen())), 4);
}

TEST(DeepestLevel, IsTheDeepestOfTheLists) {
  json engine = json::parse(shipped("stimuli/creatures-in-a-cube.json"))["engine"];
  EXPECT_EQ(deepest_level_of(engine), 3);
  engine["schedule"]["lists"][0]["greatest_level"] = 2;
  EXPECT_EQ(deepest_level_of(engine), 2);
  engine["schedule"]["lists"][1].erase("greatest_level");
  EXPECT_EQ(deepest_level_of(engine), 3) << "a list without a greatest level reaches all";
  engine.erase("schedule");
  EXPECT_EQ(deepest_level_of(engine), 3) << "so does a scene without lists";
}

TEST(DeepestLevel, TheCourseIsThatOfWholeTrees) {
  const Protocol protocol = gap_at_levels({0, 2});
  const ProtocolScenes scenes(protocol, 0.0);
  for (const Condition& cell : cells(protocol.design)) {
    PlannedTrial trial;
    trial.condition = cell;
    const StagedScene part = scenes.stage(trial, assumed_screen());
    ShapeLibrary library;
    const StagedScene whole =
        build_scene(scene_under(protocol, cell), assumed_screen(), 0.0, library, "main/1");
    ASSERT_EQ(levels_of(whole), 5);
    ASSERT_EQ(levels_of(part), 3);
    LiveRun shown(part, 1);
    LiveRun expected(whole, 1);
    static_cast<void>(shown.poses_at(part.duration_s));
    static_cast<void>(expected.poses_at(whole.duration_s));
    EXPECT_FALSE(expected.take_collisions().empty());
    const std::vector<StepRecord> steps = shown.take_steps();
    const std::vector<StepRecord> of_whole = expected.take_steps();
    ASSERT_EQ(steps.size(), of_whole.size());
    for (std::size_t step = 0; step < steps.size(); ++step) {
      ASSERT_EQ(steps[step].state.hash, of_whole[step].state.hash) << "step " << step;
    }
  }
}

}  // namespace impetus::deepest_level_test
