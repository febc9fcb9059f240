// What a calibration does to samples, and how well a gaze is known.
// SPDX-License-Identifier: MIT
#include "experiments/record/gaze_correction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/numerics/random_stream.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/session/gaze_calibration.hpp"

namespace impetus::gaze_correction_test {

double between(RandomStream& random, double least, double most) {
  return least + (most - least) * random.uniform();
}

/// What a tracker with this map's faults reports of nine points, each off by up to `noise_m`.
std::vector<FixatedPoint> reported(const GazeCorrection& faults, double noise_m,
                                   RandomStream& random) {
  std::vector<FixatedPoint> points;
  for (const ScreenPoint& shown : nine_points(assumed_screen(), 0.8)) {
    ScreenPoint gaze = faults.corrected(shown);
    gaze.x_m += between(random, -noise_m, noise_m);
    gaze.y_m += between(random, -noise_m, noise_m);
    points.push_back({shown, gaze});
  }
  return points;
}

GazeCorrection drawn_faults(RandomStream& random) {
  return {between(random, -0.03, 0.03), between(random, 0.8, 1.2),  between(random, -0.1, 0.1),
          between(random, -0.03, 0.03), between(random, -0.1, 0.1), between(random, 0.8, 1.2)};
}

double squared_error(const GazeCorrection& map, const std::vector<FixatedPoint>& points) {
  double sum = 0.0;
  for (const FixatedPoint& point : points) {
    const ScreenPoint at = map.corrected(point.gaze);
    sum += std::pow(at.x_m - point.shown.x_m, 2) + std::pow(at.y_m - point.shown.y_m, 2);
  }
  return sum;
}

constexpr std::uint64_t kSeed = 20;

TEST(GazeCorrection, AnyOffsetGainAndTurnIsTakenAway) {
  RandomStream random(kSeed, "faults");
  for (int round = 0; round < 200; ++round) {
    const GazeCorrection faults = drawn_faults(random);
    const auto fit = fit_gaze_correction(reported(faults, 0.0, random));
    ASSERT_TRUE(fit) << "seed " << kSeed << ", round " << round;
    const ScreenPoint looked_at{between(random, -0.2, 0.2), between(random, -0.2, 0.2)};
    const ScreenPoint found = fit->corrected(faults.corrected(looked_at));
    EXPECT_NEAR(found.x_m, looked_at.x_m, 1e-12);
    EXPECT_NEAR(found.y_m, looked_at.y_m, 1e-12);
  }
}

TEST(GazeCorrection, NoOtherMapBringsTheGazeNearerToThePoints) {
  RandomStream random(kSeed, "noise");
  for (int round = 0; round < 50; ++round) {
    const auto points = reported(drawn_faults(random), 0.01, random);
    const auto fit = fit_gaze_correction(points);
    ASSERT_TRUE(fit);
    const double least = squared_error(*fit, points);
    for (double GazeCorrection::*part :
         {&GazeCorrection::x0_m, &GazeCorrection::xx, &GazeCorrection::xy, &GazeCorrection::y0_m,
          &GazeCorrection::yx, &GazeCorrection::yy}) {
      for (const double change : {-1e-4, 1e-4}) {
        GazeCorrection other = *fit;
        other.*part += change;
        EXPECT_GT(squared_error(other, points), least) << "seed " << kSeed << ", round " << round;
      }
    }
  }
}

TEST(GazeCorrection, FewPointsOrAGazeThatStaysOnALineAreNoCalibration) {
  RandomStream random(kSeed, "few");
  auto points = reported({}, 0.0, random);
  points.resize(kLeastFixatedPoints);  // three in a row and one beside them
  EXPECT_TRUE(fit_gaze_correction(points));
  points.pop_back();
  EXPECT_FALSE(fit_gaze_correction(points));
  auto still = reported({}, 0.0, random);
  auto line = still;
  for (std::size_t i = 0; i < still.size(); ++i) {
    still[i].gaze = {0.01, -0.02};
    line[i].gaze = {line[i].gaze.x_m, 0.5 * line[i].gaze.x_m};
  }
  EXPECT_FALSE(fit_gaze_correction(still));
  EXPECT_FALSE(fit_gaze_correction(line));
}

TEST(GazeCorrection, ALostSampleStaysLost) {
  EXPECT_EQ(GazeCorrection{}.corrected(Fixation{}), std::nullopt);
  EXPECT_EQ(GazeCorrection{}.corrected(Fixation({0.1, 0.2})), Fixation({0.1, 0.2}));
}

// ---------------------------------------------------------------- how well it is known

/// A sample at so many degrees right of and above the centre.
GazeSample sample(double x_deg, double y_deg) {
  const double m_per_deg = metres_per_degree(assumed_screen().viewing_distance_m);
  return {0, ScreenPoint{x_deg * m_per_deg, y_deg * m_per_deg}, GazeLoss::kNone};
}
const GazeSample kNoSample{0, std::nullopt, GazeLoss::kBlink};

CalibrationPointRecord measured_about_centre(const std::vector<GazeSample>& samples) {
  return measured(viewer_at(assumed_screen(), 0.0), {ScreenPoint{}, samples});
}

/// Degrees are counted on the screen's linear scale here, which near the centre are degrees.
constexpr double kSmallAngle_deg = 1e-3;

TEST(GazeQuality, AccuracyIsTheMeanDistanceAndPrecisionIsAboutTheSamplesThemselves) {
  // From the point 1, 1, 2; from sample to sample √2 and √(1 + 4); mean (1, 2/3)... by hand:
  const auto row = measured_about_centre({sample(1.0, 0.0), sample(0.0, 1.0), sample(2.0, 0.0)});
  EXPECT_NEAR(*row.accuracy_deg, (1.0 + 1.0 + 2.0) / 3.0, kSmallAngle_deg);
  EXPECT_NEAR(*row.precision_rms_deg, std::sqrt((2.0 + 5.0) / 2.0), 2 * kSmallAngle_deg);
  // Mean (1, 1/3); squared distances 1/9, 1 + 4/9, 1 + 1/9.
  EXPECT_NEAR(*row.precision_sd_deg, std::sqrt((1.0 / 9 + 13.0 / 9 + 10.0 / 9) / 3.0),
              kSmallAngle_deg);
  EXPECT_EQ(row.samples, 3);
  EXPECT_EQ(row.lost, 0);
}

TEST(GazeQuality, NoStepIsCountedOverALoss) {
  const auto row = measured_about_centre({sample(1.0, 0.0), kNoSample, sample(-1.0, 0.0)});
  EXPECT_EQ(row.precision_rms_deg, std::nullopt);
  EXPECT_NEAR(*row.precision_sd_deg, 1.0, kSmallAngle_deg);
  EXPECT_EQ(row.lost, 1);
}

TEST(GazeQuality, APointThatWasNeverSeenFailsTheWhole) {
  const Viewer viewer = viewer_at(assumed_screen(), 0.0);
  const PointSamples good{{}, {sample(0.1, 0.0), sample(0.3, 0.0)}};
  const PointSamples poor{{}, {sample(0.0, 0.6), sample(0.0, 0.8)}};
  const CalibrationRecord seen = measured(viewer, {good, poor}, 0.5);
  EXPECT_NEAR(*seen.accuracy_deg, (0.2 + 0.7) / 2.0, kSmallAngle_deg);
  EXPECT_NEAR(*seen.worst_accuracy_deg, 0.7, kSmallAngle_deg);
  EXPECT_TRUE(seen.passed);
  EXPECT_FALSE(measured(viewer, {good, poor}, 0.4).passed);
  const CalibrationRecord unseen = measured(viewer, {good, {{}, {kNoSample}}}, 0.5);
  EXPECT_FALSE(unseen.passed);
  EXPECT_DOUBLE_EQ(unseen.lost_share, 1.0 / 3.0);
  const CalibrationRecord nothing = measured(viewer, {{{}, {}}}, 0.5);
  EXPECT_EQ(nothing.accuracy_deg, std::nullopt);
  EXPECT_EQ(nothing.lost_share, 1.0);
}

TEST(GazeQuality, TheSamplingRateIsMeasured) {
  EXPECT_EQ(sampling_hz_of({{5, {}, GazeLoss::kLost}}), std::nullopt);
  std::vector<GazeSample> samples;
  for (std::int64_t i = 0; i <= 50; ++i) {
    samples.push_back({i * 4'000'000, {}, GazeLoss::kLost});
  }
  EXPECT_DOUBLE_EQ(*sampling_hz_of(samples), 250.0);
}

}  // namespace impetus::gaze_correction_test
