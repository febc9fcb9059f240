// The ledger of a power analysis: what is done is never done again, what a process was at when it
// was killed is taken up by the next, and no two are at the same.
// SPDX-License-Identifier: MIT
#include "experiments/power/power_ledger.hpp"

#include <SQLiteCpp/Statement.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>

#include "experiments/power/process_mark.hpp"
#include "tests/experiments/power/power_chunks.hpp"
#include "tests/experiments/refusals.hpp"
#include "tests/experiments/temporary_folder.hpp"

namespace impetus::power_ledger_test {

/// Planted and without, numbers 1 to 3, of 10 and 20 participants.
const PowerRequest kRequest{{10, 20}, 3, 3};

class PowerLedgerTest : public testing::Test {
 protected:
  /// As the R script does.
  void write_done(bool effect, int number, int participants) const {
    SQLite::Database database(path().string(), SQLite::OPEN_READWRITE);
    SQLite::Statement row(database, "INSERT INTO study VALUES (?, ?, ?, 1, 'a build', 0.5)");
    row.bind(1, effect ? 1 : 0);
    row.bind(2, number);
    row.bind(3, participants);
    row.exec();
  }

  [[nodiscard]] std::filesystem::path path() const { return folder_ / "power.sqlite"; }

  TemporaryFolder folder_;
};

TEST_F(PowerLedgerTest, GivesEachCellOnceWithTheSizesThatAreMissing) {
  PowerLedger ledger(path(), chunked_question());
  EXPECT_EQ(ledger.missing(kRequest), 12);
  write_done(true, 1, 20);
  write_done(false, 1, 10);
  write_done(false, 1, 20);
  EXPECT_EQ(ledger.missing(kRequest), 9);
  const std::vector<PowerCell> first = ledger.take(kRequest, 2);
  ASSERT_EQ(first.size(), 2U);
  EXPECT_TRUE(first[0].effect);
  EXPECT_EQ(first[0].number, 1);
  EXPECT_EQ(first[0].sizes, std::vector<std::int64_t>{10});
  EXPECT_TRUE(first[1].effect);
  EXPECT_EQ(first[1].number, 2);
  EXPECT_EQ(first[1].sizes, (std::vector<std::int64_t>{10, 20}));
  EXPECT_EQ(ledger.take(kRequest, 100).size(), 3U);
  EXPECT_TRUE(ledger.take(kRequest, 100).empty());
}

TEST_F(PowerLedgerTest, WhatIsGivenBackUndoneIsThereAgain) {
  PowerLedger ledger(path(), chunked_question());
  const std::vector<PowerCell> all = ledger.take(kRequest, 100);
  write_done(true, 1, 10);
  write_done(true, 1, 20);
  ledger.give_back(all);
  const std::vector<PowerCell> again = ledger.take(kRequest, 100);
  EXPECT_EQ(all.size(), 6U);
  EXPECT_EQ(again.size(), 5U);
  EXPECT_FALSE(again.front().effect);
  EXPECT_EQ(again.front().number, 1);
}

TEST_F(PowerLedgerTest, MoreStudiesAndMoreSizesAreWhatIsMissing) {
  PowerLedger ledger(path(), chunked_question());
  for (const int size : {10, 20}) {
    write_done(true, 1, size);
  }
  EXPECT_EQ(ledger.missing({{10, 20}, 1, 0}), 0);
  EXPECT_TRUE(ledger.take({{10, 20}, 1, 0}, 9).empty());
  const std::vector<PowerCell> more = ledger.take({{10, 20, 30}, 2, 0}, 9);
  ASSERT_EQ(more.size(), 2U);
  EXPECT_EQ(more[0].sizes, std::vector<std::int64_t>{30});
  EXPECT_EQ(more[1].sizes, (std::vector<std::int64_t>{10, 20, 30}));
}

TEST_F(PowerLedgerTest, AnotherProcessTakesWhatIsLeftAndAllThatAKilledOneHad) {
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t other = fork();
  if (other == 0) {
    PowerLedger ledger(path(), chunked_question());
    const auto taken = static_cast<char>(ledger.take(kRequest, 4).size());
    if (write(ready[1], &taken, 1) == 1) {
      pause();
    }
    _exit(1);
  }
  char taken = 0;
  ASSERT_EQ(::read(ready[0], &taken, 1), 1);
  EXPECT_EQ(taken, 4);
  PowerLedger ledger(path(), chunked_question());
  EXPECT_EQ(ledger.take(kRequest, 100).size(), 2U);
  EXPECT_TRUE(ledger.take(kRequest, 100).empty());
  kill(other, SIGKILL);
  waitpid(other, nullptr, 0);
  EXPECT_EQ(ledger.take(kRequest, 100).size(), 4U);
}

TEST_F(PowerLedgerTest, RefusesAnotherQuestionAndNamesWhatDiffers) {
  { const PowerLedger ledger(path(), chunked_question()); }
  const auto refused = [&](auto change) {
    PowerQuestion question = chunked_question();
    change(question);
    return refusal([&] { const PowerLedger ledger(path(), question); });
  };
  const std::string expected =
      path().string() + ": expected a ledger of the same question, got one of another ";
  EXPECT_EQ(refused([](PowerQuestion& one) { one.observer = "[]"; }),
            expected + "observer; give another --out");
  EXPECT_EQ(refused([](PowerQuestion& one) { one.model = "mixed"; }),
            expected + "model; give another --out");
  EXPECT_EQ(refused([](PowerQuestion& one) { one.seed = 8; }),
            expected + "seed; give another --out");
  EXPECT_EQ(refused([](PowerQuestion& /*same*/) {}), "accepted");
}

TEST_F(PowerLedgerTest, RefusesAFileThatIsNoLedger) {
  folder_.write("power.sqlite", "a diary");
  EXPECT_NE(refusal([&] {
              const PowerLedger ledger(path(), chunked_question());
            }).find("expected a ledger of a power analysis that can be written"),
            std::string::npos);
  SQLite::Database other((folder_ / "other.sqlite").string(),
                         SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  other.exec("CREATE TABLE a (b)");
  EXPECT_EQ(
      refusal([&] { const PowerLedger ledger(folder_ / "other.sqlite", chunked_question()); }),
      (folder_ / "other.sqlite").string() +
          ": expected a ledger of a power analysis, got another database");
}

TEST(ProcessMark, TellsARunningProcessFromOneThatEndedAndFromWords) {
  EXPECT_TRUE(still_runs(mark_of_this_process()));
  EXPECT_TRUE(is_process_mark(mark_of_this_process()));
  int mark[2];
  ASSERT_EQ(pipe(mark), 0);
  const pid_t child = fork();
  if (child == 0) {
    const std::string own = mark_of_this_process();
    _exit(write(mark[1], own.data(), own.size()) == static_cast<ssize_t>(own.size()) ? 0 : 1);
  }
  waitpid(child, nullptr, 0);
  char text[200];
  const ssize_t length = ::read(mark[0], text, sizeof text);
  ASSERT_GT(length, 0);
  EXPECT_FALSE(still_runs(std::string(text, static_cast<std::size_t>(length))));
  for (const char* words : {"", "a", "a:b", "a:b:c", ":::", "x:1:y", "../..:../..:../.."}) {
    EXPECT_FALSE(still_runs(words)) << words;
    EXPECT_FALSE(is_process_mark(words)) << words;
  }
}

}  // namespace impetus::power_ledger_test
