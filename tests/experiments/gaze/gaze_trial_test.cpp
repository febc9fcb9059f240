// Trials of the gaze-contingent study: what the gaze decides, what is recorded, what replays.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "experiments/gaze/gaze_latency.hpp"
#include "experiments/gaze/region_source.hpp"
#include "experiments/run/replay.hpp"
#include "experiments/session/trial.hpp"
#include "tests/experiments/fakes.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::gaze_trial_test {

/// The shipped study with stimuli of 1.5 s.
Protocol short_study(const std::function<void(json& protocol, json& scene)>& change = {}) {
  json protocol = json::parse(shipped("protocols/gaze-contingent.json"));
  json scene = json::parse(shipped("stimuli/l-blocks-in-a-cube.json"));
  scene["duration_s"] = 1.5;
  if (change) {
    change(protocol, scene);
  }
  return make_protocol(parse_json("gaze.json", protocol.dump()),
                       parse_json("cube.json", scene.dump()));
}

PlannedTrial trial_of(const std::string& scheduling, double bodies = 5.0,
                      std::int64_t repetition = 1, std::uint64_t seed = 1) {
  PlannedTrial trial;
  trial.repetition = repetition;
  trial.condition = {{"scheduling", scheduling}, {"bodies", bodies}};
  trial.seed = seed;
  return trial;
}

constexpr std::int64_t kMs = 1'000'000;

/// A laboratory whose participant looks along a circle of 4 cm, a turn a second.
struct GazeLab : TestLab {
  explicit GazeLab(Protocol study = short_study(), std::int64_t sample_age_ns = 5 * kMs)
      : TestLab(60.0, std::move(study)), eye(clock, sample_age_ns) {
    gaze = &eye;
    eye.at = [](std::int64_t taken_ns) {
      const double turn = 2.0 * std::acos(-1.0) * static_cast<double>(taken_ns) / 1e9;
      return Fixation{{0.04 * std::cos(turn), 0.04 * std::sin(turn)}};
    };
  }

  AttemptRecord run(const PlannedTrial& trial) {
    return run_attempt(trial, 1, protocol.script, {}, ports()).record;
  }
  [[nodiscard]] StagedScene scene_of(const PlannedTrial& trial) const {
    return scenes.stage(trial, display.geometry());
  }

  ScriptedGaze eye;
};

std::vector<std::uint64_t> hashes(const AttemptRecord& record) {
  std::vector<std::uint64_t> result;
  for (const StepRecord& step : record.steps) {
    result.push_back(step.state.hash);
  }
  return result;
}

TEST(GazeTrial, AllGoodAndAllBadShowEveryParticipantTheSame) {
  GazeLab one;
  GazeLab other(short_study(), 40 * kMs);
  other.eye.at = [](std::int64_t) { return Fixation{{-0.05, 0.02}}; };
  for (const char* kind : {"all-good", "all-bad"}) {
    for (const double bodies : {5.0, 10.0, 15.0}) {
      const auto shown = hashes(one.run(trial_of(kind, bodies, 2, 7)));
      EXPECT_EQ(hashes(other.run(trial_of(kind, bodies, 2, 8))), shown) << kind << bodies;
      EXPECT_NE(hashes(other.run(trial_of(kind, bodies, 3, 7))), shown) << kind << bodies;
    }
  }
}

TEST(GazeTrial, EveryKindStartsAlike) {
  GazeLab lab;
  std::set<std::uint64_t> starts;
  for (const char* kind : {"all-good", "all-bad", "tracked", "random"}) {
    starts.insert(lab.run(trial_of(kind)).steps.front().state.hash);
  }
  EXPECT_EQ(starts.size(), 1U);
}

TEST(GazeTrial, AllGoodIsFinestAndAllBadIsTheBoundingSphere) {
  GazeLab lab;
  const AttemptRecord good = lab.run(trial_of("all-good", 15.0));
  const AttemptRecord bad = lab.run(trial_of("all-bad", 15.0));
  ASSERT_GT(good.collisions.size(), 5U);
  ASSERT_GT(bad.collisions.size(), 5U);
  for (const CollisionRecord& collision : good.collisions) {
    EXPECT_EQ(collision.report.level, 4);
    EXPECT_FALSE(collision.region_eccentricity_deg);
  }
  for (const CollisionRecord& collision : bad.collisions) {
    EXPECT_EQ(collision.report.level, 0);
    EXPECT_FALSE(collision.region_eccentricity_deg);
  }
}

// Inside the region: list 0, finest level. Outside: list 1, bounding spheres.
TEST(GazeTrial, TrackedCollisionsAreGoodWhereTheRegionIs) {
  GazeLab lab;
  std::int64_t inside = 0;
  std::int64_t outside = 0;
  for (std::int64_t repetition = 1; repetition <= 3; ++repetition) {
    const AttemptRecord record = lab.run(trial_of("tracked", 15.0, repetition));
    for (const CollisionRecord& collision : record.collisions) {
      ASSERT_TRUE(collision.region_eccentricity_deg && collision.gaze_eccentricity_deg);
      EXPECT_EQ(*collision.region_eccentricity_deg, *collision.gaze_eccentricity_deg);
      EXPECT_EQ(collision.report.level, collision.report.list == 0 ? 4 : 0);
      // A pair is judged by where its bounds meet, a contact may lie a block's length aside.
      const double block_deg = 2.0;
      if (collision.report.list == 0) {
        EXPECT_LE(*collision.region_eccentricity_deg, 5.0 + block_deg);
        ++inside;
      } else {
        EXPECT_GE(*collision.region_eccentricity_deg, 5.0 - block_deg);
        ++outside;
      }
    }
  }
  EXPECT_GT(inside, 3);
  EXPECT_GT(outside, 3);
}

TEST(GazeTrial, TrackedReplaysFromTheLoggedGazeAndFromNoOther) {
  GazeLab lab;
  const PlannedTrial trial = trial_of("tracked", 10.0);
  const AttemptRecord record = lab.run(trial);
  EXPECT_FALSE(replay(lab.scene_of(trial), record.steps).divergence);
  std::vector<StepRecord> blind = record.steps;
  for (StepRecord& step : blind) {
    step.gaze = {};
  }
  EXPECT_TRUE(replay(lab.scene_of(trial), blind).divergence);
}

TEST(GazeTrial, RandomReplaysFromTheLoggedRegions) {
  GazeLab lab;
  const PlannedTrial trial = trial_of("random", 10.0);
  EXPECT_FALSE(replay(lab.scene_of(trial), lab.run(trial).steps).divergence);
}

TEST(GazeTrial, ARandomRegionIsNewEveryQuarterSecondAndWithinTheEnclosuresImage) {
  GazeLab lab;
  const PlannedTrial trial = trial_of("random", 5.0, 1, 9);
  const AttemptRecord record = lab.run(trial);
  const StagedScene scene = lab.scene_of(trial);
  const EnclosureImage image(scene.world.settings().enclosure, scene.viewer);
  std::set<double> places;
  for (const StepRecord& step : record.steps) {
    if (step.step == 0) {
      continue;
    }
    ASSERT_TRUE(step.gaze.region);
    EXPECT_TRUE(image.contains(step.gaze.region->centre));
    EXPECT_EQ(step.gaze.region->radius_deg, 5.0);
    places.insert(step.gaze.region->centre.x_m);
    EXPECT_EQ(static_cast<std::int64_t>(places.size()), (step.step - 1) / 60 + 1) << step.step;
  }
  const AttemptRecord again = lab.run(trial_of("random", 5.0, 1, 10));
  EXPECT_NE(again.steps[1].gaze.region->centre, record.steps[1].gaze.region->centre);
}

// At 60 Hz frame k shows steps up to 4k; each of its steps was told the newest sample before it.
TEST(GazeTrial, EveryStepKnowsItsSampleItsAgeAndTheFrameThatShowedIt) {
  GazeLab lab;
  const AttemptRecord record = lab.run(trial_of("tracked"));
  EXPECT_EQ(record.gaze_source, "scripted");
  const std::int64_t fixation_frames = 30;
  for (const StepRecord& step : record.steps) {
    const std::int64_t frame = (step.step + 3) / 4;
    EXPECT_EQ(step.shown_frame, fixation_frames + frame);
    if (step.step > 0) {
      ASSERT_TRUE(step.gaze.fixation);
      EXPECT_EQ(step.gaze.age_ns, 5 * kMs);
      EXPECT_EQ(*step.gaze.fixation, *lab.eye.at(step.gaze.taken_ns));
      EXPECT_EQ(step.gaze.region->centre, *step.gaze.fixation);
    }
  }
  // A frame of 16.67 ms from the sample's use to its flip, and 5 ms before.
  ASSERT_TRUE(record.gaze_latency_p95_ms);
  EXPECT_NEAR(*record.gaze_latency_p95_ms, 5.0 + 1e3 / 60.0, 1e-3);
}

/// A recorded gaze, played again: each sample comes as long after the stimulus's onset as it did
/// then.
class RecordedGaze final : public Gaze {
 public:
  /// `samples` in order of time, with `onset_ns` of their trial. `clock` must outlive this.
  RecordedGaze(std::vector<GazeSample> samples, std::int64_t onset_ns, const Clock& clock)
      : clock_(clock), samples_(std::move(samples)), then_ns_(onset_ns) {}

  [[nodiscard]] std::string source() const override { return "recording"; }

  /// What is due by now; nothing before the onset. Stamps are of this session's clock.
  std::vector<GazeSample> take_samples() override {
    std::vector<GazeSample> due;
    while (onset_ns_ && next_ < samples_.size()) {
      GazeSample sample = samples_[next_];
      sample.taken_ns += *onset_ns_ - then_ns_;
      if (sample.taken_ns > clock_.now_ns()) {
        break;
      }
      due.push_back(sample);
      ++next_;
    }
    return due;
  }

  /// The first picture with something in it is the onset.
  void shown(const Picture& picture, const Flip& flip) override {
    if (!onset_ns_ && !picture.bodies.empty()) {
      onset_ns_ = flip.flipped_ns;
    }
  }

 private:
  const Clock& clock_;
  std::vector<GazeSample> samples_;
  std::int64_t then_ns_;
  std::optional<std::int64_t> onset_ns_;
  std::size_t next_{0};
};

// A recording's samples stand as far from the onset as they did.
TEST(GazeTrial, ARecordedGazeLeadsToTheSameTrial) {
  GazeLab lab;
  const PlannedTrial trial = trial_of("tracked", 10.0);
  const AttemptRecord first = lab.run(trial);
  lab.clock.advance_by(12'345'678'901);
  RecordedGaze recording(first.gaze, first.onset_ns, lab.clock);
  lab.gaze = &recording;
  const AttemptRecord again = lab.run(trial);
  EXPECT_EQ(again.gaze_source, "recording");
  ASSERT_EQ(again.steps.size(), first.steps.size());
  // What was sampled before the onset is not in the recording; from its first sample on, the gaze
  // is the same at every step.
  std::int64_t known = 0;
  for (std::size_t i = 0; i < first.steps.size(); ++i) {
    const GazeInput& now = again.steps[i].gaze;
    if (now.fixation) {
      ++known;
      EXPECT_EQ(*now.fixation, *first.steps[i].gaze.fixation) << i;
      EXPECT_EQ(now.taken_ns - again.onset_ns, first.steps[i].gaze.taken_ns - first.onset_ns);
      EXPECT_EQ(now.age_ns, first.steps[i].gaze.age_ns);
    }
  }
  EXPECT_GE(known, static_cast<std::int64_t>(first.steps.size()) - 5);
}

TEST(GazeTrial, LatencyIsJudgedOnlyWhereTheGazeDecides) {
  GazeLab lab;
  EXPECT_FALSE(lab.run(trial_of("all-good")).gaze_latency_p95_ms);
  EXPECT_FALSE(lab.run(trial_of("random")).gaze_latency_p95_ms);
}

TEST(GazeTrial, WhileTheEyeIsLostTheLastPlaceStaysAndAges) {
  GazeLab lab;
  std::int64_t calls = 0;
  lab.eye.at = [&](std::int64_t) {
    ++calls;
    return calls > 10 && calls <= 20 ? Fixation{} : Fixation{{0.01, 0.0}};
  };
  const AttemptRecord record = lab.run(trial_of("tracked"));
  std::int64_t oldest_ns = 0;
  for (const StepRecord& step : record.steps) {
    oldest_ns = std::max(oldest_ns, step.gaze.age_ns);
    EXPECT_TRUE(step.step == 0 || step.gaze.fixation);
  }
  // Ten frames without a sample.
  EXPECT_NEAR(static_cast<double>(oldest_ns) / 1e6, 5.0 + 10 * 1e3 / 60.0, 0.01);
  const auto lost = std::count_if(record.gaze.begin(), record.gaze.end(),
                                  [](const GazeSample& sample) { return !sample.at; });
  EXPECT_EQ(lost, 10);
}

TEST(GazeTrial, WithoutASampleYetATrackedTrialHasNoRegion) {
  GazeLab lab;
  lab.eye.at = [](std::int64_t) { return Fixation{}; };
  const AttemptRecord record = lab.run(trial_of("tracked"));
  for (const StepRecord& step : record.steps) {
    EXPECT_FALSE(step.gaze.fixation || step.gaze.region);
  }
  EXPECT_FALSE(record.gaze_latency_p95_ms);
  EXPECT_FALSE(record.region_covered_share);
}

TEST(GazeTrial, AnImposedLatencyKeepsYoungSamplesBack) {
  GazeLab lab(
      short_study([](json& protocol, json&) { protocol["gaze"]["extra_latency_ms"] = 50; }));
  const AttemptRecord record = lab.run(trial_of("tracked"));
  for (const StepRecord& step : record.steps) {
    if (step.gaze.fixation) {
      EXPECT_GE(step.gaze.age_ns, 50 * kMs);
      EXPECT_LT(step.gaze.age_ns, 50 * kMs + 17 * kMs);
    }
  }
  EXPECT_GT(*record.gaze_latency_p95_ms, 60.0);
}

TEST(GazeTrial, ClicksAreKeptRawFromTheFirstFrameOn) {
  GazeLab lab;
  std::int64_t call = 0;
  lab.input.on_clicks = [&]() -> std::vector<ClickRecord> {
    ++call;
    if (call == 1) {  // made before the stimulus
      return {{"mouse", 1, 0}};
    }
    return call == 30 ? std::vector<ClickRecord>{{"mouse", lab.clock.now_ns(), 500'000},
                                                 {"key", lab.clock.now_ns() + 10, 0}}
                      : std::vector<ClickRecord>{};
  };
  const AttemptRecord record = lab.run(trial_of("all-bad"));
  ASSERT_EQ(record.clicks.size(), 2U);
  EXPECT_EQ(record.clicks[0].device, "mouse");
  EXPECT_EQ(record.clicks[0].arrival_uncertainty_ns, 500'000);
  EXPECT_GE(record.clicks[0].arrived_ns, record.onset_ns);
  EXPECT_EQ(record.clicks[1].device, "key");
}

TEST(GazeTrial, NothingIsFollowedThatTheProtocolDoesNotAskFor) {
  GazeLab lab{causality()};
  lab.input.on_clicks = []() -> std::vector<ClickRecord> {
    ADD_FAILURE() << "clicks were taken";
    return {};
  };
  const PlannedTrial trial = make_plan(lab.protocol.design, {"causality", "P01", 1}).front();
  const AttemptRecord record = lab.run(trial);
  EXPECT_EQ(record.gaze_source, "");
  EXPECT_TRUE(record.gaze.empty());
  EXPECT_FALSE(record.steps.back().gaze.fixation);
}

TEST(GazeTrial, TheCoveredShareIsLargerInTheSmallerBox) {
  GazeLab lab;
  const double small = *lab.run(trial_of("tracked", 5.0)).region_covered_share;
  const double large = *lab.run(trial_of("tracked", 15.0)).region_covered_share;
  // Images' areas stand nearly as edges squared: 3^(2/3) = 2.08.
  EXPECT_GT(small / large, 1.8);
  EXPECT_LT(small / large, 2.8);
}

TEST(GazeTrial, ABudgetInMillisecondsReplaysFromWhatWasGranted) {
  // Time passes with every look at the clock, so steps get less than they want.
  class RacingClock final : public Clock {
   public:
    [[nodiscard]] std::int64_t now_ns() const override { return now_ns_ += 20'000; }

   private:
    mutable std::int64_t now_ns_{0};
  };
  GazeLab lab(short_study([](json&, json& scene) {
    scene["engine"]["budget"] = {{"ms_per_step", 0.05}};
    scene["engine"]["schedule"]["lists"][0]["least_level"] = 0;
  }));
  const RacingClock racing;
  Ports ports = lab.ports();
  ports.work_clock = &racing;
  const PlannedTrial trial = trial_of("all-good", 15.0);
  const StagedScene scene = lab.scene_of(trial);
  const AttemptRecord record = run_attempt(trial, 1, lab.protocol.script, {}, ports).record;
  EXPECT_FALSE(replay(scene, record.steps).divergence);
  const auto cut_short = std::count_if(
      record.collisions.begin(), record.collisions.end(),
      [](const CollisionRecord& one) { return one.report.stop == StopReason::kBudgetSpent; });
  EXPECT_GT(cut_short, 0);
}

}  // namespace impetus::gaze_trial_test
