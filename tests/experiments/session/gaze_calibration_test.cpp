// Calibration, validation and drift checks within sessions.
// SPDX-License-Identifier: MIT
#include "experiments/session/gaze_calibration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/observers/simulated_eye.hpp"
#include "tests/experiments/calibration_lab.hpp"

namespace impetus::gaze_calibration_test {

double m_per_deg() { return metres_per_degree(assumed_screen().viewing_distance_m); }

/// A tracker that is wrong by an offset and a gain.
Fixation faulty(const ScreenPoint& looked_at) {
  return ScreenPoint{1.1 * looked_at.x_m + 2.0 * m_per_deg(), 0.9 * looked_at.y_m - m_per_deg()};
}

TEST(GazeCalibrated, AnOffsetAndAGainAreGoneInTheValidation) {
  CalibrationLab lab;
  lab.eye.fault = faulty;
  EXPECT_EQ(lab.run().ending, SessionEnding::kFinished);
  const auto calibrations = lab.runs(CalibrationKind::kCalibration);
  const auto validations = lab.runs(CalibrationKind::kValidation);
  ASSERT_EQ(calibrations.size(), 1U);
  ASSERT_EQ(validations.size(), 1U);
  EXPECT_GT(*calibrations[0].accuracy_deg, 2.0);
  EXPECT_LT(*validations[0].accuracy_deg, 1e-6);
  EXPECT_TRUE(validations[0].passed);
  EXPECT_EQ(validations[0].points.size(), 9U);
  EXPECT_EQ(validations[0].before_slot, 1);
  EXPECT_EQ(validations[0].gaze_source, "scripted");
  EXPECT_NEAR(*validations[0].sampling_hz, 100.0, 1e-6);
  EXPECT_EQ(lab.titled("That went well"), 1);
}

TEST(GazeCalibrated, SamplesStayRawAndStepsUseWhatIsCorrected) {
  CalibrationLab lab;
  lab.eye.fault = faulty;
  lab.run();
  const GazeCorrection correction = *lab.runs(CalibrationKind::kCalibration)[0].correction;
  ASSERT_EQ(lab.recorder.attempts.size(), 4U);
  for (const AttemptRecord& attempt : lab.recorder.attempts) {
    for (const GazeSample& sample : attempt.gaze) {
      EXPECT_EQ(sample.at, faulty({}));
    }
    for (std::size_t step = 1; step < attempt.steps.size(); ++step) {
      EXPECT_EQ(attempt.steps[step].gaze.fixation, correction.corrected(faulty({})));
    }
  }
}

TEST(GazeCalibrated, PointsAreNineInAnOrderOfTheSeedAlone) {
  CalibrationLab one;
  CalibrationLab same;
  CalibrationLab other;
  other.plan = make_plan(other.protocol.design, {other.protocol.name, "P02", 1});
  const auto places = [](CalibrationLab& lab) {
    lab.run();
    std::vector<std::pair<double, double>> shown;
    const CalibrationRecord validation = lab.runs(CalibrationKind::kValidation)[0];
    for (const CalibrationPointRecord& point : validation.points) {
      shown.emplace_back(point.shown.x_m, point.shown.y_m);
    }
    return shown;
  };
  const auto order = places(one);
  EXPECT_EQ(places(same), order);
  auto others = places(other);
  EXPECT_NE(others, order);
  auto sorted = order;
  std::sort(sorted.begin(), sorted.end());
  std::sort(others.begin(), others.end());
  EXPECT_EQ(sorted, others);
  EXPECT_EQ(std::unique(sorted.begin(), sorted.end()), sorted.end());
  EXPECT_DOUBLE_EQ(sorted.front().first, -0.3 * assumed_screen().width_m);
  EXPECT_DOUBLE_EQ(sorted.back().second, 0.3 * assumed_screen().height_m);
}

TEST(GazeCalibrated, APointerIsMeasuredButNeverCorrected) {
  CalibrationLab lab;
  lab.eye.pointer = true;
  lab.eye.fault = [](const ScreenPoint& at) {
    return Fixation({at.x_m + 0.5 * m_per_deg(), at.y_m});
  };
  lab.run();
  EXPECT_EQ(*lab.runs(CalibrationKind::kCalibration)[0].correction, GazeCorrection{});
  const CalibrationRecord validation = lab.runs(CalibrationKind::kValidation)[0];
  EXPECT_NEAR(*validation.accuracy_deg, 0.5, 0.03);  // less in the corners, seen aslant
  EXPECT_TRUE(validation.passed);
}

/// A gaze that does not keep to the points, so that no correction helps.
Fixation wandering(const ScreenPoint& looked_at) {
  return ScreenPoint{0.5 * std::abs(looked_at.x_m) + 0.3 * looked_at.y_m,
                     std::abs(looked_at.y_m) * 0.7};
}

TEST(GazeCalibrated, WithoutAnySampleNotEvenAPointersCalibrationPasses) {
  CalibrationLab lab;
  lab.eye.pointer = true;
  lab.eye.fault = [](const ScreenPoint&) { return std::nullopt; };
  lab.run();
  ASSERT_GE(lab.recorder.calibrations.size(), 2U);
  for (const CalibrationRecord& record : lab.recorder.calibrations) {
    EXPECT_FALSE(record.passed);
    EXPECT_EQ(record.accuracy_deg, std::nullopt);
  }
}

TEST(GazeCalibrated, AfterThePoorTriesTheExperimenterLetsItGoOn) {
  CalibrationLab lab;
  lab.eye.fault = wandering;
  EXPECT_EQ(lab.run().ending, SessionEnding::kFinished);
  const auto validations = lab.runs(CalibrationKind::kValidation);
  ASSERT_EQ(validations.size(), 3U);
  EXPECT_EQ(validations[2].number, 3);
  EXPECT_FALSE(validations[2].passed);
  EXPECT_EQ(lab.titled("Once more, please"), 2);
  EXPECT_EQ(lab.titled("Your gaze is not known well enough"), 1);
  EXPECT_EQ(lab.noted("calibration not passed"), 1);
  EXPECT_EQ(lab.noted("poor calibration accepted"), 1);
}

/// Of all pages of a session whose gaze drifts, those for participants that have a degree on them.
std::set<std::string> titles_with_degrees(bool show_accuracy) {
  CalibrationLab lab(short_gaze_study([&](json& protocol, json&) {
    protocol["session"]["breaks"]["every"] = 1;
    if (show_accuracy) {
      protocol["gaze"]["calibration"]["show_accuracy"] = true;
    }
  }));
  lab.eye.fault = [&lab](const ScreenPoint& at) {
    const bool drifted = lab.recorder.attempts.size() > 1;
    return Fixation({at.x_m + (drifted ? 3.0 * m_per_deg() : 0.0), at.y_m});
  };
  std::set<std::string> titles;
  lab.input.on_page = [&](const Page& page) {
    for (const std::string& words : page.paragraphs) {
      if (words.find("°") != std::string::npos) {
        titles.insert(page.title);
      }
    }
    return Answer{};
  };
  lab.run();
  return titles;
}

TEST(GazeCalibrated, ParticipantsReadNumbersOnlyWhereTheProtocolAsksForThem) {
  EXPECT_EQ(titles_with_degrees(false), std::set<std::string>{});
  EXPECT_EQ(titles_with_degrees(true),
            (std::set<std::string>{"Let us look at the points again", "That went well"}));
}

TEST(GazeCalibrated, OrStopsTheSessionBeforeAnyTrial) {
  CalibrationLab lab;
  lab.eye.fault = wandering;
  lab.input.on_page = [](const Page& page) {
    Answer answer;
    answer.choice = page.title == "Your gaze is not known well enough" ? kStopChoice : 0;
    return answer;
  };
  EXPECT_EQ(lab.run().ending, SessionEnding::kQuit);
  EXPECT_TRUE(lab.recorder.attempts.empty());
  EXPECT_EQ(lab.noted("quit"), 1);
}

TEST(GazeCalibrated, ADriftAtABreakAsksForAnotherCalibration) {
  CalibrationLab lab(
      short_gaze_study([](json& protocol, json&) { protocol["session"]["breaks"]["every"] = 1; }));
  lab.eye.fault = [&lab](const ScreenPoint& at) {
    const bool drifted = lab.recorder.attempts.size() > 1;
    return Fixation({at.x_m + (drifted ? 3.0 * m_per_deg() : 0.0), at.y_m});
  };
  EXPECT_EQ(lab.run().ending, SessionEnding::kFinished);
  const auto checks = lab.runs(CalibrationKind::kDriftCheck);
  ASSERT_EQ(checks.size(), 3U);
  EXPECT_TRUE(checks[0].passed);
  EXPECT_FALSE(checks[1].passed);
  EXPECT_NEAR(*checks[1].accuracy_deg, 3.0, 0.01);
  EXPECT_EQ(checks[1].accuracy_limit_deg, 2.0);
  EXPECT_TRUE(checks[2].passed);
  const auto validations = lab.runs(CalibrationKind::kValidation);
  ASSERT_EQ(validations.size(), 2U);
  EXPECT_EQ(validations[1].before_slot, 3);
  EXPECT_LT(*validations[1].accuracy_deg, 1e-6);
  EXPECT_EQ(lab.titled("Let us look at the points again"), 1);
}

TEST(GazeCalibrated, APauseAmongThePointsIsNotedAndTheRunMadeAnew) {
  CalibrationLab lab;
  lab.input.on_frame = [](std::int64_t frame) {
    return frame == 200 ? Interruption::kPauseRequested : Interruption::kNone;
  };
  EXPECT_EQ(lab.run().ending, SessionEnding::kFinished);
  EXPECT_EQ(lab.noted("calibration interrupted"), 1);
  EXPECT_EQ(lab.noted("pause"), 1);
  const auto note =
      std::find_if(lab.recorder.notes.begin(), lab.recorder.notes.end(),
                   [](const NoteRecord& one) { return one.kind == "calibration interrupted"; });
  EXPECT_EQ(note->text, "at point 2 of 9; run anew");
  EXPECT_EQ(lab.recorder.calibrations.size(), 2U);
}

TEST(GazeCalibrated, WithoutTheKeyNothingIsCalibrated) {
  CalibrationLab lab(
      short_gaze_study([](json& protocol, json&) { protocol["gaze"].erase("calibration"); }));
  lab.run();
  EXPECT_TRUE(lab.recorder.calibrations.empty());
  EXPECT_EQ(lab.titled("Where you look"), 0);
}

/// The simulated eye's planted offset is what the raw samples are off by, and calibration takes
/// nearly all of it away: what remains is the mean of fixational noise and of late saccades.
TEST(GazeCalibrated, TheSimulatedEyeLosesMostOfItsOffset) {
  EyeParameters parameters;
  parameters.offset_sd_deg = 2.0;
  parameters.fixational_sd_deg = 0.1;
  parameters.fixational_time_ms = 50.0;
  double raw_deg = 0.0;
  constexpr int kParticipants = 8;
  for (int participant = 1; participant <= kParticipants; ++participant) {
    CalibrationLab lab;
    SimulatedEye eye(parameters, 1, "S0" + std::to_string(participant), lab.clock);
    lab.gaze = &eye;
    lab.run();
    raw_deg += *lab.runs(CalibrationKind::kCalibration)[0].accuracy_deg / kParticipants;
    const CalibrationRecord validation = lab.runs(CalibrationKind::kValidation)[0];
    EXPECT_TRUE(validation.passed);
    // The mean distance of noise of 0.1° per axis is 0.1 √(π/2) = 0.125°.
    EXPECT_LT(*validation.accuracy_deg, 0.2) << participant;
    EXPECT_NEAR(*validation.precision_sd_deg, 0.1 * std::sqrt(2.0), 0.03);
    EXPECT_NEAR(*validation.sampling_hz, 250.0, 0.5);
  }
  // The mean length of a normal offset of 2° per axis is 2 √(π/2) = 2.5°; its SD over participants
  // 1.3°, of a mean of eight .46°.
  EXPECT_NEAR(raw_deg, 2.5, 3 * 0.46);
}

}  // namespace impetus::gaze_calibration_test
