// Kills a running session at a random moment and checks that nothing acknowledged was lost.
//
//   start `impetus run` ──random delay──> count what is committed ──> SIGKILL
//        └─ the file is whole, has at least that many trials ─> same command ─> 87 trials, replayed
//
// Acknowledged means committed: what a second connection sees just before the kill must be there
// after it.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "tests/experiments/program.hpp"

namespace impetus {

constexpr std::int64_t kTrialsPlanned = 87;  // 6 of practice, 81 that count

constexpr const char* kTrialsCompleted = "SELECT count(*) FROM attempt WHERE outcome = 'completed'";

inline std::string crash_value(const TemporaryFolder& folder, const std::string& sql) {
  SQLite::Database database((folder / "a.sqlite").string(), SQLite::OPEN_READONLY);
  database.setBusyTimeout(5000);
  return database.execAndGet(sql).getString();
}

/// Completed attempts that another process sees now; 0 while there is no study yet.
inline std::int64_t acknowledged(const TemporaryFolder& folder) {
  try {
    return std::stoll(crash_value(folder, kTrialsCompleted));
  } catch (const SQLite::Exception&) {
    return 0;
  }
}

/// Starts a session, kills it a delay after so many trials were acknowledged, and returns how many
/// were then: however slow the machine, the kill comes where it was meant to.
inline std::int64_t kill_session_after(const TemporaryFolder& folder, std::int64_t trials,
                                       std::chrono::microseconds delay) {
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = start_program(folder, simulated_run({"--participant", "S01"}));
  while (acknowledged(folder) < trials) {
    if (std::chrono::steady_clock::now() - start > std::chrono::minutes(2)) {
      ADD_FAILURE() << "a session that saves nothing";
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::this_thread::sleep_for(delay);
  const std::int64_t count = acknowledged(folder);
  kill(child, SIGKILL);
  wait_for(folder, child);
  return count;
}

/// The study as the kill left it: opened by SQLite alone, before the program repairs anything.
inline void expect_nothing_lost(const TemporaryFolder& folder, std::int64_t before_kill) {
  if (before_kill == 0 && acknowledged(folder) == 0) {
    return;  // Killed so early that there may be no study to look at.
  }
  EXPECT_EQ(crash_value(folder, "PRAGMA integrity_check"), "ok");
  EXPECT_EQ(crash_value(folder, "SELECT count(*) FROM pragma_foreign_key_check"), "0");
  EXPECT_GE(acknowledged(folder), before_kill);
  const ProgramResult verified = run_program(folder, {"verify", "a.sqlite"});
  const bool whole =
      verified.status == 0 ||
      verified.output.find(": cannot be published: whole, but ") != std::string::npos;
  EXPECT_TRUE(whole) << verified.output;
  // One transaction per trial: none is there in part.
  EXPECT_EQ(crash_value(folder,
                        "SELECT count(*) FROM attempt WHERE outcome = 'completed' AND "
                        "(id NOT IN (SELECT attempt_id FROM rating) OR "
                        " id NOT IN (SELECT attempt_id FROM step) OR "
                        " id NOT IN (SELECT attempt_id FROM frame))"),
            "0");
}

/// After the same command again: the whole session, in the planned order, and reproducible.
inline void expect_whole_session(const TemporaryFolder& folder) {
  EXPECT_EQ(crash_value(folder, kTrialsCompleted), std::to_string(kTrialsPlanned));
  EXPECT_EQ(crash_value(folder, "SELECT count(*) FROM trial"), std::to_string(kTrialsPlanned));
  EXPECT_EQ(crash_value(folder, "SELECT count(*) FROM enrolment WHERE finished_utc IS NULL"), "0");
  EXPECT_EQ(crash_value(folder,
                        "SELECT count(*) FROM (SELECT slot, row_number() OVER (ORDER BY "
                        "attempt.id) AS place FROM attempt JOIN trial ON trial.id = "
                        "trial_id WHERE outcome = 'completed') WHERE slot <> place"),
            "0");
  const ProgramResult replayed = run_program(folder, {"replay", "a.sqlite"});
  EXPECT_EQ(replayed.status, 0);
  EXPECT_NE(replayed.output.find(" 0 divergent"), std::string::npos) << replayed.output;
}

/// How many kills came while trials were being saved: the others prove little.
struct CrashSummary {
  int in_mid_session{0};
};

inline CrashSummary kill_and_resume(int kills, std::uint32_t seed) {
  std::printf("seed %u\n", seed);
  std::mt19937 random(seed);
  const TemporaryFolder unharmed;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(run_program(unharmed, simulated_run({"--participant", "S01"})).status, 0);
  const auto duration = std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::steady_clock::now() - start);
  std::uniform_int_distribution<std::int64_t> trials(0, kTrialsPlanned - 1);
  // Within a trial, or the next one; before the first, within what it takes to begin.
  std::uniform_int_distribution<std::int64_t> within_us(0, 2 * duration.count() / kTrialsPlanned);
  std::uniform_int_distribution<std::int64_t> beginning_us(0, duration.count() / 4);

  CrashSummary summary;
  for (int number = 0; number < kills; ++number) {
    const std::int64_t after = trials(random);
    const std::chrono::microseconds delay(after > 0 ? within_us(random) : beginning_us(random));
    SCOPED_TRACE("kill " + std::to_string(number) + ", " + std::to_string(delay.count()) +
                 " us after " + std::to_string(after) + " trials");
    const TemporaryFolder folder;
    const std::int64_t before_kill = kill_session_after(folder, after, delay);
    expect_nothing_lost(folder, before_kill);
    summary.in_mid_session += before_kill > 0 && before_kill < kTrialsPlanned ? 1 : 0;
    const ProgramResult again = run_program(folder, simulated_run({"--participant", "S01"}));
    const bool was_done = again.errors.find("has finished causality already") != std::string::npos;
    EXPECT_TRUE(again.status == 0 || was_done) << again.errors;
    expect_whole_session(folder);
  }
  return summary;
}

}  // namespace impetus
