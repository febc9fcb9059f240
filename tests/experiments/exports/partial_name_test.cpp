// What is written beside its target, and what a killed program left there.
// SPDX-License-Identifier: MIT
#include "experiments/exports/partial_name.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>

#include "tests/experiments/temporary_folder.hpp"

namespace impetus::partial_name_test {

namespace fs = std::filesystem;
using Kind = PartialName::Kind;

void make_old(const fs::path& path) {
  fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::minutes(1));
}

/// Another program begins to write the target and is killed. What it left.
fs::path left_by_a_killed_program(const fs::path& target, Kind kind) {
  int pipe_ends[2];
  EXPECT_EQ(pipe(pipe_ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    const PartialName partial(target, kind);
    const std::string path = partial.path().string();
    const bool is_told = write(pipe_ends[1], path.data(), path.size()) > 0;
    pause();
    _exit(is_told ? 0 : 1);
  }
  char path[1000];
  const ssize_t size = ::read(pipe_ends[0], path, sizeof path);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  close(pipe_ends[0]);
  close(pipe_ends[1]);
  EXPECT_GT(size, 0);
  return std::string(path, static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
}

TEST(PartialName, OfAKilledProgramIsRemovedByTheNextOfTheSameTarget) {
  const TemporaryFolder folder;
  for (const Kind kind : {Kind::kFile, Kind::kFolder}) {
    const fs::path left = left_by_a_killed_program(folder / "film.mkv", kind);
    ASSERT_TRUE(fs::exists(left));
    if (kind == Kind::kFolder) {
      std::ofstream(left / "frame.png") << "half";
    }
    make_old(left);
    const PartialName other(folder / "film.mp4", kind);
    EXPECT_TRUE(fs::exists(left));
    const PartialName next(folder / "film.mkv", kind);
    EXPECT_FALSE(fs::exists(left));
    EXPECT_TRUE(fs::exists(next.path()));
    fs::remove_all(next.path());
    fs::remove_all(other.path());
  }
}

TEST(PartialName, ThatSomebodyStillWritesStays) {
  const TemporaryFolder folder;
  for (const Kind kind : {Kind::kFile, Kind::kFolder}) {
    const PartialName written(folder / "film.mkv", kind);
    make_old(written.path());
    const PartialName next(folder / "film.mkv", kind);
    EXPECT_TRUE(fs::exists(written.path()));
    EXPECT_NE(written.path(), next.path());
  }
}

TEST(PartialName, OthersOfSuchANameStay) {
  const TemporaryFolder folder;
  const std::vector<std::string> names{"film.mkv", "film.mkv.partial-", "film.mkv.partial-longer1",
                                       "a film.mkv.partial-ABCDEF", "film.mkv.partial-ABCDEF.old"};
  for (const std::string& name : names) {
    std::ofstream(folder / name) << "mine";
    make_old(folder / name);
  }
  const PartialName next(folder / "film.mkv", Kind::kFile);
  for (const std::string& name : names) {
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  }
}

TEST(PartialName, WhereNothingCanBeMadeIsNotMade) {
  EXPECT_FALSE(PartialName("/nowhere/at/all/film.mkv", Kind::kFile).is_made());
  EXPECT_FALSE(PartialName("/nowhere/at/all/film.mkv", Kind::kFolder).is_made());
}

}  // namespace impetus::partial_name_test
