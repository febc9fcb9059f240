// Chunks of a power analysis: together they are the whole, each once; what is read is bit for bit
// what was written; what is broken, missing or another's is refused in one sentence, and stays.
// SPDX-License-Identifier: MIT
#include "experiments/power/power_chunk.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <bit>
#include <csignal>
#include <string>
#include <utility>

#include "experiments/power/power_ledger.hpp"
#include "tests/experiments/power/power_chunks.hpp"
#include "tests/experiments/refusals.hpp"
#include "tests/experiments/temporary_folder.hpp"

namespace impetus::power_chunk_test {

using Cell = std::pair<std::int64_t, bool>;

std::vector<Cell> names_of(const std::vector<PowerCell>& cells) {
  std::vector<Cell> names;
  for (const PowerCell& cell : cells) {
    names.emplace_back(cell.number, cell.effect);
  }
  return names;
}

TEST(ChunkCells, TogetherAreTheWholeInItsOrderWhateverTheirNumber) {
  for (const auto& [studies, without] : {std::pair{5, 3}, {4, 4}, {7, 0}, {1, 1}}) {
    const std::vector<Cell> whole = names_of(cells_of({{10}, studies, without}));
    EXPECT_EQ(std::ssize(whole), studies + without);
    for (std::int64_t chunks = 1; chunks <= studies + without; ++chunks) {
      std::vector<Cell> joined;
      for (std::int64_t number = 1; number <= chunks; ++number) {
        const auto mine = names_of(cells_of({{10}, studies, without, {number, chunks}}));
        EXPECT_NEAR(static_cast<double>(mine.size()),
                    static_cast<double>(studies + without) / static_cast<double>(chunks), 1.0);
        joined.insert(joined.end(), mine.begin(), mine.end());
      }
      EXPECT_EQ(joined, whole) << chunks << " chunks of " << studies << " + " << without;
    }
  }
}

TEST(ChunkCells, RiseWithTheEffectAndThenWithout) {
  EXPECT_EQ(names_of(cells_of({{10}, 3, 2})),
            (std::vector<Cell>{{1, true}, {1, false}, {2, true}, {2, false}, {3, true}}));
}

class PowerChunkTest : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(int number) const {
    return chunk_file(folder_.path(), number);
  }

  [[nodiscard]] std::string refused(std::int64_t number, auto change) const {
    PowerQuestion question = chunked_question();
    PowerRequest request = chunked_request(number);
    change(question, request);
    return refusal([&] { power_sweep(folder_.path(), question, request).read(number); });
  }

  [[nodiscard]] std::string refused(std::int64_t number) const {
    return refused(number, [](PowerQuestion& /*same*/, PowerRequest& /*same*/) {});
  }

  [[nodiscard]] std::string all_refused() const {
    return refusal([this] { sweep().read_all([](const SweptChunk& /*taken*/) {}); });
  }

  [[nodiscard]] Sweep sweep() const {
    return power_sweep(folder_.path(), chunked_question(), chunked_request());
  }

  void put_all() const {
    for (const int number : {1, 2, 3}) {
      put_chunk(folder_.path(), computed(number));
    }
  }

  TemporaryFolder folder_;
};

void expect_same(const TestedStudy& read, const TestedStudy& written) {
  EXPECT_EQ(read.effect, written.effect);
  EXPECT_EQ(read.number, written.number);
  EXPECT_EQ(read.participants, written.participants);
  EXPECT_EQ(read.seed, written.seed);
  EXPECT_EQ(read.build, written.build);
  EXPECT_EQ(read.simulated_s, written.simulated_s);
  ASSERT_EQ(read.tests.size(), written.tests.size());
  for (std::size_t i = 0; i < read.tests.size(); ++i) {
    EXPECT_EQ(read.tests[i].factor, written.tests[i].factor);
    EXPECT_EQ(read.tests[i].method, written.tests[i].method);
    EXPECT_EQ(read.tests[i].remark, written.tests[i].remark);
    ASSERT_EQ(read.tests[i].p.has_value(), written.tests[i].p.has_value());
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read.tests[i].p.value_or(0.0)),
              std::bit_cast<std::uint64_t>(written.tests[i].p.value_or(0.0)));
  }
}

void expect_same(const std::vector<TestedStudy>& read, const std::vector<TestedStudy>& written) {
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    expect_same(read[i], written[i]);
  }
}

TEST_F(PowerChunkTest, IsReadBitForBitAsItWasWritten) {
  put_all();
  const SweptChunk read = sweep().read(2);
  EXPECT_EQ(read.build, "build A");
  EXPECT_EQ(read.took_s, 12.5);
  expect_same(tested_studies(read), computed(2).studies);
}

TEST_F(PowerChunkTest, AllOfThemAreTheWholeInTheLedgerOnceHoweverOftenTheyAreAdded) {
  put_all();
  PowerRequest whole = chunked_request();
  whole.chunk = {};
  std::vector<TestedStudy> expected;
  for (const PowerCell& cell : cells_of(whole)) {
    for (const std::int64_t size : cell.sizes) {
      expected.push_back(tested_study(cell, size));
    }
  }
  PowerLedger ledger(folder_ / "power.sqlite", chunked_question());
  for (int time = 0; time < 2; ++time) {
    sweep().read_all([&](const SweptChunk& chunk) { ledger.add(tested_studies(chunk)); });
    expect_same(ledger.studies(), expected);
  }
  EXPECT_EQ(ledger.missing(whole), 0);
}

TEST_F(PowerChunkTest, ThatIsMissingIsNamed) {
  put_chunk(folder_.path(), computed(2));
  EXPECT_EQ(all_refused(), chunk_folder(folder_.path()).string() +
                               ": expected all 3 chunks, got 1 of them, without 1, 3; --list "
                               "prints the command of each");
}

TEST_F(PowerChunkTest, ThatWasCutShortIsRefusedAtWhateverByteAndStays) {
  put_all();
  const std::string whole = text_of(file(2));
  for (std::size_t length = 0; length + 1 < whole.size(); length += 1 + length / 7) {
    folder_.write("chunks/chunk-0002.json", whole.substr(0, length));
    EXPECT_EQ(all_refused(), file(2).string() +
                                 ": expected a whole chunk, got one that was cut short; remove it "
                                 "and compute it again")
        << length;
    EXPECT_EQ(text_of(file(2)).size(), length);
  }
  folder_.write("chunks/chunk-0002.json", std::string(whole.size(), '\0'));
  EXPECT_NE(all_refused().find("got one that was cut short"), std::string::npos);
}

TEST_F(PowerChunkTest, ThatWasChangedOrIsOtherJsonIsRefused) {
  put_all();
  std::string text = text_of(file(1));
  text.replace(text.find("7000001"), 7, "7000002");
  folder_.write("chunks/chunk-0001.json", text);
  EXPECT_EQ(refused(1), file(1).string() +
                            ": expected a chunk as it was written, got one that was changed since; "
                            "remove it and compute it again");
  folder_.write("chunks/chunk-0001.json", "[1, 2]");
  EXPECT_EQ(refused(1), file(1).string() +
                            ": expected a chunk of a power analysis, got other JSON; remove it and "
                            "compute it again");
}

TEST_F(PowerChunkTest, OfAnotherQuestionOrOtherOptionsIsRefusedAndSaysWhatDiffers) {
  put_all();
  const auto another = [&](const std::string& words) {
    return file(1).string() + ": expected a chunk of the same question, got one of another " +
           words + "; give another --out";
  };
  using Q = PowerQuestion;
  using R = PowerRequest;
  EXPECT_EQ(refused(1, [](Q& one, R& /*same*/) { one.protocol_hash = "4567"; }),
            another("version of the protocol"));
  EXPECT_EQ(refused(1, [](Q& one, R& /*same*/) { one.observer = "{}"; }), another("observer"));
  EXPECT_EQ(refused(1, [](Q& one, R& /*same*/) { one.screen = "small"; }), another("screen"));
  EXPECT_EQ(refused(1, [](Q& one, R& /*same*/) { one.seed = 8; }), another("seed"));
  EXPECT_EQ(refused(1, [](Q& /*same*/, R& one) { one.sizes = {10}; }),
            another("choice of numbers of participants"));
  EXPECT_EQ(refused(1, [](Q& /*same*/, R& one) { one.studies = 6; }), another("number of studies"));
  EXPECT_EQ(refused(1, [](Q& /*same*/, R& one) { one.null_studies = 0; }),
            another("number of studies without the effect"));
  EXPECT_EQ(refused(1, [](Q& /*same*/, R& one) { one.chunk.of = 4; }), another("number of chunks"));
  EXPECT_EQ(refused(1), "accepted");
}

TEST_F(PowerChunkTest, UnderAnotherNumberOrWithStudiesMissingIsRefused) {
  put_all();
  std::filesystem::copy_file(file(1), file(3), std::filesystem::copy_options::overwrite_existing);
  EXPECT_EQ(all_refused(),
            file(3).string() + ": expected chunk 3, got chunk 1; remove it and compute it again");
  PowerChunk short_of_one = computed(3);
  short_of_one.studies.pop_back();
  put_chunk(folder_.path(), short_of_one);
  EXPECT_EQ(all_refused(), file(3).string() +
                               ": expected all studies of its chunk, got others; remove it and "
                               "compute it again");
}

TEST_F(PowerChunkTest, OfTwoBuildsAreNotMixed) {
  put_all();
  PowerChunk later = computed(2);
  later.build = "build B";
  put_chunk(folder_.path(), later);
  EXPECT_EQ(all_refused(), file(2).string() +
                               ": expected a chunk of the build of the others, build A, got one of "
                               "build B; remove it and compute it again");
  const auto begun_by = [&](const char* build) {
    return refusal([&] { sweep().require_build(build); });
  };
  EXPECT_EQ(begun_by("build A"), "accepted");
  EXPECT_EQ(begun_by("build C"), file(1).string() +
                                     ": expected a chunk of this build, build C, got one of build "
                                     "A; go on with that build, or give another --out");
}

TEST_F(PowerChunkTest, OfAnotherBuildThanTheLedgersChangesNothingInIt) {
  PowerLedger ledger(folder_ / "power.sqlite", chunked_question());
  ledger.add(computed(1).studies);
  std::vector<TestedStudy> others = computed(2).studies;
  for (TestedStudy& study : others) {
    study.build = "build B";
  }
  EXPECT_EQ(refusal([&] { ledger.add(others); }),
            (folder_ / "power.sqlite").string() +
                ": expected studies of the build of the chunks, build B, got some of build A; give "
                "another --out");
  expect_same(ledger.studies(), computed(1).studies);
}

/// In a process that can write no file of more than `most` bytes: the sentence of its failure.
std::string written_within(rlim_t most, const std::filesystem::path& out, const PowerChunk& chunk) {
  int sentence[2];
  EXPECT_EQ(pipe(sentence), 0);
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limit{most, most};
    std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &limit);
    std::string words = "written";
    try {
      write_chunk(out, chunk);
    } catch (const std::exception& error) {
      words = error.what();
    }
    _exit(::write(sentence[1], words.data(), words.size()) > 0 ? 0 : 1);
  }
  close(sentence[1]);
  char text[500];
  const ssize_t length = ::read(sentence[0], text, sizeof text);
  close(sentence[0]);
  waitpid(child, nullptr, 0);
  return {text, static_cast<std::size_t>(std::max<ssize_t>(length, 0))};
}

TEST_F(PowerChunkTest, ThatCannotBeWrittenLeavesNothingAndSaysSo) {
  std::filesystem::create_directories(chunk_folder(folder_.path()));
  EXPECT_EQ(written_within(500, folder_.path(), computed(1)),
            file(1).string() + ": cannot be written (File too large)");
  EXPECT_TRUE(std::filesystem::is_empty(chunk_folder(folder_.path())));
  EXPECT_EQ(written_within(1'000'000, folder_.path(), computed(1)), "written");
}

}  // namespace impetus::power_chunk_test
