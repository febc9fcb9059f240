// The simulated participant of the gaze-contingent study, on hand-made records of trials.
// SPDX-License-Identifier: MIT
#include "experiments/observers/gaze_observer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/scheduling/perceived_metric.hpp"
#include "experiments/protocol/observer_file.hpp"
#include "tests/experiments/fakes.hpp"

namespace impetus::gaze_observer_test {

constexpr double kStimulus_s = 10.0;
constexpr std::int64_t kOnset_ns = 5'000'000'000;
constexpr double kLargeGap_m = 0.02;  // 2°
constexpr double kRadius_m = 0.01;

ObserverFile shipped_file() {
  return load_observer(source_file("experiments/observers/gaze-contingent.json").string(), "x");
}

GazeObserverParameters shipped() {
  return static_cast<const GazeObserverParameters&>(*shipped_file().parameters);
}

/// Sees every large gap, and clicks at nothing else.
GazeObserverParameters attentive() {
  GazeObserverParameters parameters = shipped();
  parameters.miss_rate = parameters.false_clicks_per_s = parameters.lapse_rate = 0.0;
  return parameters;
}

/// Balls in a closed cube of 20 cm.
StagedScene scene_of(std::size_t bodies, double azimuth_deg = 0.0) {
  WorldSettings settings;
  settings.enclosure = ClosedCube{0.1};
  StagedScene scene{World({}, {}, settings), viewer_at(assumed_screen(), azimuth_deg), {}};
  scene.looks.assign(bodies, {"ball", kRadius_m, {}, nullptr});
  return scene;
}

/// Bodies 0 and 1, side by side about the screen's centre.
CollisionRecord collision(double time_s, double gap_m, double eccentricity_deg = 0.0) {
  CollisionRecord record;
  record.report.bodies = {0, 1};
  record.time_s = time_s;
  record.first_frame_shown = 0;
  record.gaze_eccentricity_deg = eccentricity_deg;
  const double x_m = kRadius_m + 0.5 * gap_m;
  record.pose_a.position = Vector3(-x_m, 0.0, 0.0);
  record.pose_b.position = Vector3(x_m, 0.0, 0.0);
  return record;
}

AttemptRecord trial(std::vector<CollisionRecord> collisions) {
  AttemptRecord record;
  record.onset_ns = kOnset_ns;
  record.collisions = std::move(collisions);
  FrameRecord last;
  last.flip.flipped_ns = kOnset_ns + std::llround(kStimulus_s * 1e9);
  record.frames.push_back(last);
  return record;
}

/// One collision a second.
AttemptRecord every_second(double gap_m, double eccentricity_deg = 0.0, double approach_m_s = 0.0) {
  std::vector<CollisionRecord> collisions;
  for (int second = 0; second < 9; ++second) {
    collisions.push_back(collision(second + 0.5, gap_m, eccentricity_deg));
    collisions.back().report.approach_m_s = approach_m_s;
  }
  return trial(std::move(collisions));
}

struct Participant {
  explicit Participant(const GazeObserverParameters& parameters, const std::string& name = "S01")
      : observer(parameters, {1, name, clock, clock}) {}

  /// Seconds from onset.
  std::vector<double> clicks(const AttemptRecord& shown, const StagedScene& scene) {
    observer.witnessed(shown, scene);
    std::vector<double> clicks_s;
    for (const ClickRecord& click : observer.take_clicks()) {
      clicks_s.push_back(static_cast<double>(click.arrived_ns - kOnset_ns) / 1e9);
    }
    return clicks_s;
  }
  /// On five points, 5 best.
  double rating(const AttemptRecord& shown, const StagedScene& scene) {
    observer.witnessed(shown, scene);
    Page page;
    page.layout = Page::Layout::kScale;
    page.response = "rating";
    page.choices.resize(5);
    page.best_choice = 4;
    return 1.0 + static_cast<double>(observer.ask(page).choice);
  }

  VirtualClock clock;
  GazeObserver observer;
};

constexpr int kPeople = 300;

double mean_clicks(const GazeObserverParameters& parameters, const AttemptRecord& shown,
                   const StagedScene& scene) {
  Participant participant(parameters);
  double sum = 0.0;
  for (int i = 0; i < kPeople; ++i) {
    sum += static_cast<double>(participant.clicks(shown, scene).size());
  }
  return sum / kPeople;
}

double mean_rating(const AttemptRecord& shown) {
  double sum = 0.0;
  for (int i = 0; i < kPeople; ++i) {
    sum += Participant(shipped(), "S" + std::to_string(i)).rating(shown, scene_of(5));
  }
  return sum / kPeople;
}

// ---------------------------------------------------------------- what is seen

// P = (1 − λ) Φ(log₁₀(g/g₅₀)/width), g₅₀ = 10′ · (1 + e/2.3) · (60/G(v)) · (1 + .05 (N − 2)).
TEST(GazeObserver, SeesAGapByTheStatedModel) {
  ASSERT_EQ(shipped().miss_rate, 0.1);
  Participant participant(shipped());
  const auto seen = [&](double gap_arcmin, double e, double v, std::size_t n) {
    return participant.observer.seen_gap(gap_arcmin, e, v, n);
  };
  EXPECT_NEAR(seen(10.0, 0.0, 0.0, 2), 0.9 * 0.5, 1e-12);
  EXPECT_NEAR(seen(20.0, 2.3, 0.0, 2), 0.9 * 0.5, 1e-12);
  EXPECT_NEAR(seen(10.0 * 60.0 / 29.91, 0.0, 10.0, 2), 0.9 * 0.5, 1e-4);  // G(10) to 2 digits
  EXPECT_NEAR(seen(14.0, 0.0, 0.0, 10), 0.9 * 0.5, 1e-12);
  EXPECT_NEAR(seen(10.0 * std::pow(10.0, 0.2), 0.0, 0.0, 2), 0.9 * 0.841345, 1e-6);
  EXPECT_EQ(seen(0.0, 0.0, 0.0, 2), 0.0);
}

TEST(GazeObserver, SeesWhatTheSchedulerPerceivedThinksIsNoticed) {
  const Noticing assumed;
  const GazeObserverParameters own = shipped();
  EXPECT_EQ(assumed.threshold_arcmin, own.threshold_arcmin);
  EXPECT_EQ(assumed.width_log10, own.width_log10);
  EXPECT_EQ(assumed.miss_rate, own.miss_rate);
  Participant participant(own);
  for (const double gap_arcmin : {0.0, 5.0, 20.0, 300.0}) {
    for (const double eccentricity_deg : {0.0, 3.0, 15.0}) {
      for (const double speed_deg_s : {0.0, 10.0, 60.0}) {
        const double threshold = noticed_threshold_arcmin(assumed, eccentricity_deg, speed_deg_s);
        EXPECT_NEAR(noticed_share(assumed, gap_arcmin, threshold),
                    participant.observer.seen_gap(gap_arcmin, eccentricity_deg, speed_deg_s, 2),
                    1e-12);
      }
    }
  }
}

TEST(GazeObserver, ClicksLessWhereTheGapIsPeripheralFastCrowdedOrSmall) {
  const double gap_m = 0.005;  // 30′
  const double clear = mean_clicks(shipped(), every_second(gap_m), scene_of(2));
  EXPECT_GT(clear, 7.0);
  EXPECT_LT(mean_clicks(shipped(), every_second(gap_m, 10.0), scene_of(2)), 0.5 * clear);
  EXPECT_LT(mean_clicks(shipped(), every_second(gap_m, 0.0, 0.4), scene_of(2)), 0.5 * clear);
  EXPECT_LT(mean_clicks(shipped(), every_second(gap_m), scene_of(60)), 0.8 * clear);
  EXPECT_LT(mean_clicks(shipped(), every_second(0.0005), scene_of(2)), 0.1 * clear);
}

TEST(GazeObserver, DoesNotSeeWhatABodyHidesOrNoFrameShowed) {
  Participant participant(attentive());
  // Seen along the line of the two.
  EXPECT_TRUE(participant.clicks(every_second(kLargeGap_m), scene_of(2, 90.0)).empty());
  AttemptRecord unshown = every_second(kLargeGap_m);
  for (CollisionRecord& one : unshown.collisions) {
    one.first_frame_shown = -1;
  }
  EXPECT_TRUE(participant.clicks(unshown, scene_of(2)).empty());
}

TEST(GazeObserver, TakesTheScreensCentreWhereGazeWasNotFollowed) {
  AttemptRecord peripheral = every_second(0.005);
  for (CollisionRecord& one : peripheral.collisions) {
    one.gaze_eccentricity_deg.reset();
    one.eccentricity_deg = 100.0;
  }
  EXPECT_EQ(mean_clicks(attentive(), peripheral, scene_of(2)), 0.0);
}

TEST(GazeObserver, SeesAGapToAWall) {
  const auto against_wall = [](double gap_m) {
    AttemptRecord record = trial({collision(1.0, 0.0)});
    record.collisions[0].report.bodies = {0,
                                          wall_index(1)};  // the left wall, 10 cm from the centre
    record.collisions[0].pose_a.position = Vector3(-0.1 + kRadius_m + gap_m, 0.0, 0.0);
    return record;
  };
  Participant participant(attentive());
  EXPECT_EQ(participant.clicks(against_wall(kLargeGap_m), scene_of(2)).size(), 1U);
  EXPECT_TRUE(participant.clicks(against_wall(0.0), scene_of(2)).empty());
}

// ---------------------------------------------------------------- when it clicks

TEST(GazeObserver, ReactsWithTheStatedTimes) {
  Participant participant(attentive());
  std::vector<double> logs;
  for (int i = 0; i < 2000; ++i) {
    const auto clicks_s = participant.clicks(trial({collision(1.0, kLargeGap_m)}), scene_of(2));
    ASSERT_EQ(clicks_s.size(), 1U);
    logs.push_back(std::log(clicks_s[0] - 1.0));
  }
  double mean = 0.0;
  double variance = 0.0;
  for (const double log : logs) {
    mean += log / 2000;
  }
  for (const double log : logs) {
    variance += (log - mean) * (log - mean) / 2000;
  }
  EXPECT_NEAR(mean, std::log(0.55), 4.0 * 0.25 / std::sqrt(2000));  // four standard errors
  EXPECT_NEAR(std::sqrt(variance), 0.25, 4.0 * 0.25 / std::sqrt(4000));
}

TEST(GazeObserver, ClicksFalselyAtTheStatedRate) {
  Participant participant(shipped());
  int clicks = 0;
  for (int i = 0; i < 2000; ++i) {
    clicks += static_cast<int>(participant.clicks(trial({}), scene_of(5)).size());
  }
  // .05 per second for 20,000 s, less the 2 % within 400 ms of another; four standard errors.
  EXPECT_NEAR(clicks, 1000 * 0.98, 4.0 * std::sqrt(1000));
}

TEST(GazeObserver, TakesCollisionsLessThanATenthOfASecondApartForOne) {
  Participant participant(attentive());
  const auto clicks = [&](double apart_s) {
    return participant
        .clicks(trial({collision(1.0, kLargeGap_m), collision(1.0 + apart_s, kLargeGap_m)}),
                scene_of(2))
        .size();
  };
  EXPECT_EQ(clicks(0.099), 1U);
  EXPECT_EQ(clicks(4.0), 2U);
}

TEST(GazeObserver, RestsBetweenClicksAndStopsWithTheStimulus) {
  std::vector<CollisionRecord> many;
  for (int i = 0; i < 66; ++i) {
    many.push_back(collision(0.15 * i, kLargeGap_m));
  }
  Participant participant(shipped());
  std::size_t most = 0;
  for (int run = 0; run < 200; ++run) {
    const auto clicks_s = participant.clicks(trial(many), scene_of(2));
    most = std::max(most, clicks_s.size());
    for (std::size_t i = 0; i < clicks_s.size(); ++i) {
      EXPECT_GE(clicks_s[i], i == 0 ? 0.0 : clicks_s[i - 1] + 0.4 - 1e-9);  // whole nanoseconds
      EXPECT_LE(clicks_s[i], kStimulus_s);
    }
  }
  EXPECT_GT(most, 15U);  // of 25 that the rests leave room for
}

TEST(GazeObserver, HandsItsClicksOverOnce) {
  Participant participant(attentive());
  EXPECT_TRUE(participant.observer.take_clicks().empty());
  participant.observer.witnessed(every_second(kLargeGap_m), scene_of(2));
  const auto clicks = participant.observer.take_clicks();
  ASSERT_FALSE(clicks.empty());
  EXPECT_EQ(clicks[0].device, "simulated");
  EXPECT_TRUE(participant.observer.take_clicks().empty());
}

TEST(GazeObserver, AnswersFollowFromSeedAndPseudonym) {
  const auto clicks = [](const std::string& name) {
    return Participant(shipped(), name).clicks(every_second(0.005), scene_of(5));
  };
  EXPECT_EQ(clicks("S01"), clicks("S01"));
  EXPECT_NE(clicks("S01"), clicks("S02"));
}

// ---------------------------------------------------------------- how it rates

TEST(GazeObserver, RatesByHowMuchBadItSaw) {
  const double nothing = mean_rating(trial({}));
  const double periphery = mean_rating(every_second(0.003, 4.0));
  const double at_the_gaze = mean_rating(every_second(kLargeGap_m));
  EXPECT_NEAR(nothing, 4.2, 0.2);  // stated to one digit; four standard errors of 300 people
  EXPECT_LT(at_the_gaze, 2.2);
  EXPECT_GT(periphery, at_the_gaze + 0.5);
  EXPECT_LT(periphery, nothing - 0.2);
}

TEST(GazeObserver, BringsItsEyeAndTheOthersHaveNone) {
  VirtualClock clock;
  const auto with = make_observer(shipped_file(), {1, "S01", clock, clock});
  ASSERT_NE(with->eye(), nullptr);
  EXPECT_EQ(with->eye()->source(), "simulated eye");
  const auto causality =
      load_observer(source_file("experiments/observers/causality.json").string(), "x");
  EXPECT_EQ(make_observer(causality, {1, "S01", clock, clock})->eye(), nullptr);
}

TEST(GazeObserver, ItsEyeIsTheOneThatOthersHave) {
  EXPECT_EQ(static_cast<const EyeParameters&>(shipped()), usual_eye());
}

// As they are drawn: the second of two begins an event only where the first was not seen.
TEST(GazeOutcomes, OfTwoCollisionsThatCountAsOneEventThereIsOneAtMost) {
  const ObserverFile file = shipped_file();
  const auto chances_at = [&](double apart_s) {
    const double gap_arcmin = shipped().threshold_arcmin;
    const Percept percept{kStimulus_s, 2.0,           1.0,        gap_arcmin, 0.0,
                          0.0,         1.0 + apart_s, gap_arcmin, 0.0,        0.0};
    std::vector<Outcome> outcomes;
    file.kind->answers.outcomes(*file.parameters, percept, nullptr, outcomes);
    std::vector<double> chances;
    for (const Outcome& outcome : outcomes) {
      chances.push_back(outcome.probability);
    }
    return chances;
  };
  const double unseen = 1.0 - 0.5 * (1.0 - shipped().miss_rate);
  const std::vector<double> near = chances_at(0.05);
  ASSERT_EQ(near.size(), 2U);
  EXPECT_NEAR(near[0], unseen * unseen, 1e-9);
  EXPECT_NEAR(near[1], 1.0 - unseen * unseen, 1e-9);
  EXPECT_EQ(chances_at(0.2).size(), 3U);
}

}  // namespace impetus::gaze_observer_test
