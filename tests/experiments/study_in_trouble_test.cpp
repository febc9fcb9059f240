// A study that something happens to while a session writes to it: one sentence, nothing lost.
// SPDX-License-Identifier: MIT
#include <SQLiteCpp/Transaction.h>

#include <csignal>

#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/crash.hpp"

namespace impetus::study_in_trouble_test {

/// Starts a session of S01 and waits until some of its trials are acknowledged.
pid_t session_under_way(const TemporaryFolder& folder) {
  const pid_t child = start_program(folder, simulated_run({"--participant", "S01"}));
  for (int tries = 0; tries < 2000 && acknowledged(folder) < 5; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return child;
}

/// Completes S01 in `file` and checks that the whole plan is there.
void expect_goes_on_in(const TemporaryFolder& folder, const std::string& file) {
  Words again = simulated_run({"--participant", "S01"});
  again[3] = file;
  const ProgramResult result = run_program(folder, again);
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM rated_trial", file), "87");
  EXPECT_EQ(value_of(folder, "PRAGMA integrity_check", file), "ok");
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM session", file), "2");
}

TEST(StudyInTrouble, ARemovedFileIsWrittenAnewBesideWhereItWas) {
  const TemporaryFolder folder;
  const pid_t child = session_under_way(folder);
  const std::int64_t before = acknowledged(folder);
  std::filesystem::remove(folder / "a.sqlite");
  const ProgramResult result = wait_for(folder, child);
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.errors,
            "impetus: a.sqlite: removed or replaced while it was written to; all that was saved is "
            "in a.rescued.sqlite\n");
  EXPECT_GE(std::stoll(value_of(folder, kTrialsCompleted, "a.rescued.sqlite")), before);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.sqlite"));
  expect_goes_on_in(folder, "a.rescued.sqlite");
}

TEST(StudyInTrouble, AFileInItsPlaceIsLeftAloneAndNoRescueIsOverwritten) {
  const TemporaryFolder folder;
  folder.write("a.rescued.sqlite", "of last week");
  const pid_t child = session_under_way(folder);
  std::filesystem::rename(folder / "a.sqlite", folder / "moved.sqlite");
  folder.write("a.sqlite", "another file");
  EXPECT_EQ(wait_for(folder, child).errors,
            "impetus: a.sqlite: removed or replaced while it was written to; all that was saved is "
            "in a.rescued-2.sqlite\n");
  EXPECT_EQ(text_of(folder / "a.sqlite"), "another file");
  EXPECT_EQ(text_of(folder / "a.rescued.sqlite"), "of last week");
  expect_goes_on_in(folder, "a.rescued-2.sqlite");
}

TEST(StudyInTrouble, AProgramThatHoldsTheFileForSecondsDelaysASessionAndDoesNotEndIt) {
  const TemporaryFolder folder;
  const pid_t child = session_under_way(folder);
  {
    SQLite::Database other((folder / "a.sqlite").string(), SQLite::OPEN_READWRITE);
    other.setBusyTimeout(5000);
    SQLite::Transaction holding(other, SQLite::TransactionBehavior::IMMEDIATE);
    std::this_thread::sleep_for(std::chrono::seconds(3));
  }
  const ProgramResult result = wait_for(folder, child);
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM rated_trial"), "87");
}

TEST(StudyInTrouble, ASecondSessionOnTheSameFileIsRefusedAndTheFirstGoesOn) {
  const TemporaryFolder folder;
  const TemporaryFolder elsewhere;
  const pid_t child = session_under_way(folder);
  Words second = simulated_run({"--participant", "S02"});
  second[3] = (folder / "a.sqlite").string();
  ASSERT_EQ(kill(child, SIGSTOP), 0);  // it does not end before the other begins
  expect_refused(elsewhere, second,
                 second[3] + ": in use by another Impetus process; end that session first");
  ASSERT_EQ(kill(child, SIGCONT), 0);
  EXPECT_EQ(wait_for(folder, child).status, 0);
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM rated_trial"), "87");
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM participant"), "1");
}

}  // namespace impetus::study_in_trouble_test
