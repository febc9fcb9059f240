// The simulated eye: what it looks at, how it moves, and what its tracker delivers.
// SPDX-License-Identifier: MIT
#include "experiments/observers/simulated_eye.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/observers/headless_lab.hpp"
#include "experiments/protocol/screen_file.hpp"

namespace impetus::simulated_eye_test {

using Point = Eigen::Vector2d;  // degrees right of and above the screen's centre
using Places = std::function<std::vector<Point>(double time_s)>;

double m_per_deg() { return metres_per_degree(assumed_screen().viewing_distance_m); }

/// An eye whose every sample is where it looks: no noise, no losses, no latency.
EyeParameters perfect(double sampling_hz = 1000.0) {
  EyeParameters eye;
  eye.sampling_hz = sampling_hz;
  return eye;
}

/// Bodies in the screen's plane, of 1° radius.
Picture picture_of(const std::vector<Point>& places) {
  Picture picture;
  picture.viewer = viewer_at(assumed_screen(), 0.0);
  for (const Point& place : places) {
    const Vector3 at = m_per_deg() * Vector3(place.x(), place.y(), 0.0);
    picture.bodies.push_back({{at, Quaternion::Identity()}, {"body", m_per_deg(), {}, nullptr}});
  }
  return picture;
}

/// An eye before a 60 Hz display in virtual time.
struct Watching {
  explicit Watching(const EyeParameters& parameters, std::uint64_t seed = 1,
                    const std::string& name = "S01")
      : eye(parameters, seed, name, clock), display(clock, 60.0, assumed_screen()) {}

  /// Shows `places` for so long; samples are taken after each frame.
  void watch(double seconds, const Places& places) {
    const auto frames = static_cast<int>(60.0 * seconds);
    for (int frame = 0; frame < frames; ++frame) {
      const Picture picture = picture_of(places(frame / 60.0));
      eye.shown(picture, display.show(picture));
      take();
    }
  }
  void take() {
    const auto taken = eye.take_samples();
    samples.insert(samples.end(), taken.begin(), taken.end());
  }
  void wait(double seconds) {
    clock.advance_by(std::llround(seconds * 1e9));
    take();
  }

  VirtualClock clock;
  SimulatedEye eye;
  HeadlessDisplay display;
  std::vector<GazeSample> samples;
};

Point degrees_of(const GazeSample& sample) {
  return Point(sample.at->x_m, sample.at->y_m) / m_per_deg();
}

double seconds_of(const GazeSample& sample) { return static_cast<double>(sample.taken_ns) / 1e9; }

double share_of(const std::vector<GazeSample>& samples, GazeLoss loss) {
  const auto lost = std::count_if(samples.begin(), samples.end(),
                                  [&](const GazeSample& sample) { return sample.loss == loss; });
  return static_cast<double>(lost) / static_cast<double>(samples.size());
}

std::vector<Point> still(const std::vector<Point>& places) { return places; }

// ---------------------------------------------------------------- the tracker

TEST(SimulatedEye, SamplesAtItsRateWithoutGapOrDouble) {
  for (const double hz : {60.0, 250.0, 333.0, 1000.0}) {
    Watching watching(perfect(hz));
    watching.watch(10.0, [](double) { return still({{5, 0}}); });
    ASSERT_NEAR(static_cast<double>(watching.samples.size()), 10.0 * hz, 1.0);
    for (std::size_t i = 1; i < watching.samples.size(); ++i) {
      // Each stands on the grid of the rate, rounded to a nanosecond.
      EXPECT_NEAR(
          static_cast<double>(watching.samples[i].taken_ns - watching.samples[i - 1].taken_ns),
          1e9 / hz, 1.0);
    }
  }
}

TEST(SimulatedEye, GivesASampleWhenItsLatencyHasPassedAndNotBefore) {
  EyeParameters parameters = perfect(250.0);
  parameters.latency_ms = 40.0;
  Watching watching(parameters);
  for (int frame = 0; frame < 120; ++frame) {
    watching.wait(1.0 / 60.0);
    if (watching.samples.empty()) {
      EXPECT_LT(watching.clock.now_ns(), 44'000'000);
      continue;
    }
    const double age_ms =
        (static_cast<double>(watching.clock.now_ns()) / 1e9 - seconds_of(watching.samples.back())) *
        1e3;
    EXPECT_GE(age_ms, 40.0);
    EXPECT_LT(age_ms, 44.0);  // a later sample, 4 ms on, was not yet to be had
  }
}

EyeParameters ordinary() {
  EyeParameters eye;
  eye.pair_share = 0.3;
  eye.pursuit_share = 0.7;
  eye.pursuit_gain = 0.95;
  eye.fixational_sd_deg = 0.1;
  eye.offset_sd_deg = 0.5;
  eye.blink_per_s = 0.25;
  eye.dropout_per_s = 0.5;
  eye.latency_ms = 8.0;
  return eye;
}

/// Three bodies that go to and fro.
std::vector<Point> restless(double time_s) {
  return {{8.0 * std::sin(time_s), 0.0},
          {0.0, 8.0 * std::cos(1.3 * time_s)},
          {5.0 * std::cos(time_s), -5.0 * std::sin(0.7 * time_s)}};
}

bool same(const std::vector<GazeSample>& a, const std::vector<GazeSample>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const GazeSample& p, const GazeSample& q) {
                      return p.taken_ns == q.taken_ns && p.loss == q.loss && p.at == q.at;
                    });
}

TEST(SimulatedEye, LooksTheSameForTheSameSeedAndNameOnly) {
  const auto stream = [](std::uint64_t seed, const std::string& name) {
    Watching watching(ordinary(), seed, name);
    watching.watch(3.0, restless);
    return watching.samples;
  };
  EXPECT_TRUE(same(stream(1, "S01"), stream(1, "S01")));
  EXPECT_FALSE(same(stream(1, "S01"), stream(2, "S01")));
  EXPECT_FALSE(same(stream(1, "S01"), stream(1, "S02")));
}

// Property: frames as ever, samples taken at instants drawn to the millisecond.
TEST(SimulatedEye, GivesTheSameSamplesHoweverOftenTheyAreTaken) {
  const auto sliced = [](double chance_per_ms) {
    RandomStream when(20250712, "slices");
    Watching watching(ordinary());
    int frame = 0;
    for (int ms = 0; ms < 5000; ++ms) {
      watching.clock.advance_to(std::int64_t{1'000'000} * ms);
      if (ms >= frame * 1000.0 / 60.0) {
        watching.eye.shown(picture_of(restless(ms / 1e3)), {0, 0, watching.clock.now_ns(), 0});
        ++frame;
      }
      if (when.uniform() < chance_per_ms) {
        watching.take();
      }
    }
    watching.take();
    return watching.samples;
  };
  const auto whole = sliced(0.0);
  EXPECT_EQ(whole.size(), 1247U);  // 250 a second until 8 ms before 4.999 s
  EXPECT_TRUE(same(sliced(0.06), whole));
  EXPECT_TRUE(same(sliced(1.0), whole));
}

// share = mean length / (mean length + 1 / rate), over 2000 s: about 480 blinks and 950 drop-outs.
TEST(SimulatedEye, LosesTheShareOfSamplesThatItIsToldTo) {
  EyeParameters parameters = perfect(60.0);
  parameters.blink_per_s = 0.25;
  parameters.blink_ms = 150.0;
  parameters.dropout_per_s = 0.5;
  parameters.dropout_ms = 100.0;
  Watching watching(parameters);
  watching.wait(2000.0);
  // Four standard errors, a share's being share / √events; a blink hides the drop-outs within it.
  const double blinks = 0.15 / (0.15 + 4.0);
  EXPECT_NEAR(share_of(watching.samples, GazeLoss::kBlink), blinks, 4.0 * blinks / std::sqrt(480));
  const double dropouts = (1.0 - blinks) * 0.1 / (0.1 + 2.0);
  EXPECT_NEAR(share_of(watching.samples, GazeLoss::kLost), dropouts,
              4.0 * dropouts / std::sqrt(950));
  for (const GazeSample& sample : watching.samples) {
    EXPECT_EQ(sample.at.has_value(), sample.loss == GazeLoss::kNone);
  }
}

TEST(SimulatedEye, OffTheScreenItIsLostForThatReason) {
  Watching watching(perfect());
  watching.watch(2.0, [](double) { return still({{25, 0}}); });  // the screen ends at 18.9°
  const std::vector<GazeSample> later(watching.samples.begin() + 1000, watching.samples.end());
  EXPECT_EQ(share_of(later, GazeLoss::kOffScreen), 1.0);
  EXPECT_FALSE(later.front().at);
}

TEST(SimulatedEye, IsOffByTheSameOffsetThroughout) {
  EyeParameters parameters = perfect();
  parameters.offset_sd_deg = 0.5;
  double sum2 = 0.0;
  constexpr int kPeople = 400;
  for (int i = 0; i < kPeople; ++i) {
    Watching watching(parameters, 1, "S" + std::to_string(i));
    watching.wait(0.5);
    EXPECT_EQ(watching.samples.front().at, watching.samples.back().at);
    sum2 += degrees_of(watching.samples.front()).squaredNorm();
  }
  // Two axes of .5²; four standard errors of a mean of 400 exponentials.
  EXPECT_NEAR(sum2 / kPeople, 0.5, 4.0 * 0.5 / std::sqrt(kPeople));
}

TEST(SimulatedEye, TremblesByTheStatedAmountAtAnyRate) {
  for (const double hz : {60.0, 1000.0}) {
    EyeParameters parameters = perfect(hz);
    parameters.fixational_sd_deg = 0.1;
    parameters.fixational_time_ms = 50.0;
    Watching watching(parameters);
    watching.wait(200.0);
    double sum2 = 0.0;
    for (const GazeSample& sample : watching.samples) {
      sum2 += degrees_of(sample).squaredNorm();
    }
    // 200 s / (2 · 50 ms) = 2000 independent places of two axes: 10 % is four standard errors.
    EXPECT_NEAR(sum2 / static_cast<double>(watching.samples.size()), 0.02, 0.002);
  }
}

// ---------------------------------------------------------------- the eye

TEST(SimulatedEye, LooksAtTheCentreWhenNothingWasShown) {
  Watching watching(perfect());
  watching.wait(1.0);
  for (const GazeSample& sample : watching.samples) {
    EXPECT_EQ(sample.at, ScreenPoint{});
  }
}

TEST(SimulatedEye, LooksBackAtTheCentreWhenTheBodiesHaveGone) {
  Watching watching(perfect());
  watching.watch(1.0, [](double) { return still({{8, 0}}); });
  EXPECT_NEAR(degrees_of(watching.samples.back()).x(), 8.0, 1e-9);
  watching.wait(1.0);
  EXPECT_NEAR(degrees_of(watching.samples.back()).x(), 0.0, 1e-9);
}

/// A stretch of samples in which the gaze moves, or does not.
struct Stretch {
  bool moves;
  double from_s;
  double to_s;
  Point from{Point::Zero()};
  Point to{Point::Zero()};
};

std::vector<Stretch> stretches(const std::vector<GazeSample>& samples) {
  std::vector<Stretch> found;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Point before = degrees_of(samples[i - 1]);
    const Point after = degrees_of(samples[i]);
    const bool moves = (after - before).norm() > 1e-9;
    if (found.empty() || found.back().moves != moves) {
      found.push_back({moves, seconds_of(samples[i - 1]), 0.0, before, before});
    }
    found.back().to_s = seconds_of(samples[i]);
    found.back().to = after;
  }
  return found;
}

// duration = 21 ms + 2.2 ms per degree; two samples of 1 ms for its ends.
TEST(SimulatedEye, SaccadesKeepToTheMainSequence) {
  Watching watching(perfect());
  watching.watch(60.0, [](double) { return still({{-7, 0}, {3, 0}, {4, 3}, {0, -9}}); });
  int saccades = 0;
  for (const Stretch& stretch : stretches(watching.samples)) {
    if (stretch.moves) {
      const double amplitude_deg = (stretch.to - stretch.from).norm();
      EXPECT_NEAR(1e3 * (stretch.to_s - stretch.from_s), 21.0 + 2.2 * amplitude_deg, 2.0);
      ++saccades;
    }
  }
  // 60 s of looks of 200 to 300 ms, of which a quarter stay on the same body.
  EXPECT_NEAR(saccades, 60.0 / 0.29 * 0.75, 25.0);
}

// The path of least jerk is fastest half way, at 1.875 of its mean speed.
TEST(SimulatedEye, SaccadesStartAndEndSmoothly) {
  Watching watching(perfect());
  watching.watch(3.0, [](double) { return still({{10, 0}}); });
  double fastest_deg_s = 0.0;
  for (std::size_t i = 1; i < watching.samples.size(); ++i) {
    const double step =
        (degrees_of(watching.samples[i]) - degrees_of(watching.samples[i - 1])).norm();
    fastest_deg_s = std::max(fastest_deg_s, step * 1e3);
  }
  // 10° in 43 ms; 1 % for samples of 1 ms that do not meet the peak.
  EXPECT_NEAR(fastest_deg_s, 1.875 * 10.0 / 0.043, 0.01 * 436.0);
}

TEST(SimulatedEye, FixationsLastWithinTheirLimits) {
  Watching watching(perfect());
  watching.watch(60.0, [](double) { return still({{-7, 0}, {7, 0}}); });
  auto all = stretches(watching.samples);
  all.erase(all.begin());  // the centre, from before the first picture
  all.pop_back();          // the last is cut off
  for (const Stretch& stretch : all) {
    if (!stretch.moves) {
      // Looks at the same body follow each other without a saccade: n of them last n times as long.
      const double ms = 1e3 * (stretch.to_s - stretch.from_s);
      const double looks = std::ceil((ms - 2.0) / 300.0);
      EXPECT_GE(ms, 200.0 * looks - 2.0);
    }
  }
}

EyeParameters pursuing() {
  EyeParameters eye = perfect();
  eye.pursuit_share = 1.0;
  eye.pursuit_gain = 0.9;
  return eye;
}

TEST(SimulatedEye, FollowsWhatMovesSteadilyWithTheLagOfItsGain) {
  Watching watching(pursuing());
  const auto x_deg = [](double time_s) { return -12.0 + 8.0 * time_s; };
  watching.watch(3.0, [&](double time_s) { return still({{x_deg(time_s), 0}}); });
  for (const GazeSample& sample : watching.samples) {
    const double time_s = seconds_of(sample) - 1.0 / 60.0;  // the first flip
    if (time_s > 1.2) {                                     // when the approach to it has died down
      // (1 − gain) · speed · pursuit time = .1 · 8°/s · .1 s = .08°; 1 % of it for what is left.
      EXPECT_NEAR(x_deg(time_s) - degrees_of(sample).x(), 0.08, 0.001) << time_s;
    }
  }
}

TEST(SimulatedEye, StaysNearWhatMovesEvenWhenItTurnsBack) {
  Watching watching(pursuing());
  // To and fro between ±8° at 10°/s.
  const auto x_deg = [](double time_s) {
    const double way = std::fmod(10.0 * time_s, 32.0);
    return way < 16.0 ? way - 8.0 : 24.0 - way;
  };
  watching.watch(20.0, [&](double time_s) { return still({{x_deg(time_s), 0}}); });
  int near = 0;
  int all = 0;
  for (const GazeSample& sample : watching.samples) {
    const double time_s = seconds_of(sample) - 1.0 / 60.0;
    if (time_s > 1.0) {
      const double distance_deg = std::abs(x_deg(time_s) - degrees_of(sample).x());
      // It goes on for a visual delay, a frame and the window in which velocity is seen, apart at
      // twice the speed: 20°/s · (100 + 17 + 55) ms.
      EXPECT_LT(distance_deg, 3.5) << time_s;
      near += distance_deg < 1.0 ? 1 : 0;
      ++all;
    }
  }
  // Every 1.6 s it is led astray for a fifth of a second or so.
  EXPECT_GT(static_cast<double>(near) / all, 0.8);
}

TEST(SimulatedEye, LooksBetweenThePairThatWillCollide) {
  EyeParameters parameters = perfect();
  parameters.pair_share = 1.0;
  Watching watching(parameters);
  // The nearer two move apart, the others meet at (0, 6).
  watching.watch(1.5, [](double time_s) {
    return still(
        {{-1.5 - time_s, -6}, {1.5 + time_s, -6}, {-6 + 3 * time_s, 6}, {6 - 3 * time_s, 6}});
  });
  EXPECT_LT((degrees_of(watching.samples.back()) - Point(0, 6)).norm(), 0.2);
}

}  // namespace impetus::simulated_eye_test
