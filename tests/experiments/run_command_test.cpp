// `impetus run` as a researcher meets it: what it refuses, what it keeps, how it goes on.
// SPDX-License-Identifier: MIT
#include <sys/resource.h>

#include <csignal>

#include "tests/experiments/command_lines.hpp"

namespace impetus::run_command_test {

using nlohmann::json;

TEST(Run, ABadProtocolIsRefusedAndNoStudyIsMade) {
  const TemporaryFolder folder;
  const std::vector<std::tuple<std::string, json, std::string>> cases{
      {"/design/factors/0/levels/1", -100,
       "/design/factors/0/levels/1: expected a number ≥ 0 and ≤ 60000, got -100"},
      {"/design/factors/0/levels", json::array(),
       "/design/factors/0/levels: expected a list of at least 1 value without repeats, got []"},
      {"/design/practise", json::array(),
       "/design: expected only the keys \"adaptation\", \"adaptive\", \"blocks\", "
       "\"catch_trials\", \"factors\", "
       "\"longest_runs\", \"practice\", \"practice_until\", \"repetitions\", "
       "\"train_until\", got \"practise\""},
      {"/timing/fixation_ms", 490,
       "/timing/fixation_ms: expected a whole number of 60 Hz frames (16.67 ms), got 490"},
      {"/rating/maximum", 5,
       "/rating: expected a scale of 3 points, as the simulated participant rates (one more than "
       "its "
       "file has cuts), got 5, from 1 to 5"}};
  for (const auto& [pointer, value, sentence] : cases) {
    const std::string file = changed_protocol(folder, pointer, value);
    expect_refused_without_a_file(
        folder,
        {"run", file, "--db", "a.sqlite", "--observer", "causality", "--participant", "S01"},
        file + ":" + sentence);
  }
}

TEST(Run, WithoutADisplayNothingIsWritten) {
  const TemporaryFolder folder;
#ifdef IMPETUS_PROGRAM_HAS_WINDOW
  const std::string sentence =
      "no display could be opened: neither X11 nor Wayland answered; run with --observer to go on "
      "without a window";
#else
  const std::string sentence = "this build has no window; run with --observer NAME, without --show";
#endif
  expect_refused_without_a_file(
      folder, {"run", causality_file(), "--db", "a.sqlite", "--participant", "P01"}, sentence);
  expect_refused_without_a_file(folder, simulated_run({"--participant", "S01", "--show"}),
                                sentence);
}

#ifdef IMPETUS_PROGRAM_HAS_WINDOW
TEST(Run, WhatTheWindowCannotUseIsRefusedBeforeItOpens) {
  const TemporaryFolder folder;
  folder.write("screen.json", "{}");
  const Words run{"run", causality_file(), "--db", "a.sqlite", "--participant", "P01"};
  const std::vector<std::pair<Words, std::string>> cases{
      {{"--window", "320x200"},
       "--window 320x200: expected WIDTHxHEIGHT of at least 640x480 pixels"},
      {{"--screen", "none.json"},
       "none.json: expected a JSON file, but it cannot be read: there is no such file"},
      {{"--screen", "screen.json"},
       "screen.json:/: expected the key \"schema_version\", which is missing"}};
  for (const auto& [more, sentence] : cases) {
    Words arguments = run;
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_refused_without_a_file(folder, arguments, sentence);
  }
}
#endif

TEST(Run, AnObserversSessionIsRecordedWhole) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program(folder, simulated_run({"--participant", "S01"}));
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output, "Saved in a.sqlite: participant S01, session 1\n");
  EXPECT_EQ(complaints_of(result), "");
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM rated_trial WHERE phase = 'main'"), "81");
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM rated_trial WHERE phase = 'practice'"), "6");
  EXPECT_EQ(value_of(folder, "SELECT ending FROM session"), "finished");
}

TEST(Run, AFinishedParticipantIsRefusedAndNothingChanges) {
  const TemporaryFolder folder;
  run_program(folder, simulated_run({"--participant", "S01"}));
  const std::string before = text_of(folder / "a.sqlite");
  expect_refused(folder, simulated_run({"--participant", "S01"}),
                 "a.sqlite: participant S01 has finished causality already, at " +
                     value_of(folder, "SELECT finished_utc FROM enrolment"));
  // Opening a study for writing changes its header's counters, and nothing else of it.
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM session"), "1");
  EXPECT_EQ(text_of(folder / "a.sqlite").size(), before.size());
}

/// The study's only session as if it had been left, before a wide screen.
void leave_wide_session(const TemporaryFolder& folder) {
  SQLite::Database database((folder / "a.sqlite").string(), SQLite::OPEN_READWRITE);
  database.exec(
      "UPDATE enrolment SET finished_utc = NULL; UPDATE session SET ending = 'quit', "
      "screen_width_m = 0.535, screen_width_px = 1920, screen_height_px = 1080");
}

TEST(Run, ResumingOnAnotherScreenIsRefusedUnlessItIsSaid) {
  const TemporaryFolder folder;
  run_program(folder, simulated_run({"--participant", "S01"}));
  leave_wide_session(folder);
  expect_refused(folder, simulated_run({"--participant", "S01"}),
                 "a.sqlite: participant S01 goes on: expected the screen of the session before "
                 "(53.5 cm x 30.1 cm, 1920 x 1080 pixels, seen from 57.0 cm), got 37.6 cm x 30.1 "
                 "cm, 1280 x 1024 pixels, seen from 57.0 cm; --changed-screen goes on with this "
                 "one, and keeps a note");
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM session"), "1");
  const std::string change =
      "37.6 cm x 30.1 cm, 1280 x 1024 pixels, seen from 57.0 cm; in the session before 53.5 cm x "
      "30.1 cm, 1920 x 1080 pixels, seen from 57.0 cm";
  const ProgramResult result =
      run_program(folder, simulated_run({"--participant", "S01", "--changed-screen"}));
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output, "Saved in a.sqlite: participant S01, session 2\n");
  EXPECT_EQ(complaints_of(result), "warning: the screen changed: " + change + "\n");
  EXPECT_EQ(value_of(folder, "SELECT text FROM note WHERE kind = 'screen changed'"), change);
  EXPECT_NE(run_program(folder, {"verify", "a.sqlite"}).output.find("whole, but S01 sat before 2"),
            std::string::npos);
}

TEST(Run, ResumingWithAnotherSeedIsRefused) {
  const TemporaryFolder folder;
  run_program(folder, simulated_run({"--participant", "S01", "--seed", "7"}));
  change(folder, "UPDATE enrolment SET finished_utc = NULL");
  expect_refused(folder, simulated_run({"--participant", "S01", "--seed", "8"}),
                 "--seed 8: expected 7, with which S01's trials were planned");
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM session"), "1");
  EXPECT_EQ(run_program(folder, simulated_run({"--participant", "S01"})).status, 0);
}

TEST(Run, AResumedObserverAnswersAsTheSamePersonWithoutBeingToldTheSeed) {
  const TemporaryFolder folder;
  const std::string ratings =
      "SELECT group_concat(rating) FROM (SELECT rating FROM rated_trial "
      "ORDER BY slot)";
  run_program(folder, simulated_run({"--participant", "S01", "--seed", "7"}));
  const std::string whole = value_of(folder, ratings);
  // As if the first session had been killed before its first trial was saved.
  change(folder,
         "UPDATE enrolment SET finished_utc = NULL; DELETE FROM rating; DELETE FROM step; "
         "DELETE FROM frame; DELETE FROM collision; DELETE FROM attempt");
  EXPECT_EQ(run_program(folder, simulated_run({"--participant", "S01"})).status, 0);
  EXPECT_EQ(value_of(folder, ratings), whole);
}

TEST(Run, ResumingWithAnotherVersionOfTheProtocolIsRefused) {
  const TemporaryFolder folder;
  run_program(folder, simulated_run({"--participant", "S01"}));
  change(folder, "UPDATE enrolment SET finished_utc = NULL");
  expect_refused(folder,
                 {"run", changed_protocol(folder, "/title", "Another"), "--db", "a.sqlite",
                  "--observer", "causality", "--participant", "S01"},
                 "a.sqlite: participant S01 began with another version of causality; resume with "
                 "the file it was, or use another name");
}

TEST(Run, OrderFollowsFromParticipantAndSeedAlone) {
  const TemporaryFolder folder;
  run_program(folder, simulated_run({"--participant", "S01"}));
  run_program(folder, simulated_run({"--participant", "S02"}));
  Words elsewhere = simulated_run({"--participant", "S01"});
  elsewhere[3] = "b.sqlite";
  run_program(folder, elsewhere);
  EXPECT_NE(order_of(folder, "S01"), order_of(folder, "S02"));
  EXPECT_EQ(order_of(folder, "S01"), order_of(folder, "S01", "b.sqlite"));
}

TEST(Run, SimulatedParticipantsAreNamedInOrder) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_program(folder, simulated_run({"--participants", "3"})).status, 0);
  EXPECT_EQ(value_of(folder, "SELECT group_concat(pseudonym) FROM participant"), "S01,S02,S03");
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM enrolment WHERE finished_utc IS NOT NULL"), "3");
}

TEST(Run, WhatIsNoStudyIsRefusedAndLeftAlone) {
  const TemporaryFolder folder;
  folder.write("a.sqlite", "My notes on the pilot study of last week.");
  expect_refused(folder, simulated_run({"--participant", "S01"}),
                 "a.sqlite: expected an Impetus study, got a file that is no SQLite database");
  EXPECT_EQ(text_of(folder / "a.sqlite"), "My notes on the pilot study of last week.");
}

TEST(Run, AFullDiskEndsInOneSentenceAndTheSameCommandGoesOn) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program(folder, simulated_run({"--participant", "S01"}), [] {
    const rlimit limit{1'000'000, 1'000'000};  // Some twenty trials of eighty-seven.
    std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &limit);
  });
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.errors,
            "impetus: a.sqlite: could not be written (disk I/O error); everything up to the last "
            "completed trial is saved\n");
  EXPECT_EQ(run_program(folder, simulated_run({"--participant", "S01"})).status, 0);
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM rated_trial"), "87");
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM session"), "2");
  EXPECT_EQ(value_of(folder, "PRAGMA integrity_check"), "ok");
}

}  // namespace impetus::run_command_test
