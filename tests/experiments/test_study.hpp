// Study files for tests: enrolled, refused, made by another program, written by another user.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Statement.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <functional>
#include <limits>

#include "experiments/settings/input_error.hpp"
#include "experiments/store/attempt_rows.hpp"
#include "experiments/store/step_rows.hpp"
#include "experiments/store/study_reader.hpp"
#include "experiments/store/study_writer.hpp"
#include "experiments/study/stored_plan.hpp"
#include "tests/experiments/fakes.hpp"
#include "tests/experiments/sentence_of.hpp"
#include "tests/experiments/temporary_folder.hpp"

namespace impetus {

inline constexpr const char* kTestBuild = "test build";

/// Runs `act` in a child process and returns what it returned there.
inline std::string in_child(const std::function<std::string()>& act) {
  std::array<int, 2> pipe_ends{};
  EXPECT_EQ(pipe(pipe_ends.data()), 0);
  const pid_t child = fork();
  if (child == 0) {
    const std::string words = act();
    const ssize_t written = write(pipe_ends[1], words.data(), words.size());
    _exit(written == static_cast<ssize_t>(words.size()) ? 0 : 1);
  }
  close(pipe_ends[1]);
  std::string words;
  std::array<char, 4096> part{};
  for (ssize_t size = 0; (size = ::read(pipe_ends[0], part.data(), part.size())) > 0;) {
    words.append(part.data(), static_cast<std::size_t>(size));
  }
  close(pipe_ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  return words;
}

/// Root may write anywhere; nobody may not.
inline void become_nobody() {
  constexpr uid_t kNobody = 65534;
  if (geteuid() == 0 && setresuid(kNobody, kNobody, kNobody) != 0) {
    _exit(2);
  }
}

/// A folder that nobody may enter, too.
struct OpenFolder : TemporaryFolder {
  OpenFolder() { std::filesystem::permissions(path(), std::filesystem::perms(0755)); }
};

inline StudyFile opened(const std::filesystem::path& path) {
  return StudyFile::open_for_writing(path, kTestBuild);
}

inline std::string open_refusal(const std::filesystem::path& path) {
  return sentence_of([&] { opened(path); });
}

inline std::string read_refusal(const std::filesystem::path& path) {
  return sentence_of([&] { StudyFile::open_for_reading(path); });
}

/// A database made with plain SQLite, by these statements.
inline std::filesystem::path plain_database(const std::filesystem::path& path,
                                            const std::string& sql) {
  SQLite::Database database(path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  database.exec(sql);
  return path;
}

inline std::string value_of(const std::filesystem::path& path, const std::string& sql) {
  SQLite::Database database(path.string(), SQLite::OPEN_READONLY);
  return database.execAndGet(sql).getString();
}

inline SessionFacts facts() {
  SessionFacts result;
  result.build = kTestBuild;
  result.machine = "test";
  result.display = "headless";
  result.screen = assumed_screen();
  result.refresh_hz = 60.0;
  result.sync.passed = true;
  return result;
}

/// The attempts of a short headless session: real steps, collisions, frames and ratings.
inline const std::vector<AttemptRecord>& recorded_attempts() {
  static const std::vector<AttemptRecord> attempts = [] {
    TestLab lab;
    run_session(lab.protocol.script, short_plan(lab.protocol, 4), {}, lab.ports());
    return lab.recorder.attempts;
  }();
  return attempts;
}

/// A study with one participant, P01, enrolled for two practice and four main trials.
struct EnrolledStudy {
  explicit EnrolledStudy(const std::filesystem::path& path, const std::string& pseudonym = "P01")
      : study(opened(path)),
        enrolment(enrol(study, pseudonym, false, texts_of(protocol), 1,
                        stored(short_plan(protocol, 4)))) {}

  std::optional<Enrolment> found(const std::string& pseudonym = "P01", bool simulated = false) {
    return find_enrolment(study, pseudonym, simulated, texts_of(protocol));
  }

  Protocol protocol{causality()};
  StudyFile study;
  Enrolment enrolment;
};

}  // namespace impetus
