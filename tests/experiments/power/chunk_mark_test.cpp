// Marks of who is at a chunk: told while it runs, gone once it is done, and no longer believed when
// they have fallen silent.
// SPDX-License-Identifier: MIT
#include "experiments/power/chunk_mark.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/experiments/power/power_chunks.hpp"
#include "tests/experiments/temporary_folder.hpp"

namespace impetus::chunk_mark_test {

double now_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

class ChunkMarkTest : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(chunk_folder(folder_.path())); }

  [[nodiscard]] ChunkReport report() const { return report_of_chunk(folder_.path(), 1); }

  /// As left by a machine whose last word was so long ago.
  void leave_mark(double told_s_ago) const {
    const nlohmann::json mark{{"machine", "node3"},
                              {"process", 1},
                              {"began_s", now_s() - 600.0},
                              {"told_s", now_s() - told_s_ago},
                              {"share", 0.4}};
    folder_.write("chunks/chunk-0001.running.json", mark.dump());
  }

  TemporaryFolder folder_;
};

TEST_F(ChunkMarkTest, IsThereWhileItLives) {
  EXPECT_EQ(report().state, ChunkState::kWaiting);
  {
    const ChunkMark mark(folder_.path(), 1);
    EXPECT_EQ(report().state, ChunkState::kRunning);
    EXPECT_FALSE(report().machine.empty());
    EXPECT_EQ(report_of_chunk(folder_.path(), 2).state, ChunkState::kWaiting);
  }
  EXPECT_EQ(report().state, ChunkState::kWaiting);
  EXPECT_TRUE(std::filesystem::is_empty(chunk_folder(folder_.path())));
}

TEST_F(ChunkMarkTest, OfAFailureStaysUntilAnotherAttemptBegins) {
  ChunkMark(folder_.path(), 1).fail("the disk is full");
  EXPECT_EQ(report().state, ChunkState::kFailed);
  EXPECT_EQ(report().sentence, "the disk is full");
  {
    const ChunkMark again(folder_.path(), 1);
    EXPECT_EQ(report().state, ChunkState::kRunning);
  }
  EXPECT_EQ(report().state, ChunkState::kWaiting);
}

TEST_F(ChunkMarkTest, ThatHasFallenSilentIsToldOfAndNotTrusted) {
  leave_mark(30.0);
  EXPECT_EQ(report().state, ChunkState::kRunning);
  EXPECT_EQ(report().machine, "node3");
  EXPECT_DOUBLE_EQ(report().share, 0.4);
  EXPECT_NEAR(report().since_s, 600.0, 60.0);  // a slow machine
  leave_mark(300.0);
  EXPECT_EQ(report().state, ChunkState::kSilent);
  EXPECT_NEAR(report().since_s, 300.0, 60.0);
  put_chunk(folder_.path(), computed(1));
  EXPECT_EQ(report().state, ChunkState::kDone);
}

TEST_F(ChunkMarkTest, OfAProcessOfThisMachineThatWasKilledIsSilentAtOnce) {
  const pid_t child = fork();
  if (child == 0) {
    const ChunkMark mark(folder_.path(), 1);
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
  EXPECT_EQ(report().state, ChunkState::kSilent);
  EXPECT_LT(report().since_s, 60.0);
  const ChunkMark again(folder_.path(), 1);
  EXPECT_EQ(report().state, ChunkState::kRunning);
}

TEST_F(ChunkMarkTest, OfOtherWordsSaysNothing) {
  for (const char* words : {"", "{", "[]", "{\"told_s\": \"now\"}", "7"}) {
    folder_.write("chunks/chunk-0001.running.json", words);
    EXPECT_EQ(report().state, ChunkState::kWaiting) << words;
  }
}

TEST_F(ChunkMarkTest, ThatCannotBeWrittenIsMissingAndNothingElse) {
  const TemporaryFolder none;
  const ChunkMark mark(none / "not there", 1);
  mark.fail("anything");
  EXPECT_TRUE(std::filesystem::is_empty(none.path()));
}

TEST(SweepSums, CountStatesAndTellTheTimeThatIsLeft) {
  const auto chunk = [](ChunkState state, double share = 0.0) {
    ChunkReport report;
    report.state = state;
    report.share = share;
    return report;
  };
  const std::vector<ChunkReport> reports{
      chunk(ChunkState::kDone),    chunk(ChunkState::kRunning, 0.5),
      chunk(ChunkState::kRunning), chunk(ChunkState::kWaiting),
      chunk(ChunkState::kFailed),  chunk(ChunkState::kSilent, 0.9)};
  const SweepSums sums = sums_of(reports, 100.0);
  EXPECT_EQ(sums.done, 1);
  EXPECT_EQ(sums.running, 2);
  EXPECT_EQ(sums.waiting, 1);
  EXPECT_EQ(sums.failed, 1);
  EXPECT_EQ(sums.silent, 1);
  // Half of one and one of those that run, and three to be begun (what a killed one did is lost),
  // by two at a time: 4.5 x 100 s / 2.
  EXPECT_DOUBLE_EQ(sums.left_s, 225.0);
  EXPECT_DOUBLE_EQ(sums_of({chunk(ChunkState::kWaiting)}, 100.0).left_s, 100.0);
  EXPECT_DOUBLE_EQ(sums_of({chunk(ChunkState::kDone)}, 100.0).left_s, 0.0);
  EXPECT_DOUBLE_EQ(sums_of(reports, 0.0).left_s, 0.0);
}

}  // namespace impetus::chunk_mark_test
