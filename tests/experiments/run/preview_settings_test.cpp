// What a preview's controls ask for, and what of it reaches the world.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "engine/scheduling/metrics.hpp"
#include "experiments/observers/headless_lab.hpp"
#include "experiments/run/preview_run.hpp"
#include "tests/experiments/preview_scenes.hpp"

namespace impetus::preview_settings_test {

TEST(PreviewSettings, EveryChoiceOfSchedulerAndListsIsAGoodSchedule) {
  for (const std::string& scheduler : scheduler_names()) {
    for (int lists = 1; lists <= kMostPreviewLists; ++lists) {
      PreviewSettings settings = settings_of(crowd());
      choose_list_count(settings, lists);
      choose_scheduler(settings, scheduler);
      EXPECT_EQ(problem_of(settings), "") << scheduler << " with " << lists << " lists";
      choose_list_count(settings, lists);
      EXPECT_EQ(problem_of(settings), "") << scheduler << " with " << lists << " lists";
    }
  }
}

TEST(PreviewSettings, ARegionHasTwoListsWhateverIsAskedFor) {
  PreviewSettings settings = settings_of(crowd());
  choose_scheduler(settings, "region");
  choose_list_count(settings, 4);
  EXPECT_EQ(settings.list_count, 2);
  EXPECT_EQ(schedule_of(settings).rule, make_list_rule("region"));
}

TEST(PreviewSettings, LimitsPartTheRangeOfTheirRuleEvenly) {
  PreviewSettings settings = settings_of(crowd());
  choose_scheduler(settings, "eccentricity");
  choose_list_count(settings, 4);
  const MeasureRange range = measure_range("eccentricity");
  const double quarter = (range.relaxed - range.urgent) / 4.0;
  EXPECT_EQ(schedule_of(settings).limits,
            (std::vector<double>{range.urgent + quarter, range.urgent + 2.0 * quarter,
                                 range.urgent + 3.0 * quarter}));
  settings.rule = "pair_shares";
  EXPECT_EQ(schedule_of(settings).limits, (std::vector<double>{0.25, 0.25, 0.25}));
  EXPECT_EQ(problem_of(settings), "");
}

TEST(PreviewSettings, AScenesOwnScheduleIsWhatTheControlsShow) {
  for (const std::string_view name : metric_names()) {
    Schedule schedule;
    schedule.metric = name == "weighted" ? nullptr : make_metric(name);
    schedule.lists = {{3.0, 1, 2}, {1.0, 0, 1}};
    schedule.limits = {7.5};
    StagedScene scene = crowd(schedule);
    scene.scheduler = name;
    const PreviewSettings settings = settings_of(scene);
    EXPECT_EQ(settings.scheduler, name);
    const Schedule again = schedule_of(settings);
    ASSERT_EQ(again.lists.size(), 2U);
    EXPECT_EQ(again.lists[0].share, 3.0);
    EXPECT_EQ(again.lists[0].least_level, 1);
    EXPECT_EQ(again.lists[0].greatest_level, 2);
    EXPECT_EQ(again.lists[1].greatest_level, 1);
    EXPECT_EQ(again.limits, schedule.limits);
  }
}

TEST(PreviewSettings, TheFinestLevelIsNoLimit) {
  const PreviewSettings settings = settings_of(two_l_blocks());
  EXPECT_EQ(settings.finest_level, 4);
  EXPECT_EQ(settings.lists[0].least_level, 4);
  EXPECT_EQ(schedule_of(settings).lists[0].greatest_level, kUnlimitedLevel);
}

TEST(PreviewSettings, AScenesOwnRegionIsWhatTheControlsShow) {
  const PreviewSettings settings = settings_of(cube());
  EXPECT_EQ(settings.scheduler, "region");
  EXPECT_EQ(settings.region.kind, RegionKind::kAllGood);
  EXPECT_EQ(settings.region.radius_deg, 5.0);
  EXPECT_EQ(settings.region.renewal_steps, 60);
  EXPECT_EQ(settings.budget, BudgetUnit::kUnlimited);
  const Schedule schedule = schedule_of(settings);
  EXPECT_EQ(schedule.rule, make_list_rule("region"));
  ASSERT_EQ(schedule.lists.size(), 2U);
  EXPECT_EQ(schedule.lists[0].least_level, 4);
  EXPECT_EQ(schedule.lists[1].greatest_level, 0);
  EXPECT_EQ(problem_of(settings), "");
}

TEST(PreviewSettings, AScenesOwnBudgetIsWhatTheControlsShow) {
  StagedScene scene = crowd();
  scene.budget.tests_per_step = 321;
  EXPECT_EQ(settings_of(scene).budget, BudgetUnit::kTests);
  EXPECT_EQ(settings_of(scene).tests_per_step, 321);
  scene.budget = {kUnlimitedTests, 750'000};
  EXPECT_EQ(settings_of(scene).budget, BudgetUnit::kMilliseconds);
  EXPECT_EQ(settings_of(scene).ms_per_step, 0.75);
}

TEST(PreviewSettings, WithoutARegionOfTheScenesOwnItFollowsTheMouse) {
  const PreviewSettings settings = settings_of(crowd());
  EXPECT_EQ(settings.region.kind, RegionKind::kTracked);
  EXPECT_EQ(settings.region.renewal_steps, 60);
}

TEST(PreviewSettings, EveryOptionReachesTheWorldAndOutlivesARestart) {
  const VirtualClock clock;
  PreviewRun run(crowd(), clock);
  PreviewSettings settings = run.settings();
  choose_list_count(settings, 2);
  settings.rule = "pair_shares";
  settings.lists[0].limits["pair_shares"] = 0.25;
  settings.traversal = make_traversal("best-first");
  settings.persistence_steps = 12;
  settings.reduction = "groups";
  settings.most_per_pair = 2;
  settings.tunnelling = Tunnelling::kCapped;
  settings.response = ResponseMethod::kTogether;
  settings.rotation = Rotation::kEnergyKept;
  settings.all_phases = true;
  run.change(settings);
  for (int round = 0; round < 2; ++round) {
    const WorldSettings& world = run.scene().world.settings();
    EXPECT_EQ(world.schedule.rule, make_list_rule("pair_shares"));
    EXPECT_EQ(world.schedule.limits, std::vector<double>{0.25});
    EXPECT_EQ(world.schedule.traversal, make_traversal("best-first"));
    EXPECT_EQ(world.schedule.persistence_steps, 12);
    EXPECT_EQ(world.contacts.reduction != nullptr, make_reduction("groups") != nullptr);
    EXPECT_EQ(world.contacts.most_per_pair, 2);
    EXPECT_EQ(world.tunnelling, Tunnelling::kCapped);
    EXPECT_EQ(world.response, ResponseMethod::kTogether);
    EXPECT_EQ(world.rotation, Rotation::kEnergyKept);
    EXPECT_EQ(world.costs, kAllPhases);
    run.restart();
  }
}

TEST(PreviewSettings, AScenesOwnOptionsAreWhatTheControlsShow) {
  json scene = json::parse(shipped("stimuli/l-blocks-in-a-cube.json"));
  scene["engine"].erase("region");
  scene["engine"]["schedule"] = json::parse(R"({
    "scheduler": "weighted", "lists": [{}, {}], "pair_shares": [0.3],
    "terms": [{"metric": "size", "urgent": 9, "relaxed": 1, "weight": 3}],
    "traversal": "breadth-first", "persistence_ms": 50})");
  scene["engine"]["contacts"] = {{"reduction", "density"}, {"most_per_pair", 3}};
  scene["engine"]["tunnelling"] = "capped";
  scene["engine"]["response"] = "together";
  scene["engine"]["budget"] = {{"tests_per_step", 100}, {"counts", "all-phases"}};
  ShapeLibrary shapes;
  const PreviewSettings settings = settings_of(build_scene(scene, assumed_screen(), 0.0, shapes));
  EXPECT_EQ(settings.scheduler, "weighted");
  ASSERT_EQ(settings.metric_options.terms.size(), 1U);
  EXPECT_EQ(settings.metric_options.terms[0].metric, "size");
  EXPECT_EQ(settings.metric_options.terms[0].weight, 3.0);
  EXPECT_EQ(settings.rule, "pair_shares");
  EXPECT_EQ(settings.lists[0].limits.at("pair_shares"), 0.3);
  EXPECT_EQ(settings.traversal, make_traversal("breadth-first"));
  EXPECT_EQ(settings.persistence_steps, 12);
  EXPECT_EQ(settings.reduction, "density");
  EXPECT_EQ(settings.most_per_pair, 3);
  EXPECT_EQ(settings.tunnelling, Tunnelling::kCapped);
  EXPECT_EQ(settings.response, ResponseMethod::kTogether);
  EXPECT_TRUE(settings.all_phases);
}

TEST(PreviewRun, ContactsBeforeTheReductionAreFoundOnlyWhenAskedFor) {
  const VirtualClock clock;
  PreviewRun run(two_l_blocks(), clock);
  const auto contact = [&run] {
    while (run.contacts().empty()) {
      ASSERT_LT(run.step_number(), 480);
      run.step();
    }
  };
  contact();
  EXPECT_TRUE(run.node_contacts().empty());
  run.restart();
  run.watch_node_contacts(true);
  contact();
  EXPECT_GE(run.node_contacts().size(), run.contacts().size());
  run.watch_node_contacts(false);
  EXPECT_TRUE(run.node_contacts().empty());
}

}  // namespace impetus::preview_settings_test
