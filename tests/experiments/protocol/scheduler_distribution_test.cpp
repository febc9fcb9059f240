// A study in which nobody takes part: thresholds from a pilot, trials without frames, replayed.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "experiments/protocol/solved_values.hpp"
#include "experiments/run/replay.hpp"
#include "experiments/session/unattended.hpp"
#include "tests/experiments/fakes.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::scheduler_distribution_test {

/// The shipped study: twenty seconds of it, and as much for the pilot, within 5 %.
Protocol short_study(const json& levels = json::array({"size", "gap", "collision-speed"})) {
  json document = json::parse(shipped("protocols/scheduler-distribution.json"));
  document["design"]["factors"][0]["levels"] = levels;
  document["solve"][0]["pilot_s"] = 20;
  document["solve"][0]["within"] = 0.05;
  json scene = json::parse(shipped("stimuli/spheres-in-view.json"));
  scene["duration_s"] = 20;
  return make_protocol(parse_json("d.json", document.dump()), parse_json("s.json", scene.dump()));
}

struct WholeRun {
  WholeRun() {
    ShapeLibrary shapes;
    plan = make_plan(protocol.design, {protocol.name, "nobody", 1});
    put_solved(solve(protocol, shapes), plan);
    run_unattended(plan, {}, scenes, assumed_screen(), recorder, SteadyClock());
  }

  Protocol protocol{short_study()};
  ProtocolScenes scenes{protocol, 0.0};
  Plan plan;
  MemoryRecorder recorder;
};

const WholeRun& whole_run() {
  static const WholeRun run;
  return run;
}

bool of_two_bodies(const CollisionRecord& collision) { return !is_wall(collision.report.bodies.b); }

TEST(SchedulerDistribution, EveryTrialIsCompletedWithoutAFrameAndReplaysBitForBit) {
  const WholeRun& run = whole_run();
  ASSERT_EQ(run.recorder.attempts.size(), 3U);
  EXPECT_TRUE(run.recorder.finished);
  for (std::size_t i = 0; i < run.plan.size(); ++i) {
    const AttemptRecord& attempt = run.recorder.attempts[i];
    EXPECT_EQ(attempt.outcome, AttemptOutcome::kCompleted);
    EXPECT_TRUE(attempt.frames.empty());
    ASSERT_EQ(attempt.steps.size(), 20U * 60U + 1U);
    EXPECT_TRUE(attempt.steps.back().state.bodies.empty()) << "no digests";
    const ReplayResult replayed =
        replay(run.scenes.stage(run.plan[i], assumed_screen()), attempt.steps);
    EXPECT_FALSE(replayed.divergence);
    EXPECT_EQ(replayed.steps, 1200);
  }
}

TEST(SchedulerDistribution, AReplayWithoutDigestsStillNoticesAChangedStart) {
  const WholeRun& run = whole_run();
  StagedScene scene = run.scenes.stage(run.plan[0], assumed_screen());
  scene.world.mutable_states()[17].pose.position.x() += 1e-12;
  const ReplayResult replayed = replay(scene, run.recorder.attempts[0].steps);
  ASSERT_TRUE(replayed.divergence);
  EXPECT_EQ(replayed.divergence->step, 0);
}

TEST(SchedulerDistribution, ListsShareTheCollisionsAsWanted) {
  for (const AttemptRecord& attempt : whole_run().recorder.attempts) {
    double high = 0.0;
    double all = 0.0;
    for (const CollisionRecord& collision : attempt.collisions) {
      all += of_two_bodies(collision) ? 1.0 : 0.0;
      high += of_two_bodies(collision) && collision.report.list == 0 ? 1.0 : 0.0;
    }
    // Another start than the pilot's: three standard deviations of a share of so many.
    EXPECT_NEAR(high / all, 0.5, 0.05 + 1.5 / std::sqrt(all));
    EXPECT_GT(all, 50.0);
  }
}

TEST(SchedulerDistribution, ACollisionsPriorityIsItsMetricAndDecidesItsList) {
  const WholeRun& run = whole_run();
  for (std::size_t i = 0; i < run.plan.size(); ++i) {
    const double threshold = run.plan[i].solved.at(0).value;
    const auto metric = make_metric(std::get<std::string>(run.plan[i].condition[0].value));
    const StagedScene scene = run.scenes.stage(run.plan[i], assumed_screen());
    for (const CollisionRecord& collision : run.recorder.attempts[i].collisions) {
      ASSERT_TRUE(collision.priority);
      EXPECT_EQ(collision.report.list, metric->meets(*collision.priority, threshold) ? 0 : 1);
      if (!of_two_bodies(collision)) {
        continue;
      }
      const double apart_m = (collision.pose_a.position - collision.pose_b.position).norm();
      if (scene.scheduler == "gap") {
        EXPECT_EQ(*collision.priority, apart_m);
      }
      if (scene.scheduler == "collision-speed") {
        EXPECT_EQ(*collision.priority, *collision.collision_speed_deg_s);
      }
      EXPECT_NEAR(*collision.distance_m,
                  (collision.report.contact.touch.point - scene.viewer.eye).norm(), 1e-15);
    }
  }
}

TEST(SchedulerDistribution, SchedulersDoNotChangeWhatHappens) {
  const auto& attempts = whole_run().recorder.attempts;
  EXPECT_EQ(attempts[0].steps.back().state.hash, attempts[2].steps.back().state.hash)
      << "equal spheres of one level, and one start";
}

TEST(EqualLists, AThresholdThatCannotReachItsShareIsRefusedByName) {
  // The fit error of equal bodies is one number: it parts nothing.
  const Protocol study = short_study(json::array({"gap-bound"}));
  ShapeLibrary shapes;
  EXPECT_EQ(refusal([&] { static_cast<void>(solve(study, shapes)); }),
            "d.json:/solve/0: expected a threshold that parts the pilot's collisions 50 to 50 "
            "within 5 %, but under {\"scheduler\":\"gap-bound\"} the best found parts them 100 to "
            "0");
}

/// The sentence with which the shipped study is refused with one value changed.
std::string refused_with(const std::string& pointer, const json& value,
                         const json& scene = json::parse(shipped("stimuli/spheres-in-view.json"))) {
  json document = json::parse(shipped("protocols/scheduler-distribution.json"));
  document[json::json_pointer(pointer)] = value;
  return refusal([&] {
    static_cast<void>(
        make_protocol(parse_json("d.json", document.dump()), parse_json("s.json", scene.dump())));
  });
}

/// Spheres before the viewer with 4 ms of work a step.
json scene_by_time() {
  json scene = json::parse(shipped("stimuli/spheres-in-view.json"));
  scene["engine"]["budget"] = {{"counts", "all-phases"}, {"ms_per_step", 4}};
  return scene;
}

TEST(Participants, WithoutThemABudgetInMillisecondsIsTimedAllTheSame) {
  json document = json::parse(shipped("protocols/scheduler-distribution.json"));
  document.erase("solve");
  document["design"]["factors"][0]["levels"] = {"size"};
  json scene = scene_by_time();
  scene["duration_s"] = 0.1;
  const Protocol protocol =
      make_protocol(parse_json("d.json", document.dump()), parse_json("s.json", scene.dump()));
  const ProtocolScenes scenes(protocol, 0.0);
  MemoryRecorder recorder;
  const Plan plan = make_plan(protocol.design, {protocol.name, "nobody", 1});
  run_unattended(plan, {}, scenes, assumed_screen(), recorder, SteadyClock());
  ASSERT_EQ(recorder.attempts.size(), plan.size());
  EXPECT_GT(recorder.attempts.front().steps.size(), 1U);
}

TEST(Participants, NobodyIsAskedOrShownAnything) {
  EXPECT_EQ(refused_with("/rating", json::parse(shipped("protocols/gap.json"))["rating"]),
            "d.json:/rating: expected none where nobody takes part");
  EXPECT_EQ(refused_with("/design/practice", json::array({{{"scheduler", "gap"}}})),
            "d.json:/design/practice: expected none where nobody takes part");
  EXPECT_EQ(Study().without("/timing").refused(),
            "protocols/causality.json:/: expected the key \"timing\", which is missing");
}

TEST(EqualLists, NeedTwoListsAndAThresholdBetweenThem) {
  EXPECT_EQ(refused_with("/solve/0/pointer", "/engine/schedule/thresholds/1"),
            "d.json:/solve/0/pointer: expected \"/engine/schedule/thresholds/0\", got "
            "\"/engine/schedule/thresholds/1\"");
}

TEST(EqualLists, OfAPilotThatTimeWouldCutAreRefused) {
  EXPECT_EQ(
      refused_with("/title", "x", scene_by_time()),
      "d.json:/solve/0: expected a scene with a budget in tests_per_step or without any, for a "
      "pilot finds the same on every machine, but s.json has one of 4 ms_per_step");
}

}  // namespace impetus::scheduler_distribution_test
