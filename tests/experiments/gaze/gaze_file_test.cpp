// Files of recorded gaze: common trackers' columns, what is refused, and who looks so.
// SPDX-License-Identifier: MIT
#include "experiments/files/gaze_file.hpp"

#include <gtest/gtest.h>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/observers/headless_lab.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::gaze_file_test {

constexpr ScreenGeometry kScreen{0.4, 0.2, 800, 400, 0.6};

GazeRecording loaded(const std::string& text) {
  const TemporaryFolder folder;
  return load_gaze_recording(folder.write("gaze.csv", text));
}

/// The sentence without the folder.
std::string refused(const std::string& text) {
  const TemporaryFolder folder;
  const std::string path = folder.write("gaze.csv", text).string();
  const std::string sentence = refusal([&] { load_gaze_recording(path); });
  return sentence.starts_with(path) ? "gaze.csv" + sentence.substr(path.size()) : sentence;
}

TEST(GazeFile, OfImpetusCountsFromOnsetAndSaysWhatIsLost) {
  const GazeRecording read = loaded(
      "participant,trial,time_s,x_m,y_m,loss\n"
      "\"P, 1\",7,0.01,0.1,-0.05,\n\"P, 1\",7,0.02,,,blink\n\"P, 1\",9,0.5,0,0,\n");
  ASSERT_EQ(read.trials.size(), 2U);
  EXPECT_EQ(read.unit, GazeRecording::Unit::kMetres);
  ASSERT_EQ(read.trials[0].size(), 2U);
  EXPECT_EQ(read.trials[0][0].time_s, 0.01);
  EXPECT_EQ(read.trials[0][0].y, -0.05);
  EXPECT_TRUE(read.trials[0][0].valid);
  EXPECT_FALSE(read.trials[0][1].valid);
  EXPECT_EQ(read.trials[1][0].time_s, 0.5);
}

TEST(GazeFile, OfImpetusLeavesPracticeOutAndIsOfOneParticipant) {
  const std::string names =
      "participant,trial_id,trial_phase,attempt_outcome,x_m,y_m,loss,stimulus_time_s\n";
  const GazeRecording read = loaded(names +
                                    "P1,1,practice,completed,0,0,,0\nP1,2,main,interrupted,0.2,0,,"
                                    "0\nP1,2,main,completed,0.1,0,,0\n");
  ASSERT_EQ(read.trials.size(), 1U);
  EXPECT_EQ(read.trials[0][0].x, 0.1);
  EXPECT_EQ(refused(names + "P1,1,main,completed,0,0,,0\nP2,2,main,completed,0,0,,0\n"),
            "gaze.csv:3: expected the gaze of one participant, got P1 and P2");
}

TEST(GazeFile, OfEyeLinkHasMillisecondsOfItsClockAndPixels) {
  const GazeRecording read = loaded(
      "TRIAL_INDEX\tTIMESTAMP\tRIGHT_GAZE_X\tRIGHT_GAZE_Y\n"
      "1\t5000\t640\t512\n1\t5004\t.\t.\n2\t9000\t0\t0\n");
  EXPECT_EQ(read.unit, GazeRecording::Unit::kPixels);
  ASSERT_EQ(read.trials.size(), 2U);
  EXPECT_EQ(read.trials[0][0].time_s, 0.0);
  EXPECT_NEAR(read.trials[0][1].time_s, 0.004, 1e-12);
  EXPECT_FALSE(read.trials[0][1].valid);
  EXPECT_EQ(read.trials[1][0].time_s, 0.0);
}

TEST(GazeFile, OfPupilCountsUpwardsAndGoesByConfidence) {
  const GazeRecording read = loaded(
      "gaze_timestamp,world_index,confidence,norm_pos_x,norm_pos_y\n"
      "100.5,0,0.9,0.5,0.75\n100.51,0,0.2,0.5,0.75\n");
  const Fixation at = read.place(read.trials[0][0], kScreen);
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->x_m, 0.0, 1e-12);
  EXPECT_NEAR(at->y_m, 0.05, 1e-12);
  EXPECT_EQ(read.place(read.trials[0][1], kScreen), std::nullopt);
}

TEST(GazeFile, OfTobiiSaysItsUnitOfTime) {
  const std::string after =
      ";Gaze point X;Gaze point Y;Validity left\n0;10;20;Valid\n16667;11;21;Invalid\n";
  const GazeRecording read = loaded("\xEF\xBB\xBFRecording timestamp [μs]" + after);
  EXPECT_NEAR(read.trials[0][1].time_s, 0.016667, 1e-9);
  EXPECT_FALSE(read.trials[0][1].valid);
  EXPECT_NE(refused("Recording timestamp" + after).find("gaze.csv:1: expected a column of times"),
            std::string::npos);
}

TEST(GazeFile, PlacesAreOnTheSessionsScreen) {
  const GazeRecording px = loaded("time_ms,x_px,y_px\n0,0,0\n1,800,400\n2,801,0\n");
  EXPECT_EQ(px.place(px.trials[0][0], kScreen), (ScreenPoint{-0.2, 0.1}));
  EXPECT_EQ(px.place(px.trials[0][1], kScreen), (ScreenPoint{0.2, -0.1}));
  EXPECT_EQ(px.place(px.trials[0][2], kScreen), std::nullopt) << "beyond the edge";
  const GazeRecording deg = loaded("time_s,x_deg,y_deg,valid\n0,1,-2,1\n1,1,1,0\n");
  EXPECT_NEAR(deg.place(deg.trials[0][0], kScreen)->y_m, -2 * metres_per_degree(0.6), 1e-12);
  EXPECT_EQ(deg.place(deg.trials[0][1], kScreen), std::nullopt);
}

TEST(GazeFile, ThatSaysTooLittleOrTwoThingsIsRefused) {
  EXPECT_EQ(refused(""),
            "gaze.csv: expected a line of names and lines of samples, got an empty file");
  EXPECT_EQ(refused("time_s,x_deg,y_deg\n"),
            "gaze.csv: expected lines of samples after the names, got none");
  EXPECT_EQ(refused("time_s,time_ms,x_deg,y_deg\n0,0,0,0\n"),
            "gaze.csv:1: expected one column of times, got time_s and time_ms");
  EXPECT_EQ(refused("time_s,x_deg,x_px,y_px,y_deg\n0,0,0,0,0\n"),
            "gaze.csv:1: expected places in one unit, got x_deg and x_px");
  EXPECT_EQ(refused("time_s,x_deg\n0,0\n"), "gaze.csv:1: expected a column y_deg beside x_deg");
  EXPECT_NE(refused("time_s,gaze\n0,0\n").find("gaze.csv:1: expected columns of places (x_m, "),
            std::string::npos);
  EXPECT_EQ(refused("time_s,x_deg,y_deg\n0,0,0\nsoon,0,0\n"),
            "gaze.csv:3: expected a number in the column \"time_s\", got \"soon\"");
  EXPECT_EQ(refused("time_s,x_deg,y_deg\n0.2,0,0\n0.1,0,0\n"),
            "gaze.csv:3: expected times that go on within a trial, got one before the last");
}

/// A line of the file that is refused, after a good one, under these names.
struct BadLine {
  std::string line;
  std::string sentence;  ///< after "gaze.csv:3: expected "
};

void expect_refused(const std::string& names_and_good_line, const std::vector<BadLine>& bad) {
  for (const BadLine& one : bad) {
    EXPECT_EQ(refused(names_and_good_line + one.line + "\n"),
              "gaze.csv:3: expected " + one.sentence)
        << one.line;
  }
}

TEST(GazeFile, WithACellThatIsNeitherANumberNorNothingIsRefused) {
  const std::string number =
      "a number such as -1.5, or nothing where the eye was lost, in the column ";
  expect_refused("time_ms;x_deg;y_deg\n0;0;0\n",
                 {{"0;1,5;0,5", number + R"("x_deg", got "1,5")"},
                  {"0;0;abc", number + R"("y_deg", got "abc")"},
                  {"0;inf;0", number + R"("x_deg", got "inf")"},
                  {"0;1e999;0", number + R"("x_deg", got "1e999")"},
                  {"0;0;+-1", number + R"("y_deg", got "+-1")"},
                  {"0;1 5;0", number + R"("x_deg", got "1 5")"},
                  {"0;;-", number + R"("y_deg", got "-")"},
                  {"0;0x10;0", number + R"("x_deg", got "0x10")"},
                  {"0;\x1B[2J;\xFF", number + "\"x_deg\", got \"\\u001b[2J\""},
                  {"0;0;\xFF", number + "\"y_deg\", got \"\xEF\xBF\xBD\""},
                  {"0;" + std::string(61, 'a') + ";0",
                   number + "\"x_deg\", got \"" + std::string(60, 'a') + "\" ..."},
                  {"0,5;0;0", R"(a number in the column "time_ms", got "0,5")"},
                  {";0;0", R"(a number in the column "time_ms", got "")"},
                  {"NaN;0;0", R"(a number in the column "time_ms", got "NaN")"}});
}

TEST(GazeFile, WithNumbersBeyondAllScreensAndStudiesIsRefused) {
  expect_refused(
      "time_s,x_px,y_px,valid\n0,0,0,1\n",
      {{"0,1e300,0,1", R"(a place from -1000000 to 1000000 in the column "x_px", got "1e300")"},
       {"0,0,-1e7,1", R"(a place from -1000000 to 1000000 in the column "y_px", got "-1e7")"},
       {"1e300,0,0,1",
        R"(a time within a day of the stimulus's onset in the column "time_s", got "1e300")"},
       {"-86401,0,0,1",
        R"(a time within a day of the stimulus's onset in the column "time_s", got "-86401")"}});
  EXPECT_FALSE(loaded("time_s,x_px,y_px,valid\n0,1e8,1e8,0\n").trials[0][0].valid)
      << "what a tracker fills in where it says that the eye was lost";
  expect_refused(
      "TIMESTAMP,RIGHT_GAZE_X,RIGHT_GAZE_Y\n0,0,0\n",
      {{"1e300,0,0",
        R"(a clock's time within 300 years of its zero in the column "TIMESTAMP", got "1e300")"},
       {"86400001,0,0",
        R"(a time within a day of its trial's first in the column "TIMESTAMP", got "86400001")"}});
}

TEST(GazeFile, IsLostWhereAPlaceIsNothingInAnyProgramsWord) {
  const GazeRecording read = loaded(
      "time_s,x_deg,y_deg\n0,,\n0,.,.\n0,NA,NA\n0,n/a,n/a\n0,NaN,nan\n0,-nan,NAN\n0,1,\n"
      "0, +1.5 ,\" -2e-1\t\"\n");
  ASSERT_EQ(read.trials[0].size(), 8U);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_FALSE(read.trials[0][i].valid) << i;
  }
  EXPECT_TRUE(read.trials[0][7].valid);
  EXPECT_EQ(read.trials[0][7].x, 1.5);
  EXPECT_EQ(read.trials[0][7].y, -0.2);
}

/// Whether samples count under a column with these cells.
std::vector<bool> counted(const std::string& column, const std::vector<std::string>& cells) {
  std::string text = "time_s,x_deg,y_deg," + column + "\n";
  for (const std::string& cell : cells) {
    text += "0,0,0," + cell + "\n";
  }
  const GazeRecording read = loaded(text);
  std::vector<bool> counts;
  for (const GazeRecording::Sample& sample : read.trials[0]) {
    counts.push_back(sample.valid);
  }
  return counts;
}

TEST(GazeFile, SaysInKnownWordsWhatCounts) {
  using Counts = std::vector<bool>;
  EXPECT_EQ(counted("valid", {"1", "True", "TRUE", "true"}), Counts(4, true));
  EXPECT_EQ(counted("valid", {"0", "False", "FALSE", "false", "", "NA"}), Counts(6, false));
  EXPECT_EQ(counted("loss", {"", "NA", "NaN"}), Counts(3, true));
  EXPECT_EQ(counted("loss", {"blink", "off screen", "lost"}), Counts(3, false));
  EXPECT_EQ(counted("confidence", {"1", "1.0", ".6", "0.6"}), Counts(4, true));
  EXPECT_EQ(counted("confidence", {"0", "0.59", "", "nan"}), Counts(4, false));
  EXPECT_EQ(counted("Validity left", {"Valid", "0"}), Counts(2, true));
  EXPECT_EQ(counted("Validity left", {"Invalid", "1", "2", "3", "4", ""}), Counts(6, false));
}

TEST(GazeFile, ThatSaysInOtherWordsWhatCountsIsRefused) {
  const std::string names = "time_s,x_deg,y_deg,";
  const std::string valid = R"(1, 0, true, false or nothing in the column "valid", got )";
  expect_refused(names + "valid\n0,0,0,1\n", {{"0,0,0,yes", valid + "\"yes\""},
                                              {"0,0,0,1.0", valid + "\"1.0\""},
                                              {"0,0,0,Valid", valid + "\"Valid\""},
                                              {"0,,,no", valid + "\"no\""}});
  const std::string loss = R"(blink, off screen, lost or nothing in the column "loss", got )";
  expect_refused(names + "loss\n0,0,0,\n",
                 {{"0,0,0,0", loss + "\"0\""}, {"0,0,0,none", loss + "\"none\""}});
  const std::string confidence =
      R"(a number from 0 to 1, or nothing in the column "confidence", got )";
  expect_refused(names + "confidence\n0,0,0,1\n", {{"0,0,0,90", confidence + "\"90\""},
                                                   {"0,0,0,-1", confidence + "\"-1\""},
                                                   {"0,0,0,high", confidence + "\"high\""}});
  expect_refused(names + "Validity left\n0,0,0,0\n",
                 {{"0,0,0,5",
                   "Valid, Invalid, a whole number from 0 to 4 or nothing in the column "
                   R"("Validity left", got "5")"}});
}

TEST(GazeFile, OfImpetusWithoutACompletedMainTrialIsRefused) {
  const std::string names = "trial_phase,attempt_outcome,time_s,x_m,y_m\n";
  EXPECT_EQ(refused(names + "practice,completed,0,0,0\nmain,set aside,,,\n"),
            "gaze.csv: expected samples of completed main trials, got none but others");
  expect_refused(
      names + "main,completed,0,0,0\n",
      {{"test,completed,0,0,0",
        R"(practice, adaptation or main in the column "trial_phase", got "test")"},
       {"main,,0,0,0",
        R"(completed, interrupted or set aside in the column "attempt_outcome", got "")"}});
}

TEST(GazeFile, ThatIsNoTableIsRefusedByItsLine) {
  using namespace std::string_literals;
  expect_refused(
      "time_s,x_deg,y_deg\n0,0,0\n",
      {{"0,0", "3 cells, one for each name, got 2"},
       {"0,1,5,0,5", "3 cells, one for each name, got 5"},
       {"0,0,0,", "3 cells, one for each name, got 4"},
       {"0", "3 cells, one for each name, got 1"},
       {"0,\"0,0\n1,0,0\n2,\"0,0",
        "a quotation mark that ends its cell in the same line, got none"},
       {"0,0,\"0", "a quotation mark that ends its cell in the same line, got none"},
       {"0,0,\"", "a quotation mark that ends its cell in the same line, got none"},
       {"0,0\"0,0",
        "quotation marks only around whole cells, or doubled within one, got one at byte 4 of the "
        "line"},
       {"0,\"1\"5,0",
        "quotation marks only around whole cells, or doubled within one, got one at byte 5 of the "
        "line"},
       {"0,0,1\0005"s, "text in UTF-8, got a byte that is zero"},
       {"\0"s, "text in UTF-8, got a byte that is zero"}});
  EXPECT_EQ(refused("\xFF\xFEt\0i\0m\0e\0"s),
            "gaze.csv:1: expected text in UTF-8, got a byte that is zero");
}

TEST(GazeFile, ThatNamesAColumnTwiceIsRefused) {
  EXPECT_EQ(refused("time_ms,time_ms,x_deg,y_deg\n0,0,0,0\n"),
            "gaze.csv:1: expected one column time_ms, got 2");
  EXPECT_EQ(refused("time_s,x_deg,y_deg,x_deg,x_deg\n0,0,0,0,0\n"),
            "gaze.csv:1: expected one column x_deg, got 3");
  EXPECT_EQ(refused("time_s,x_deg,y_deg,valid,valid\n0,0,0,0,0\n"),
            "gaze.csv:1: expected one column valid, got 2");
  EXPECT_EQ(refused("time_s,x_deg,y_deg,y_px\n0,0,0,0\n"),
            "gaze.csv:1: expected a column x_px beside y_px");
  EXPECT_EQ(loaded("time_s,note,note,x_deg,y_deg\n0,a,b,0,0\n").trials.size(), 1U)
      << "of a column that nothing is read from there may be two";
}

TEST(GazeFile, IsRefusedByTheLineThatAnEditorShows) {
  const std::string sentence = R"(: expected a number in the column "time_s", got "soon")";
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    EXPECT_EQ(refused("time_s,x_deg,y_deg" + end + "0,0,0" + end + "soon,0,0"),
              "gaze.csv:3" + sentence);
    EXPECT_EQ(refused(end + "  " + end + "time_s,x_deg,y_deg" + end + end + "0,0,0" + end + " \t" +
                      end + "soon,0,0" + end),
              "gaze.csv:7" + sentence);
  }
  EXPECT_EQ(refused("\ntime_s,x_deg\n0,0\n"), "gaze.csv:2: expected a column y_deg beside x_deg");
  EXPECT_EQ(refused("\n\n"),
            "gaze.csv: expected a line of names and lines of samples, got an empty file");
}

/// An eye with a recording of two trials, before main trials in slots 3 and 5.
struct Looking {
  Looking()
      : eye(std::make_shared<const GazeRecording>(loaded("trial,time_s,x_share,y_share\n"
                                                         "a,0,0.5,0.5\na,0.1,0.75,0.5\n"
                                                         "b,0,0.25,0.5\nb,0.05,2,0.5\n")),
            {3, 5}, kScreen, clock) {}

  /// A stimulus begins in this slot, and is first shown at `onset_s`.
  void begin(std::int64_t slot, double onset_s) {
    eye.begins(slot);
    Flip flip;
    flip.flipped_ns = std::llround(onset_s * 1e9);
    eye.shown(Picture{}, flip);
  }

  std::vector<GazeSample> samples_at(double time_s) {
    clock.advance_to(std::llround(time_s * 1e9));
    return eye.take_samples();
  }

  VirtualClock clock;
  RecordedEye eye;
};

TEST(RecordedEye, LooksWhereItsTrialDidAtTheSameTimeFromOnset) {
  Looking looking;
  looking.begin(3, 1.0);
  ASSERT_EQ(looking.samples_at(1.05).size(), 1U);
  const auto later = looking.samples_at(1.2);
  ASSERT_EQ(later.size(), 1U);
  EXPECT_EQ(later[0].taken_ns, 1'100'000'000);
  EXPECT_NEAR(later[0].at->x_m, 0.1, 1e-12);
  EXPECT_TRUE(looking.samples_at(3.0).empty()) << "the recording is over";
  looking.begin(5, 4.0);
  const auto second = looking.samples_at(4.2);
  ASSERT_EQ(second.size(), 2U);
  EXPECT_NEAR(second[0].at->x_m, -0.1, 1e-12);
  EXPECT_EQ(second[1].loss, GazeLoss::kOffScreen);
}

TEST(RecordedEye, LooksInPracticeAsInItsFirstTrialAndOnlyOnceSomethingIsShown) {
  Looking looking;
  looking.eye.begins(1);
  EXPECT_TRUE(looking.samples_at(1.0).empty());
  Picture cross;
  cross.fixation_cross = true;
  looking.eye.shown(cross, {});
  EXPECT_TRUE(looking.samples_at(1.5).empty());
  looking.begin(1, 2.0);
  EXPECT_EQ(looking.samples_at(2.2).size(), 2U);
}

TEST(RecordedEye, LooksAtThePointsOfACalibration) {
  Looking looking;
  Picture point;
  point.target = ScreenPoint{0.05, -0.02};
  looking.eye.shown(point, {});
  const auto samples = looking.samples_at(1.0);
  ASSERT_EQ(samples.size(), 1U);
  EXPECT_EQ(samples[0].at, point.target);
}

}  // namespace impetus::gaze_file_test
