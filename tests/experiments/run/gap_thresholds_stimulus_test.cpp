// What a participant of the gap-thresholds study is shown: a gap that is set, among distractors.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "experiments/observers/gap_observer.hpp"
#include "experiments/protocol/observer_file.hpp"
#include "experiments/run/collision_truth.hpp"
#include "experiments/run/live_run.hpp"
#include "tests/experiments/fakes.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::gap_thresholds_stimulus_test {

json shells(double gap_arcmin, double above_deg, int distractors) {
  json scene = json::parse(shipped("stimuli/shells.json"));
  scene["meeting"]["gap_arcmin"] = gap_arcmin;
  scene["meeting"]["at_deg"] = {0, above_deg};
  scene["distractors"]["count"] = distractors;
  return scene;
}

StagedScene staged(const json& scene, std::uint64_t seed) {
  ShapeLibrary library;
  return build_scene(scene, assumed_screen(), 0.0, library, "main/1", seed);
}

/// A trial to its end, and what was true of its only collision.
struct Played {
  explicit Played(const json& scene, std::uint64_t seed = 1) : live(staged(scene, seed), seed) {
    live.poses_at(live.scene().duration_s);
    collisions = live.take_collisions();
    if (!collisions.empty()) {
      const auto& looks = live.scene().looks;
      truth = measure_truth(looks[0], collisions[0].pose_a, looks[1], collisions[0].pose_b,
                            live.scene().viewer);
    }
  }

  LiveRun live;
  std::vector<CollisionRecord> collisions;
  CollisionTruth truth;
};

TEST(GapThresholdsStimulus, TheMeasuredGapIsTheOneSetWhereverTheyMeet) {
  for (const double gap_arcmin : {0.0, 3.0, 20.0, 100.0, 250.0}) {
    for (const double above_deg : {0.0, 8.0}) {
      const Played played(shells(gap_arcmin, above_deg, 0));
      ASSERT_EQ(played.collisions.size(), 1U);
      EXPECT_EQ(played.collisions[0].step, 180) << "at lead_s";
      // The shells overlap by 1e-9 of their distance at contact.
      EXPECT_NEAR(played.truth.gap_arcmin, gap_arcmin, 1e-5);
      EXPECT_EQ(played.truth.hidden_share, 0.0);
      EXPECT_NEAR(played.collisions[0].eccentricity_deg, above_deg, 0.06) << "atan is not linear";
    }
  }
}

TEST(GapThresholdsStimulus, AnObliqueViewNeedsALargerGapForTheSameAngle) {
  json oblique = shells(20.0, 0.0, 0);
  oblique["viewer"]["azimuth_deg"] = 60;
  const Played played(oblique);
  EXPECT_NEAR(played.truth.gap_arcmin, 20.0, 1e-5);
  EXPECT_NEAR(played.truth.gap_m / Played(shells(20.0, 0.0, 0)).truth.gap_m, 2.0, 0.01)
      << "1 / cos 60°, but for the depth";
}

TEST(GapThresholdsStimulus, TheyTurnStraightBack) {
  LiveRun live(staged(shells(50.0, 8.0, 0), 1), 1);
  const std::vector<Pose> start = live.poses_at(0.0);
  const std::vector<Pose> end = live.poses_at(1.5);
  for (std::size_t body = 0; body < 2; ++body) {
    // As far out as in: the rounding of 360 steps.
    EXPECT_LT((end[body].position - start[body].position).norm(), 1e-12);
  }
}

TEST(Distractors, KeepTheirDistanceFromEverythingAtEveryStepAndStayInView) {
  const json scene = shells(250.0, 8.0, 8);
  const double apart_m = metres_of(scene["distractors"]["apart_deg"].get<double>());
  const double radius_m = metres_of(0.8);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    LiveRun live(staged(scene, seed), seed);
    ASSERT_EQ(live.scene().looks.size(), 10U);
    double nearest_m = 1.0;
    for (int step = 0; step <= 360; ++step) {
      const std::vector<Pose> poses = live.poses_at(step / 240.0);
      for (std::size_t i = 2; i < poses.size(); ++i) {
        EXPECT_LE(std::abs(poses[i].position.x()), metres_of(17) + 1e-12);
        EXPECT_LE(std::abs(poses[i].position.y()), metres_of(13.5) + 1e-12);
        for (std::size_t j = 0; j < i; ++j) {
          nearest_m = std::min(nearest_m, (poses[i].position - poses[j].position).norm());
        }
      }
    }
    EXPECT_GE(nearest_m, 2.0 * radius_m + apart_m) << "seed " << seed;
    EXPECT_EQ(live.take_collisions().size(), 1U) << "of the two alone";
  }
}

TEST(Distractors, MoveStraightOnAtTheSpeedOfTheTwoAndLookLikeThem) {
  const StagedScene scene = staged(shells(20.0, 0.0, 8), 5);
  for (std::size_t body = 2; body < 10; ++body) {
    const DrawnBody& like = scene.looks[body % 2];
    EXPECT_EQ(scene.looks[body].colour, like.colour);
    EXPECT_EQ(scene.looks[body].radius_m, like.radius_m);
    EXPECT_NEAR(velocity(scene.world.models()[body], scene.world.states()[body]).norm(),
                metres_of(4.0), 1e-12);
  }
}

TEST(Distractors, FollowFromTheTrialsSeedAlone) {
  const auto first_place = [](std::uint64_t seed) {
    return staged(shells(20.0, 0.0, 8), seed).world.states()[2].pose.position;
  };
  EXPECT_EQ(first_place(1), first_place(1));
  EXPECT_NE(first_place(1), first_place(2));
}

TEST(Distractors, AreRefusedWhereTheyHaveNoRoomOrTheTwoDoNotTurnStraightBack) {
  EXPECT_EQ(scene_refusal(changed(shells(20, 0, 8), "/distractors/within_deg", {2, 2})),
            "/distractors/count: expected as many as there is room for beside the two, got 8");
  EXPECT_EQ(scene_refusal(changed(shells(20, 0, 8), "/engine/restitution", 0.5)),
            "/distractors/count: expected 0 unless two equal spheres meet head-on, without loss, "
            "and turn straight back, got 8");
}

TEST(GapThresholdsStimulus, AGapThatCannotBeSetIsRefused) {
  json along = shells(20.0, 0.0, 0);
  along["viewer"]["azimuth_deg"] = 90;
  EXPECT_EQ(scene_refusal(along),
            "/meeting/gap_arcmin: expected a gap that can be seen so large from azimuth 90, got "
            "20.0");
  json blocks = json::parse(shipped("stimuli/two-l-blocks.json"));
  blocks["meeting"]["gap_arcmin"] = 5;
  EXPECT_EQ(scene_refusal(blocks),
            "/meeting/gap_arcmin: expected none where a body is no sphere, got 5");
}

/// The log threshold that answers to these gaps are most likely to come from, by a scan, and its
/// standard error from the curvature there. The slope is known.
struct Fitted {
  double log10_threshold{0.0};
  double standard_error{0.0};
};

Fitted fitted(const std::vector<std::pair<double, bool>>& answers, const GapParameters& planted) {
  const auto loss = [&](double log10_threshold) {
    double sum = 0.0;
    for (const auto& [gap_arcmin, yes] : answers) {
      const double seen =
          planted.guess_rate +
          (1.0 - planted.guess_rate - planted.miss_rate) *
              normal_cdf((std::log10(gap_arcmin) - log10_threshold) / planted.width_log10);
      sum -= std::log(yes ? seen : 1.0 - seen);
    }
    return sum;
  };
  constexpr double kStep = 0.002;
  double best = 0.0;
  for (double candidate = 0.3; candidate < 2.8; candidate += kStep) {
    best = loss(candidate) < loss(best) ? candidate : best;
  }
  constexpr double kAside = 0.02;
  const double curvature =
      (loss(best + kAside) - 2.0 * loss(best) + loss(best - kAside)) / (kAside * kAside);
  return {best, 1.0 / std::sqrt(curvature)};
}

TEST(GapThresholdsObserver, PlantedThresholdsComeBackWithinTwoStandardErrors) {
  const ObserverFile file = load_observer("gap-thresholds", source_file("protocols/gap.json"));
  const auto& planted = static_cast<const GapParameters&>(*file.parameters);
  const AnswerModel& model = file.kind->answers;
  RandomStream stream(20'020, "answers");
  const std::vector<double> gaps{5, 8, 13, 20, 32, 50, 80, 125, 200, 250};
  for (const double above_deg : {0.0, 8.0}) {
    for (const int distractors : {0, 8}) {
      std::vector<std::pair<double, bool>> answers;
      double planted_arcmin = 0.0;
      for (const double gap_arcmin : gaps) {
        const Played played(shells(gap_arcmin, above_deg, distractors));
        AttemptRecord shown;
        shown.collisions = played.collisions;
        Percept percept = model.percept(planted, shown, played.live.scene());
        ASSERT_EQ(percept.size(), 4U) << "of one collision";
        EXPECT_EQ(percept[1], played.truth.visible_arcmin());
        const double seen = model.seen(planted, {}, percept);
        planted_arcmin = gap_threshold_arcmin(planted.threshold_arcmin, percept[2], percept[3]) *
                         (1.0 + planted.crowding_per_body * distractors);
        percept[1] = planted_arcmin;
        EXPECT_NEAR(model.seen(planted, {}, percept),
                    0.5 * (1.0 + planted.guess_rate - planted.miss_rate), 1e-12);
        for (int trial = 0; trial < 20; ++trial) {
          answers.emplace_back(gap_arcmin, stream.uniform() < seen);
        }
      }
      // 10′ (1 + e/2.3)(60 / G(8°/s))(1 + .05 (N − 2)), G(8) = 57.69 − 27.78 log₁₀ 8 = 32.60
      EXPECT_NEAR(planted_arcmin,
                  10.0 * (1.0 + above_deg / 2.3) * 60.0 / 32.602 * (1.0 + 0.05 * distractors),
                  0.01 * planted_arcmin);
      const Fitted fit = fitted(answers, planted);
      EXPECT_NEAR(fit.log10_threshold, std::log10(planted_arcmin), 2.0 * fit.standard_error)
          << "seed 20020, " << above_deg << "°, " << distractors << " distractors";
      EXPECT_LT(fit.standard_error, 0.05);
    }
  }
}

}  // namespace impetus::gap_thresholds_stimulus_test
