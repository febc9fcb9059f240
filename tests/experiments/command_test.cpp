// The program as a researcher meets it: commands, sentences, exit status.
// SPDX-License-Identifier: MIT
#include <regex>

#include "tests/experiments/command_lines.hpp"
#include "tests/places/places.hpp"

namespace impetus::command_test {

using nlohmann::json;

// ---------------------------------------------------------------- arguments

TEST(CommandLine, WhatIsNoCommandIsRefusedWithTheCommandsThereAre) {
  const TemporaryFolder folder;
  const std::string expected =
      "expected one of the commands run, check, collect, exclude, export, extremes, film, fit, "
      "merge, "
      "new, "
      "observers, power, predict, preview, publish, recover, replay, report, screen, serve, "
      "sessions, "
      "timing, "
      "verify, mesh, "
      "tree, trade, got ";
  expect_refused(folder, {}, expected + "none");
  expect_refused(folder, {"walk"}, expected + "walk");
  expect_refused(folder, {"--fast"}, expected + "--fast");
  expect_refused(folder, {"chekc"}, expected + "chekc; did you mean check?");
}

TEST(CommandLine, HelpAndVersionAreNoFailure) {
  const TemporaryFolder folder;
  for (const char* option : {"--help", "--version"}) {
    const ProgramResult result = run_program(folder, {option});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.errors, "");
    EXPECT_NE(result.output, "");
  }
}

TEST(CommandLine, WhatCannotBePrintedInFullIsAFailureUnlessNobodyIsToReadIt) {
  const TemporaryFolder folder;
  const ProgramResult full = run_program(folder, {"check", causality_file()},
                                         [] { dup2(open("/dev/full", O_WRONLY), STDOUT_FILENO); });
  EXPECT_EQ(full.status, 2);
  EXPECT_EQ(full.errors, "impetus: what was to be printed could not be written in full\n");
  const ProgramResult closed =
      run_program(folder, {"check", causality_file()}, [] { close(STDOUT_FILENO); });
  EXPECT_EQ(closed.status, 0);
  EXPECT_EQ(closed.errors, "");
}

TEST(CommandLine, AWrongArgumentIsRefusedAndNoStudyIsMade) {
  const TemporaryFolder folder;
  const std::vector<std::pair<Words, std::string>> cases{
      {{"run"}, "protocol is required"},
      {{"check"}, "files is required"},
      {{"replay"}, "study is required"},
      {{"check", causality_file(), "--refresh", "5"},
       "--refresh: Value 5 not in range 20.000000 to 1000.000000"},
      {{"check", causality_file(), "--refresh", "nan"}, "--refresh: expected a number, got nan"},
      {simulated_run({"--participant", "S01", "--fast"}),
       "The following argument was not expected: --fast"},
      {simulated_run({"--participant", "S01", "--sed", "4"}),
       "The following arguments were not expected: 4 --sed; did you mean --seed?"},
      {{"preview", causality_file()},
       causality_file() + ": expected a scene, got a protocol, whose scene is "
                          "../stimuli/two-spheres.json; impetus "
                          "check explains a protocol, impetus run shows it"},
      {{"run", source_folder() + "/stimuli/two-spheres.json", "--db", "a.sqlite", "--participant",
        "P01"},
       source_folder() + "/stimuli/two-spheres.json" +
           ": expected a protocol, got a scene, which impetus preview shows"},
      {{"--threads", "0", "check", causality_file()}, "--threads: Value 0 not in range 1 to 64"},
      {{"--threads", "010", "check", causality_file()},
       "--threads: expected a whole number without a 0 before it, got 010"},
      {simulated_run({"--participants", "0x10"}),
       "--participants: expected a whole number without a 0 before it, got 0x10"},
      {simulated_run({"--participant", "S01", "--window", "640x512"}),
       "--window: expected --show beside --observer, for nobody sees a window else"},
      {simulated_run({"--participants", "0"}), "--participants: Value 0 not in range 1 to 100000"},
      {simulated_run({"--participant", "S01", "--seed", "-1"}),
       "--seed: Value -1 not in range 0 to 9223372036854775807"},
      {simulated_run({}), "--participant: expected a code for the participant, such as P01"},
      {simulated_run({"--participant", ""}),
       "--participant: expected a code for the participant, such as P01"},
      {simulated_run({"--participant", "S01", "--participants", "3"}),
       "--participant: expected either one participant or --participants N"},
      {{"run", causality_file(), "--db", "a.sqlite", "--participants", "3"},
       "--participants: expected --observer NAME with it; people come one by one"},
      {{"run", causality_file(), "--db", "a.sqlite", "--participant", "P01", "--show"},
       "--show: expected --observer NAME with it"},
      {{"run", causality_file(), "--db", "a.sqlite", "--participant", "P01", "--observer",
        "nobody"},
       "--observer nobody: expected a file, or a name that `impetus observers` lists"}};
  for (const auto& [arguments, sentence] : cases) {
    expect_refused_without_a_file(folder, arguments, sentence);
  }
}

// ---------------------------------------------------------------- check

TEST(Check, PrintsTheDesign) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program(folder, {"check", causality_file()});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.errors, "");
  const std::vector<std::string> lines = lines_of(result.output);
  for (const std::string line :
       {"  factor       delay_ms = 0, 100, 300",
        "               Delay at contact (ms); overrides /imposed/contact_hold_ms",
        "  factor       speed_deg_s = 5, 10, 15", "  factor       viewpoint_deg = 0, 45, 85",
        "  trials       81", "  design       3 × 3 × 3 cells, 3 repetitions of each.",
        "  design       Practice: 6 trials.",
        "  design       At most 3 trials in a row with equal `delay_ms`.",
        "  shown        delay_ms 0: 27 times, 100: 27 times, 300: 27 times",
        "  rating       1 (very believable) to 3 (very unbelievable)"}) {
    EXPECT_EQ(std::count(lines.begin(), lines.end(), line), 1) << line;
  }
  EXPECT_EQ(lines.front(), causality_file() + ": valid");
}

TEST(Check, AnInvalidFileIsStatus1AndTheOthersAreStillChecked) {
  const TemporaryFolder folder;
  const std::string bad = changed_protocol(folder, "/design/repetitions", 0);
  const ProgramResult result = run_program(folder, {"check", bad, causality_file()});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.errors,
            "impetus: protocols/a.json:/design/repetitions: expected a whole number ≥ 1 and ≤ "
            "1000, got 0\n");
  EXPECT_EQ(lines_of(result.output).front(), causality_file() + ": valid");
}

TEST(Check, RefusesADelayThatIsNoWholeNumberOfTheDisplaysFrames) {
  const TemporaryFolder folder;
  expect_refused(folder, {"check", causality_file(), "--refresh", "85"},
                 causality_file() +
                     ":/design/factors/0/levels/1: expected a whole number of 85 Hz frames (11.76 "
                     "ms), got 100",
                 1);
  EXPECT_EQ(run_program(folder, {"check", causality_file(), "--refresh", "85", "--allow-rounding"})
                .status,
            0);
}

/// The creatures of the project under a budget in milliseconds.
std::string creatures_within(double budget_ms) {
  json scene = json::parse(shipped("stimuli/creatures-in-a-cube.json"));
  scene["engine"]["budget"] = {{"ms_per_step", budget_ms}};
  scene["crowd"]["count"] = 40;
  return scene.dump();
}

TEST(Check, SaysOfASceneWhatItsStepsTakeWhateverTheBudget) {
  const TemporaryFolder folder;
  folder.write("scene.json", creatures_within(1'000.0));
  const ProgramResult result = run_program(folder, {"check", "scene.json"});
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_TRUE(std::regex_search(
      result.output,
      std::regex(
          "^scene.json: valid, a scene\n.*\n  bodies       40\n"
          "  floor        [0-9.]+ ms of a budget of 1000 for 40 bodies, on this machine\n$")))
      << result.output;
}

TEST(Check, RefusesABudgetBelowWhatAStepTakesInAnyCase) {
  const TemporaryFolder folder;
  folder.write("scene.json", creatures_within(1e-6));
  const ProgramResult result = run_program(folder, {"check", "scene.json"});
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(std::regex_search(
      result.errors,
      std::regex("impetus: scene.json:/engine/budget/ms_per_step: expected at least [0-9.]+ ms, "
                 "which a step of 40 bodies takes on this machine whatever is left undone, got "
                 "1e-06\n")))
      << result.errors;
}

TEST(Check, AnyUnreadableFileIsStatus1) {
  const TemporaryFolder folder;
  folder.write("a.json", "{\n  \"name\": }\n");
  expect_refused(folder, {"check", "a.json"}, "a.json:2:11: expected valid JSON, got '}'", 1);
  expect_refused(folder, {"check", "b.json"},
                 "b.json: expected a JSON file, but it cannot be read: there is no such file", 1);
}

// ---------------------------------------------------------------- replay

TEST(Replay, EveryTrialOfASessionIsReproduced) {
  const TemporaryFolder folder;
  run_program(folder, simulated_run({"--participant", "S01"}));
  const ProgramResult result = run_program(folder, {"replay", "a.sqlite"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.errors, "");
  EXPECT_EQ(lines_of(result.output).size(), 1U);
  EXPECT_EQ(result.output.rfind("87 trials, ", 0), 0U) << result.output;
  EXPECT_NE(result.output.find(" 0 divergent\n"), std::string::npos) << result.output;
}

TEST(Replay, IsTheSameWhereThreadsShareTheSteps) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program(
      folder,
      {"--threads", "2", "replay", source_folder() + "/tests/recordings/far-and-fast.sqlite"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.errors, "");
  EXPECT_NE(result.output.find(" 0 divergent\n"), std::string::npos) << result.output;
}

TEST(Replay, AChangedHashIsFoundAtItsStep) {
  const TemporaryFolder folder;
  run_program(folder, simulated_run({"--participant", "S01"}));
  change(folder, "UPDATE step SET hash = hash + 1 WHERE attempt_id = 5 AND step = 100");
  change(folder,
         "UPDATE step SET hash = hash + 1, digests = zeroblob(length(digests)) "
         "WHERE attempt_id = 7 AND step = 0");
  const ProgramResult result = run_program(folder, {"replay", "a.sqlite"});
  EXPECT_EQ(result.status, 1);
  const std::vector<std::string> lines = lines_of(result.output);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0], "trial 5 (S01, slot 5, attempt 1): diverges at step 100, in the hash alone");
  EXPECT_EQ(lines[1], "trial 7 (S01, slot 7, attempt 1): diverges at step 0, body left, position");
  EXPECT_NE(lines[2].find(" 2 divergent"), std::string::npos);
}

TEST(Replay, ADivergenceOfAnOlderFormatNamesTheBuildThatReproducesIt) {
  const TemporaryFolder folder;
  run_program(folder, simulated_run({"--participant", "S01"}));
  change(folder, "UPDATE session SET recording_format = 1, build = 'Impetus 0.0'");
  EXPECT_EQ(run_program(folder, {"replay", "a.sqlite"}).status, 0);
  change(folder, "UPDATE step SET hash = hash + 1 WHERE attempt_id = 5 AND step = 100");
  const ProgramResult result = run_program(folder, {"replay", "a.sqlite"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(lines_of(result.output).front(),
            "trial 5 (S01, slot 5, attempt 1): diverges at step 100, in the hash alone; it was "
            "recorded in format 1 by Impetus 0.0: replay it there as well");
}

TEST(Replay, WhatCannotBeReplayedIsRefused) {
  const TemporaryFolder folder;
  folder.write("empty.sqlite", "");
  expect_refused(folder, {"replay", "none.sqlite"},
                 "none.sqlite: expected an Impetus study, but there is no such file");
  expect_refused(folder, {"replay", "empty.sqlite"},
                 "empty.sqlite: expected an Impetus study, got an empty file");
  run_program(folder, simulated_run({"--participant", "S01"}));
  expect_refused(folder, {"replay", "a.sqlite", "--trial", "999"},
                 "a.sqlite: expected a recorded trial 999, but there is none");
  expect_refused(folder, {"replay", "a.sqlite", "--participant", "S02"},
                 "a.sqlite: expected a recorded trial of S02, but there is none");
  const std::string replayed =
      "formats 1 to " + std::to_string(kRecordingFormat) + ", use that one";
  change(folder, "UPDATE session SET recording_format = 99, build = 'Impetus 9.0'");
  expect_refused(
      folder, {"replay", "a.sqlite"},
      "a.sqlite: trial 1 was recorded in format 99 by Impetus 9.0; this build replays " + replayed);
  change(folder, "UPDATE session SET recording_format = 0, build = 'Impetus 0.0'");
  expect_refused(
      folder, {"replay", "a.sqlite"},
      "a.sqlite: trial 1 was recorded in format 0 by Impetus 0.0; this build replays " + replayed);
}

TEST(Replay, ADivergenceThatDigestsHideForAStepIsNamedByTheNext) {
  const TemporaryFolder folder;
  run_program(folder, simulated_run({"--participant", "S01"}));
  change(folder, "UPDATE step SET hash = hash + 1 WHERE attempt_id = 5 AND step = 100");
  change(folder,
         "UPDATE step SET hash = hash + 1, digests = zeroblob(length(digests)) "
         "WHERE attempt_id = 5 AND step = 101");
  EXPECT_EQ(lines_of(run_program(folder, {"replay", "a.sqlite"}).output).front(),
            "trial 5 (S01, slot 5, attempt 1): diverges at step 100, body left, position, as step "
            "101 tells");
}

TEST(Replay, ADamagedStudyIsRefusedByName) {
  const TemporaryFolder folder;
  run_program(folder, simulated_run({"--participant", "S01"}));
  const std::string whole = text_of(folder / "a.sqlite");
  const std::size_t half = whole.size() / 2;
  folder.write("cut.sqlite", whole.substr(0, half));
  expect_refused(folder, {"replay", "cut.sqlite"},
                 "cut.sqlite: expected an Impetus study that can be read: database disk image is "
                 "malformed");
  folder.write("overwritten.sqlite", whole.substr(0, half) + std::string(whole.size() - half, 'x'));
  expect_refused(folder, {"replay", "overwritten.sqlite"},
                 "overwritten.sqlite: could not be read (database disk image is malformed)");
}

#ifndef IMPETUS_PROGRAM_HAS_WINDOW
TEST(Replay, WithoutAWindowNothingCanBeViewed) {
  const TemporaryFolder folder;
  expect_refused(folder, {"replay", "a.sqlite", "--view"}, "--view: this build has no window");
}

TEST(Screen, WithoutAWindowItAsksForTheNumbers) {
  const TemporaryFolder folder;
  expect_refused(folder, {"screen"},
                 "this build has no window; give --width-cm, --height-cm and --distance-cm");
}
#endif

// ---------------------------------------------------------------- impetus preview

TEST(Preview, ASceneThatIsNoneIsRefusedBeforeAWindowOpens) {
  const TemporaryFolder folder;
  expect_refused(folder, {"preview", "none.json"},
                 "none.json: expected a JSON file, but it cannot be read: there is no such file");
  folder.write("a.json", "{}");
  expect_refused(folder, {"preview", "a.json"},
                 "a.json:/: expected the key \"schema_version\", which is missing");
}

TEST(Preview, WithoutADisplayItSaysSo) {
  const TemporaryFolder folder;
  const std::string scene = source_folder() + "/stimuli/two-l-blocks.json";
#ifdef IMPETUS_PROGRAM_HAS_WINDOW
  folder.write("screen.json",
               R"({"schema_version": 1, "width_cm": 37.6, "height_cm": 30.1,
                   "viewing_distance_cm": 57})");
  expect_refused(folder, {"preview", scene, "--screen", "screen.json"},
                 "no display could be opened: neither X11 nor Wayland answered");
  expect_refused(folder, {"preview", scene, "--window", "320x200"},
                 "--window 320x200: expected WIDTHxHEIGHT of at least 640x480 pixels");
#else
  expect_refused(folder, {"preview", scene},
                 "this build has no window; " + scene + " can be checked, but not shown");
#endif
}

TEST(Screen, SavesWhatWasGiven) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program(folder, {"screen", "--width-cm", "40", "--height-cm", "30", "--distance-cm", "57",
                           "--file", "s.json"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output, "40.00 cm x 30.00 cm seen from 57.0 cm, saved in s.json\n");
  EXPECT_EQ(json::parse(text_of(folder / "s.json"))["viewing_distance_cm"], 57.0);
}

TEST(Screen, KeepsThatItsPixelsAreNotSquare) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program(folder, {"screen", "--width-cm", "40", "--height-cm", "30", "--distance-cm", "57",
                           "--pixels-not-square", "--file", "s.json"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output,
            "40.00 cm x 30.00 cm seen from 57.0 cm, of pixels that are not square, saved in "
            "s.json\n");
  EXPECT_EQ(json::parse(text_of(folder / "s.json"))["square_pixels"], false);
}

}  // namespace impetus::command_test
