// The study of crowds: what its file asks for, what a trial of it records, that it replays.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <filesystem>

#include "experiments/files/protocol_files.hpp"
#include "experiments/protocol/observer_file.hpp"
#include "experiments/run/replay.hpp"
#include "experiments/session/trial.hpp"
#include "tests/experiments/fakes.hpp"
#include "tests/experiments/refusals.hpp"
#include "tests/places/places.hpp"

namespace impetus::crowd_study_test {

std::filesystem::path source(const char* path) {
  return std::filesystem::path(source_folder()) / path;
}

Protocol shipped_study() { return load_protocol(source("protocols/crowd.json")); }

/// The shipped study with stimuli of a second, and trees that take no time to build.
Protocol quick_study(bool by_the_clock) {
  json scene = json::parse(shipped("stimuli/creatures-in-a-cube.json"));
  scene["duration_s"] = 1;
  if (by_the_clock) {
    scene["engine"]["budget"] = {{"counts", "all-phases"}, {"ms_per_step", 4}};
  }
  scene["engine"]["tree"] = {{"kind", "octree"}};
  return make_protocol(parse_json("crowd.json", shipped("protocols/crowd.json")),
                       parse_json("creatures.json", scene.dump()));
}

PlannedTrial trial_of(const std::string& scheduler, double bodies = 50.0) {
  PlannedTrial trial;
  trial.condition = {{"scheduler", scheduler}, {"bodies", bodies}};
  return trial;
}

/// Time goes by only when it is looked at.
class LookedAtClock final : public Clock {
 public:
  explicit LookedAtClock(std::int64_t ns_per_look) : ns_per_look_(ns_per_look) {}
  [[nodiscard]] std::int64_t now_ns() const override { return now_ns_ += ns_per_look_; }

 private:
  std::int64_t ns_per_look_;
  mutable std::int64_t now_ns_{0};
};

/// A laboratory whose participant looks to the left, and whose steps take what the clock says.
struct CrowdLab : TestLab {
  /// `ns_per_look` 0: the budget is the shipped one, of work.
  explicit CrowdLab(std::int64_t ns_per_look = 0)
      : TestLab(60.0, quick_study(ns_per_look > 0)), work_clock(ns_per_look), eye(clock, 0) {
    gaze = &eye;
    eye.at = [](std::int64_t) { return Fixation{{-0.04, 0.0}}; };
  }

  AttemptRecord run(const PlannedTrial& trial) {
    Ports all = ports();
    all.work_clock = &work_clock;
    return run_attempt(trial, 1, protocol.script, {}, all).record;
  }

  LookedAtClock work_clock;
  ScriptedGaze eye;
};

constexpr std::int64_t kFastNs = 10;         // a look at the clock: nothing is left undone
constexpr std::int64_t kSlowNs = 1'000'000;  // the budget is four looks

/// Of the collisions of high priority, those that came to the finest level.
double share_resolved(const AttemptRecord& record) {
  double high = 0.0;
  double resolved = 0.0;
  for (const CollisionRecord& collision : record.collisions) {
    high += collision.report.list == 0 ? 1.0 : 0.0;
    resolved += collision.report.list == 0 && collision.report.level == 3 ? 1.0 : 0.0;
  }
  return resolved / high;
}

TEST(CrowdStudy, IsValidWithThreeTrialsOfEachOfSixCells) {
  const Protocol study = shipped_study();
  EXPECT_EQ(cells(study.design).size(), 6U);
  EXPECT_EQ(study.design.repetitions, 3);
  EXPECT_EQ(study.design.practice.size(), 3U);
  EXPECT_EQ(study.script.demonstrations.size(), 2U);
  EXPECT_FALSE(takes_clicks(study.script));
  EXPECT_TRUE(study.script.gaze);
}

TEST(CrowdStudy, ItsSimulatedParticipantAnswersIt) {
  const auto file = source("experiments/observers/crowd.json");
  EXPECT_EQ(refusal([&] { check_observer(shipped_study(), load_observer(file.string(), "x")); }),
            "accepted");
}

TEST(CrowdStudy, ASecondOfFiftyCreaturesReplaysStepByStepUnderAnyBudget) {
  for (const std::int64_t ns_per_look : {std::int64_t{0}, kFastNs, kSlowNs}) {
    CrowdLab lab(ns_per_look);
    const PlannedTrial trial = trial_of("eccentricity");
    const AttemptRecord record = lab.run(trial);
    ASSERT_EQ(record.steps.size(), 61U);
    EXPECT_GT(record.collisions.size(), 10U);
    const ReplayResult result =
        replay(lab.scenes.stage(trial, lab.display.geometry()), record.steps);
    EXPECT_FALSE(result.divergence) << ns_per_look;
    EXPECT_EQ(result.steps, 60);
  }
}

TEST(CrowdStudy, LessTimeLeavesCollisionsOfHighPriorityCoarse) {
  CrowdLab fast(kFastNs);
  CrowdLab slow(kSlowNs);
  EXPECT_EQ(share_resolved(fast.run(trial_of("eccentricity"))), 1.0);
  EXPECT_LT(share_resolved(slow.run(trial_of("eccentricity"))), 0.75);
}

TEST(CrowdStudy, CollisionsOfLowPriorityStayCoarse) {
  CrowdLab lab;
  std::array<int, 4> high{};
  std::array<int, 4> low{};
  for (const CollisionRecord& collision : lab.run(trial_of("eccentricity", 100.0)).collisions) {
    auto& levels = collision.report.list == 0 ? high : low;
    ++levels.at(static_cast<std::size_t>(collision.report.level));
  }
  EXPECT_GT(high[3], 0);
  EXPECT_EQ(high[0] + high[1] + high[2], 0) << "a hundred creatures leave the budget unspent";
  EXPECT_GT(low[1], 0);
  EXPECT_EQ(low[2] + low[3], 0);
}

TEST(CrowdStudy, TheSchedulersStartAlikeAndGoApart) {
  CrowdLab lab;
  const AttemptRecord gaze = lab.run(trial_of("eccentricity"));
  const AttemptRecord near = lab.run(trial_of("distance"));
  EXPECT_EQ(gaze.steps.front().state.hash, near.steps.front().state.hash);
  EXPECT_NE(gaze.steps.back().state.hash, near.steps.back().state.hash);
}

}  // namespace impetus::crowd_study_test
