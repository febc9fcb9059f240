// A preview without its window: what the controls ask for, and the run that obeys them.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>

#include "experiments/files/scene_files.hpp"
#include "experiments/observers/headless_lab.hpp"
#include "experiments/run/preview_run.hpp"
#include "tests/experiments/preview_scenes.hpp"
#include "tests/places/places.hpp"

namespace impetus::preview_test {

std::uint64_t hash_of(const PreviewRun& run) { return hash_state(run.scene().world.states()).hash; }

void advance_frames(PreviewRun& run, int frames) {
  for (int frame = 0; frame < frames; ++frame) {
    run.advance(kFrame_s);
  }
}

/// The lists of the pairs that a second of the run has.
std::set<int> lists_of_a_second(PreviewRun& run) {
  std::set<int> lists;
  for (int frame = 0; frame < 60; ++frame) {
    run.advance(kFrame_s);
    for (const ScheduledPair& pair : run.pairs()) {
      lists.insert(pair.list);
    }
  }
  return lists;
}

// ---------------------------------------------------------------- time

TEST(PreviewRun, TakesTheStepsThatRealTimeAsksFor) {
  const VirtualClock clock;
  PreviewRun run(crowd(), clock);
  advance_frames(run, 60);
  EXPECT_EQ(run.step_number(), 240);
  run.set_speed(0.25);
  advance_frames(run, 60);
  EXPECT_EQ(run.step_number(), 300);
  run.toggle();
  advance_frames(run, 60);
  EXPECT_EQ(run.step_number(), 300);
}

TEST(PreviewRun, GoesOnWhenTheSceneIsOver) {
  const VirtualClock clock;
  PreviewRun run(two_l_blocks(), clock);
  advance_frames(run, 240);
  EXPECT_EQ(run.step_number(), 960);
  EXPECT_GT(960 / run.scene().step_hz, run.scene().duration_s);
}

TEST(PreviewRun, ASingleStepStandsExactlyOnTheNext) {
  const VirtualClock clock;
  PreviewRun run(crowd(), clock);
  run.advance(0.6 / run.scene().step_hz);  // between the onset and step 1, which is known by then
  run.step();
  EXPECT_FALSE(run.playing());
  EXPECT_EQ(run.step_number(), 1);
  run.step();
  EXPECT_EQ(run.step_number(), 2);
  EXPECT_EQ(run.picture().bodies[5].pose.position, run.scene().world.states()[5].pose.position);
}

TEST(PreviewRun, BodiesStandBetweenTheStepsAroundTheirTime) {
  const VirtualClock clock;
  PreviewRun run(two_l_blocks(), clock);
  const double start_m = run.picture().bodies[0].pose.position.x();
  run.advance(0.25 / run.scene().step_hz);
  const double step_m = run.scene().world.states()[0].pose.position.x() - start_m;
  EXPECT_EQ(run.step_number(), 1);
  EXPECT_NEAR(run.picture().bodies[0].pose.position.x(), start_m + 0.25 * step_m,
              1e-12 * step_m + 1e-15);
}

TEST(PreviewRun, RestartBringsTheSameCourseAgain) {
  const VirtualClock clock;
  PreviewRun run(crowd(), clock);
  advance_frames(run, 60);
  const std::uint64_t first = hash_of(run);
  const std::int64_t collisions = run.collision_count();
  EXPECT_GT(collisions, 0);
  run.restart();
  EXPECT_EQ(run.step_number(), 0);
  EXPECT_EQ(run.collision_count(), 0);
  EXPECT_TRUE(run.contacts().empty());
  advance_frames(run, 60);
  EXPECT_EQ(hash_of(run), first);
  EXPECT_EQ(run.collision_count(), collisions);
}

/// A machine on which everything takes its time.
class SlowClock final : public Clock {
 public:
  [[nodiscard]] std::int64_t now_ns() const override { return now_ns_ += 2'000'000; }

 private:
  mutable std::int64_t now_ns_{0};
};

TEST(PreviewRun, FallsBehindOnASlowMachineAndSkipsNothing) {
  const SlowClock clock;
  PreviewRun run(crowd(), clock);
  for (int frame = 0; frame < 60; ++frame) {
    run.advance(0.1);
  }
  EXPECT_LT(run.step_number(), 24 * 60);
  EXPECT_LT(run.pace(), 0.9);
  const VirtualClock quick;
  PreviewRun same(crowd(), quick);
  while (same.step_number() < run.step_number()) {
    same.step();
  }
  EXPECT_EQ(hash_of(same), hash_of(run));
}

// ---------------------------------------------------------------- settings while it runs

TEST(PreviewRun, AnImpossibleScheduleIsNamedAndTheLastGoodOneGoesOn) {
  const VirtualClock clock;
  PreviewRun run(crowd(), clock);
  PreviewSettings settings = run.settings();
  settings.lists[0].greatest_level = 1;
  run.change(settings);
  EXPECT_EQ(run.problem(), "");
  settings.lists[0].least_level = 2;
  run.change(settings);
  EXPECT_EQ(run.problem(), "schedule: expected 0 <= least level <= greatest level, got 2 and 1");
  advance_frames(run, 10);
  EXPECT_EQ(run.scene().world.settings().schedule.lists[0].least_level, 0);
  EXPECT_EQ(run.scene().world.settings().schedule.lists[0].greatest_level, 1);
  settings.lists[0].greatest_level = 3;
  run.change(settings);
  EXPECT_EQ(run.problem(), "");
  EXPECT_EQ(run.scene().world.settings().schedule.lists[0].least_level, 2);
}

TEST(PreviewRun, ARestartKeepsTheScheduleThatRuns) {
  const VirtualClock clock;
  PreviewRun run(crowd(), clock);
  PreviewSettings settings = run.settings();
  settings.lists[0].greatest_level = 1;
  run.change(settings);
  run.restart();
  EXPECT_EQ(run.scene().world.settings().schedule.lists[0].greatest_level, 1);
}

TEST(PreviewRun, SpendsNoMoreThanItsBudgetBeyondTheFloor) {
  const VirtualClock clock;
  PreviewRun run(crowd(), clock);
  PreviewSettings settings = run.settings();
  settings.budget = BudgetUnit::kTests;
  settings.tests_per_step = 100;
  run.change(settings);
  advance_frames(run, 60);
  bool cut = false;
  for (const WorkOfStep& step : run.work()) {
    EXPECT_LE(step.spent, std::max<std::int64_t>(100, step.floor));
    EXPECT_EQ(step.granted, 100);
    cut = cut || step.spent > 90;
  }
  EXPECT_TRUE(cut) << "the budget was never near";
}

TEST(PreviewRun, ABudgetInTimeLeavesTheFloorWhenThereIsNoTime) {
  const SlowClock clock;
  PreviewRun run(crowd(), clock);
  PreviewSettings settings = run.settings();
  settings.budget = BudgetUnit::kMilliseconds;
  settings.ms_per_step = 0.5;
  run.change(settings);
  advance_frames(run, 120);
  for (const WorkOfStep& step : run.work()) {
    EXPECT_EQ(step.spent, step.floor);
  }
}

TEST(PreviewRun, TheStripChartReachesBackAFewSecondsAndNoFurther) {
  const VirtualClock clock;
  PreviewRun run(two_l_blocks(), clock);
  advance_frames(run, 600);
  EXPECT_EQ(run.work().size(), run.work_span());
  EXPECT_EQ(run.work_span(), 960U);
}

// ---------------------------------------------------------------- what the overlays show

TEST(PreviewRun, AContactStaysInViewForAQuarterOfASecond) {
  const VirtualClock clock;
  PreviewRun run(two_l_blocks(), clock);
  while (run.contacts().empty()) {
    ASSERT_LT(run.step_number(), 480);
    run.step();
  }
  EXPECT_DOUBLE_EQ(run.freshness(run.contacts().back()), 1.0);
  EXPECT_EQ(run.details()[0].level, 4);
  const std::int64_t last = run.contacts().back().step;
  for (int step = 0; step < 59; ++step) {
    run.step();
  }
  EXPECT_FALSE(run.contacts().empty());
  run.step();
  EXPECT_EQ(run.step_number(), last + 60);
  EXPECT_TRUE(run.contacts().empty());
  EXPECT_EQ(run.details()[0].level, -1);
}

TEST(PreviewRun, OfAPairThatStaysInContactTheNewestIsInView) {
  const VirtualClock clock;
  PreviewRun run(crowd(), clock);
  for (int frame = 0; frame < 120; ++frame) {
    run.advance(kFrame_s);
    std::set<std::pair<std::int32_t, std::int32_t>> seen;
    for (const ShownContact& contact : run.contacts()) {
      EXPECT_TRUE(seen.insert({contact.bodies.a, contact.bodies.b}).second);
    }
  }
}

TEST(PreviewRun, TheRegionFollowsTheGazeWhenTheSchedulerIsRegion) {
  const VirtualClock clock;
  PreviewRun run(crowd(), clock);
  run.look_at({0.05, -0.02});
  EXPECT_FALSE(run.region());
  PreviewSettings settings = run.settings();
  choose_scheduler(settings, "region");
  settings.region.radius_deg = 2.0;
  run.change(settings);
  ASSERT_TRUE(run.region());
  EXPECT_EQ(run.region()->centre.x_m, 0.05);
  EXPECT_EQ(run.region()->centre.y_m, -0.02);
  EXPECT_EQ(run.region()->radius_deg, 2.0);
  EXPECT_EQ(lists_of_a_second(run), (std::set<int>{0, 1}));
}

TEST(PreviewRun, AllGoodIsTheFirstListAloneAndAllBadTheOther) {
  const VirtualClock clock;
  PreviewRun run(cube(), clock);
  EXPECT_EQ(lists_of_a_second(run), std::set<int>{0});
  PreviewSettings settings = run.settings();
  settings.region.kind = RegionKind::kAllBad;
  run.change(settings);
  EXPECT_EQ(lists_of_a_second(run), std::set<int>{1});
  EXPECT_FALSE(run.region());
}

TEST(PreviewRun, ARandomRegionIsRenewedEveryQuarterOfASecond) {
  const VirtualClock clock;
  PreviewRun run(cube(), clock);
  PreviewSettings settings = run.settings();
  settings.region.kind = RegionKind::kRandom;
  run.change(settings);
  std::vector<ScreenPoint> places;
  for (int step = 0; step < 240; ++step) {
    run.step();
    ASSERT_TRUE(run.region());
    if (places.empty() || !(run.region()->centre == places.back())) {
      EXPECT_EQ(step % 60, 0);
      places.push_back(run.region()->centre);
    }
  }
  EXPECT_EQ(places.size(), 4U);
  run.restart();
  EXPECT_FALSE(run.region()) << "the last step's, and there was none";
  run.step();
  EXPECT_TRUE(run.region()->centre == places.front());
}

TEST(PreviewRun, EnergyIsAShareOfThatAtTheOnset) {
  const VirtualClock clock;
  PreviewRun run(crowd(), clock);
  EXPECT_DOUBLE_EQ(run.energy_share(), 1.0);
  advance_frames(run, 60);
  // Restitution 1: impulses keep it, and the integration of free rotation does to about 1e-6.
  EXPECT_NEAR(run.energy_share(), 1.0, 1e-5);
}

// ---------------------------------------------------------------- scene files

TEST(SceneLoading, TheShippedScenesAreAccepted) {
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(source_folder()) / "stimuli")) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() == ".json" && name.find("schema") == std::string::npos &&
        name != "humanoid.json") {  // a figure, which scenes name
      EXPECT_EQ(refusal([&] { load_scene(entry.path()); }), "accepted") << name;
    }
  }
}

TEST(SceneLoading, ARefusalNamesFileAndPlace) {
  const TemporaryFolder folder;
  json scene = json::parse(shipped("stimuli/two-l-blocks.json"));
  const auto sentence = [&](const char* pointer, const json& value) {
    json changed = scene;
    changed[json::json_pointer(pointer)] = value;
    const std::string path = folder.write("s.json", changed.dump()).string();
    return refusal([&] { load_scene(path); }).substr(path.size());
  };
  EXPECT_EQ(sentence("/engine/level", 5),
            ":/engine/level: expected at most 4, the deepest level of the trees, got 5");
  EXPECT_EQ(sentence("/bodies/1/name", "left"),
            ":/bodies/1/name: expected a name of its own, got \"left\" again");
}

}  // namespace impetus::preview_test
