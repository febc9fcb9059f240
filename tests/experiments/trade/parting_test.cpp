// When trials part from what they would be at the finest level.
// SPDX-License-Identifier: MIT
#include "experiments/trade/parting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/trade/trial_starts.hpp"
#include "tests/engine/builders.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::parting_test {

constexpr double kEye_m = 10.0;

StagedScene staged(std::vector<BodyModel> models, std::vector<BodyState> states) {
  const Viewer viewer = step_of(kStep_s).viewer;
  std::vector<DrawnBody> looks(models.size());
  StagedScene scene{World(std::move(models), std::move(states), {}), viewer, std::move(looks)};
  scene.step_hz = 1.0 / kStep_s;
  scene.duration_s = 1.0;
  return scene;
}

/// A ball of 0.05 m whose root reaches 0.1 m.
BodyModel loosely_bounded_ball() {
  BodyModel model = ball(0.05, 1.0);
  const NodeSurface loose{1.0F, kNoGroup, Eigen::Vector3f::Zero(), 0.05F};
  model.tree = std::make_shared<VolumeTree>(VolumeTree(
      {{Sphere{Vector3::Zero(), 0.1}, 1, 1, loose}, {Sphere{Vector3::Zero(), 0.05}, 0, 0, {}}},
      {0, 1}));
  return model;
}

/// Two of them at 1 m/s towards each other, 0.6 m between their centres.
StagedScene head_on() {
  const BodyModel model = loosely_bounded_ball();
  return staged({model, model},
                {moving(model, {-0.3, 0, 0}, {1, 0, 0}), moving(model, {0.3, 0, 0}, {-1, 0, 0})});
}

/// Two L-blocks and two balls that fly in the free scene's cube.
json few_bodies() {
  json scene = crowd_scene();
  scene["engine"] = {{"step_hz", 120}, {"restitution", 1}, {"tree_depth", 2}};
  scene["crowd"]["count"] = 6;
  scene["enclosure"] = {{"edge_deg", 10}};
  scene["duration_s"] = 3;
  return scene;
}

PartingSetting at_level(int level, const std::string& kind = "") {
  PartingSetting setting;
  setting.kind = kind;
  setting.level = level;
  return setting;
}

PartedTrial only_trial(const StagedScene& scene, const PartingSetting& setting) {
  PartingRequest request;
  request.settings = {setting};
  request.starts = 1;
  const auto parted = partings([&](const std::string&, std::int64_t) { return scene; }, request);
  return parted.at(0).trials.at(0);
}

/// Of the times at which half of the bodies had parted, with the trial's end for those that had
/// not.
double mean_half_s(const PartedTrials& parted, double end_s) {
  double sum = 0.0;
  for (const PartedTrial& trial : parted.trials) {
    sum += std::min(trial.half_s, end_s);
  }
  return sum / static_cast<double>(parted.trials.size());
}

TEST(Parting, BodiesThatReboundTooEarlyPartWhenTheEyeCouldTell) {
  // The roots touch at 0.2 s, the balls themselves at 0.25 s. Between these times both come apart
  // at 2 m/s, and half a degree from 10 m is reached after 10 m · tan(0.5°) / 2 m/s.
  const double apart_m = kEye_m * std::tan(0.5 * std::numbers::pi / 180.0);
  const double expected_s = 0.2 + apart_m / 2.0;
  const PartedTrial trial = only_trial(head_on(), at_level(0));
  // A step of the contact, and one until it is looked at.
  EXPECT_NEAR(trial.first_s, expected_s, 2.0 * kStep_s);
  EXPECT_EQ(trial.half_s, trial.first_s) << "both at once";
  EXPECT_EQ(trial.share_together, 0.0);
}

TEST(Parting, TheFinestLevelNeverPartsFromItself) {
  for (const int level : {1, kUnlimitedLevel}) {
    const PartedTrial trial = only_trial(head_on(), at_level(level));
    EXPECT_EQ(trial.first_s, kNeverParted_s);
    EXPECT_EQ(trial.half_s, kNeverParted_s);
    EXPECT_EQ(trial.share_together, 1.0);
  }
}

TEST(Parting, ABodyAloneNeverParts) {
  BodyModel model = loosely_bounded_ball();
  BodyState state = moving(model, {-0.3, 0, 0}, {1, 0, 0});
  state.angular_momentum = Vector3(0.001, 0.0, 0.002);
  const PartedTrial trial = only_trial(staged({model}, {state}), at_level(0));
  EXPECT_EQ(trial.first_s, kNeverParted_s);
  EXPECT_EQ(trial.share_together, 1.0);
}

TEST(Parting, ABudgetOfNothingIsTheRootsAndAnEndlessOneTheFinestLevel) {
  PartingSetting nothing = at_level(kUnlimitedLevel);
  nothing.budget = 0;
  PartingSetting plenty = at_level(kUnlimitedLevel);
  plenty.budget = 1'000'000;
  EXPECT_EQ(only_trial(head_on(), nothing).first_s, only_trial(head_on(), at_level(0)).first_s);
  EXPECT_EQ(only_trial(head_on(), plenty).first_s, kNeverParted_s);
}

TEST(Parting, ComesLaterWithTheLevelAndTheBudgetOnAverage) {
  const json scene = few_bodies();
  ShapeLibrary library;
  const TrialStarts starts(scene, assumed_screen(), library, 1);
  PartingRequest request;
  request.starts = 6;
  for (const char* kind : {"octree", "box"}) {
    request.settings.push_back(at_level(0, kind));
    request.settings.push_back(at_level(1, kind));
    for (const std::int64_t budget : {0, 100'000}) {
      request.settings.push_back(at_level(kUnlimitedLevel, kind));
      request.settings.back().budget = budget;
    }
  }
  const auto parted = partings(
      [&](const std::string& kind, std::int64_t number) { return starts.staged(kind, number); },
      request);
  constexpr double kEnd_s = 3.0;
  for (std::size_t kind = 0; kind < parted.size(); kind += 4) {
    EXPECT_LT(mean_half_s(parted[kind], kEnd_s), mean_half_s(parted[kind + 1], kEnd_s))
        << parted[kind].setting.kind;
    EXPECT_LT(mean_half_s(parted[kind + 2], kEnd_s), mean_half_s(parted[kind + 3], kEnd_s))
        << parted[kind].setting.kind;
  }
}

TEST(Parting, RowsSayWhatIsCensored) {
  PartedTrials some{at_level(1), {{0.5, 2.0, 0.0}, {0.7, kNeverParted_s, 0.6}, {}}};
  const std::vector<TradeRow> rows = parting_rows({some}, "scene");
  const auto value = [&](const std::string& measure) {
    return std::find_if(rows.begin(), rows.end(),
                        [&](const TradeRow& row) { return row.measure == measure; })
        ->value;
  };
  EXPECT_DOUBLE_EQ(value("first_parting"), 0.7);
  EXPECT_TRUE(std::isnan(value("half_parted"))) << "two of three had not by the end";
  EXPECT_NEAR(value("not_parted"), 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(value("together"), 1.6 / 3.0, 1e-12);
}

TEST(TrialStarts, AreTheSameForAllKindsAndDifferFromEachOther) {
  for (const json& scene : {few_bodies(), free_scene()}) {
    ShapeLibrary library;
    const TrialStarts starts(scene, assumed_screen(), library, 1);
    const auto place = [&](const char* kind, std::int64_t number) {
      return starts.staged(kind, number).world.states()[0].pose.position;
    };
    EXPECT_EQ(place("octree", 1), place("box", 1));
    EXPECT_EQ(place("octree", 2), place("box", 2));
    EXPECT_NE(place("octree", 1), place("octree", 2));
    EXPECT_NE(place("octree", 3), place("octree", 2));
  }
}

TEST(TrialStarts, TheFirstOfASceneWithPlacesIsItsOwn) {
  const json scene = free_scene();
  ShapeLibrary library;
  const TrialStarts starts(scene, assumed_screen(), library, 1);
  EXPECT_EQ(starts.staged("", 1).world.states()[0].pose.position.x(), metres_of(-5.0));
}

}  // namespace impetus::parting_test
