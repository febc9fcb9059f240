// The photodiode patch: a code for every frame that tells onset, order and which frame it is.
// SPDX-License-Identifier: MIT
#include <set>

#include "experiments/record/photodiode_patch.hpp"
#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/test_study.hpp"

#ifdef IMPETUS_PROGRAM_HAS_WINDOW
#include "experiments/window/shown_patch.hpp"
#endif

namespace impetus::photodiode_patch_test {

/// A headless display with a patch.
class PatchedDisplay final : public Display {
 public:
  explicit PatchedDisplay(VirtualClock& clock) : display_(clock, 60.0, assumed_screen()) {}
  [[nodiscard]] double refresh_hz() const override { return display_.refresh_hz(); }
  [[nodiscard]] const ScreenGeometry& geometry() const override { return display_.geometry(); }
  void restart_grid() override { display_.restart_grid(); }
  [[nodiscard]] bool has_patch() const override { return true; }
  Flip show(const Picture& picture) override {
    codes.push_back(picture.patch_code);
    return display_.show(picture);
  }

  std::vector<std::int64_t> codes;

 private:
  HeadlessDisplay display_;
};

/// The attempts of a short session before a patch, and the codes that the display was told.
struct PatchedSession {
  PatchedSession() {
    TestLab lab;
    PatchedDisplay display(lab.clock);
    const Ports ports{display,  lab.input,  lab.scenes, lab.recorder,
                      lab.gaze, &lab.clock, &lab.clock};
    run_session(lab.protocol.script, short_plan(lab.protocol, 1), {}, ports);
    attempts = lab.recorder.attempts;
    codes = display.codes;
  }
  std::vector<AttemptRecord> attempts;
  std::vector<std::int64_t> codes;
};

TEST(PhotodiodePatch, TheOnsetIsTheFirstWhiteAndTheClockChangesWithEveryFrame) {
  EXPECT_EQ(patch_code(0), 3);
  for (std::int64_t frame = 0; frame < 2 * kPatchPeriod; ++frame) {
    ASSERT_EQ(patch_code(frame) / 2, 1 - frame % 2) << frame;
    ASSERT_NE(patch_code(frame), patch_code(frame + 1)) << frame;
  }
}

TEST(PhotodiodePatch, TwelveFramesInARowTellWhichFrameTheFirstIs) {
  std::set<std::int64_t> words;
  for (std::int64_t frame = 0; frame < kPatchPeriod; ++frame) {
    std::int64_t word = 0;
    for (int bit = 0; bit < kPatchWord; ++bit) {
      word = 2 * word + patch_code(frame + bit) % 2;
    }
    words.insert(word);
  }
  EXPECT_EQ(words.size(), static_cast<std::size_t>(kPatchPeriod));
  EXPECT_EQ(words.count(0), 0U);  // so a dead patch is no word either
}

TEST(PhotodiodePatch, ItsFourLightsLieOnBothSidesOfHalfOfWhite) {
  const auto light = [](std::int64_t code) {  // IEC 61966-2-1
    const double grey = patch_grey(code);
    return grey <= 0.04045 ? grey / 12.92 : std::pow((grey + 0.055) / 1.055, 2.4);
  };
  constexpr double kOfAGreyOf255 = 0.005;  // of the light, at 70 % of white's
  EXPECT_EQ(light(0), 0.0);
  EXPECT_NEAR(light(1), 0.3, kOfAGreyOf255);
  EXPECT_NEAR(light(2), 0.7, kOfAGreyOf255);
  EXPECT_EQ(light(3), 1.0);
}

TEST(PhotodiodePatch, ACornerIsKnownByItsNameAlone) {
  for (const char* name : {"top left", "top right", "bottom left", "bottom right"}) {
    ASSERT_TRUE(corner_named(name)) << name;
    EXPECT_STREQ(name_of(*corner_named(name)), name);
  }
  EXPECT_EQ(corner_named("bottom-left"), ScreenCorner::kBottomLeft);
  EXPECT_FALSE(corner_named("left"));
  EXPECT_FALSE(corner_named(""));
}

TEST(PhotodiodePatch, EveryFrameOfAStimulusHasItsCodeAndAllElseIsDark) {
  const PatchedSession session;
  std::size_t stimulus_frames = 0;
  for (const AttemptRecord& attempt : session.attempts) {
    std::int64_t number = 0;
    for (const FrameRecord& frame : attempt.frames) {
      const bool stimulus = frame.phase == FramePhase::kStimulus;
      ASSERT_TRUE(frame.patch);
      EXPECT_EQ(*frame.patch, stimulus ? patch_code(number) : kDarkPatch);
      number += stimulus ? 1 : 0;
    }
    stimulus_frames += static_cast<std::size_t>(number);
  }
  ASSERT_GT(stimulus_frames, 0U);
  // A frame of a stimulus is dark with its clock down and no data: the display was told the same.
  std::vector<std::int64_t> lit_as_recorded;
  for (const AttemptRecord& attempt : session.attempts) {
    for (const FrameRecord& frame : attempt.frames) {
      if (*frame.patch != kDarkPatch) {
        lit_as_recorded.push_back(*frame.patch);
      }
    }
  }
  std::vector<std::int64_t> lit_as_shown;
  std::copy_if(session.codes.begin(), session.codes.end(), std::back_inserter(lit_as_shown),
               [](std::int64_t code) { return code != kDarkPatch; });
  EXPECT_EQ(lit_as_shown, lit_as_recorded);
}

TEST(PhotodiodePatch, TheStudyKeepsCornerAndCodesAndNullsWithoutAPatch) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  const AttemptRecord patched = PatchedSession().attempts[0];
  {
    EnrolledStudy at(path);
    SessionFacts with_patch = facts();
    with_patch.photodiode_patch = "bottom left";
    with_patch.series = "a series";
    StudyWriter writer(at.study, at.enrolment, with_patch);
    writer.save(patched);
    writer.end("quit");
  }
  {
    EnrolledStudy at((folder / "b.sqlite").string());
    StudyWriter writer(at.study, at.enrolment, facts());
    writer.save(recorded_attempts()[0]);
    writer.end("quit");
  }
  EXPECT_EQ(value_of(path, "SELECT photodiode_patch || ', ' || series FROM session"),
            "bottom left, a series");
  EXPECT_EQ(value_of(path, "SELECT count(patch) || ' of ' || count(*) FROM frame"),
            std::to_string(patched.frames.size()) + " of " + std::to_string(patched.frames.size()));
  EXPECT_EQ(value_of(path,
                     "SELECT code || ' at ' || min(frame) || ' ' || corner FROM patch_frame "
                     "WHERE phase = 'stimulus'"),
            "3 at 30 bottom left");  // after half a second of fixation
  const std::string without = (folder / "b.sqlite").string();
  EXPECT_EQ(value_of(without, "SELECT count(photodiode_patch) FROM session"), "0");
  EXPECT_EQ(value_of(without, "SELECT count(patch) || ' of ' || (count(*) > 0) FROM frame"),
            "0 of 1");
  EXPECT_EQ(value_of(without, "SELECT count(*) FROM patch_frame"), "0");
}

TEST(PhotodiodePatch, WhatCannotHaveOneIsRefusedBeforeAnythingIsMade) {
  const TemporaryFolder folder;
  const Words person{"run", causality_file(), "--db", "a.sqlite", "--participant", "P01"};
  Words wrong_corner = person;
  wrong_corner.insert(wrong_corner.end(), {"--photodiode", "middle"});
  expect_refused_without_a_file(
      folder, wrong_corner,
      "--photodiode: expected top left, top right, bottom left or bottom right, got middle");
  expect_refused_without_a_file(
      folder, simulated_run({"--participant", "S01", "--photodiode", "top left"}),
      "--photodiode: expected a window to draw in; with --observer, give --show too");
}

#ifdef IMPETUS_PROGRAM_HAS_WINDOW
TEST(PhotodiodePatch, ItIsASquareOnTheGlassInItsCorner) {
  const ScreenGeometry screen{0.375, 0.3, 0, 0, 0.57};  // 1.5 cm: a 25th, a 20th
  const auto area = [&](ScreenCorner corner) { return patch_area(corner, screen, 1000, 800); };
  EXPECT_EQ(area(ScreenCorner::kBottomLeft).left, 0);
  EXPECT_EQ(area(ScreenCorner::kBottomLeft).bottom, 0);
  EXPECT_EQ(area(ScreenCorner::kBottomLeft).width, 40);
  EXPECT_EQ(area(ScreenCorner::kBottomLeft).height, 40);
  EXPECT_EQ(area(ScreenCorner::kTopRight).left, 960);
  EXPECT_EQ(area(ScreenCorner::kTopRight).bottom, 760);
}

TEST(PhotodiodePatch, APixelTellsItsCodeOrThatItIsNone) {
  for (std::int64_t code = 0; code < kPatchCodes; ++code) {
    const int grey = static_cast<int>(std::lround(255.0F * patch_grey(code)));
    EXPECT_EQ(code_of_pixel(grey, grey, grey), code);
    EXPECT_EQ(code_of_pixel(std::max(0, grey - 4), std::min(255, grey + 4), grey), code);
  }
  EXPECT_FALSE(code_of_pixel(100, 100, 100));
  EXPECT_FALSE(code_of_pixel(255, 0, 0));
}
#endif

}  // namespace impetus::photodiode_patch_test
