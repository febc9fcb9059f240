// Parameter recoveries: what is read of chunks is what was written, whatever their number; what
// they come to together is counted right; what is broken or another's is refused.
// SPDX-License-Identifier: MIT
#include "experiments/power/recovery.hpp"

#include <gtest/gtest.h>

#include "tests/experiments/refusals.hpp"
#include "tests/experiments/temporary_folder.hpp"

namespace impetus::recovery_test {

RecoveryQuestion question() {
  return {"gap", "0123456789abcdef", "gap", R"({"a": 1})", "{}", 8, 10, 3};
}

RecoveredParameter width(double value, double low, double high) {
  return {"width", 2.0, value, low, high};
}

/// A third has no short decimal; the width of every other study is not identified.
RecoveredStudy study(std::int64_t number) {
  const double x = static_cast<double>(number);
  RecoveredStudy one{number, 3'000'000 + static_cast<std::uint64_t>(number), {}};
  one.parameters.push_back({"threshold", 10.0, 10.0 + x / 3.0, 9.0 + x / 3.0, 11.0 + x / 3.0});
  one.parameters.push_back(number % 2 == 0 ? width(2.5, 1.0, 4.0) : width(2.0, 2.0, 2.0));
  one.parameters.back().held_because = number % 2 == 0 ? "" : "the study does not identify it";
  return one;
}

class RecoveryTest : public testing::Test {
 protected:
  void put(const ChunkNumber& chunk, const std::string& build = "build A") const {
    RecoveryChunk done{question(), chunk, build, 2.5, {}};
    for (const std::int64_t number : numbers_of(chunk, done.question.studies)) {
      done.studies.push_back(study(number));
    }
    std::filesystem::create_directories(chunk_folder(folder_.path()));
    write_chunk(folder_.path(), done);
  }
  [[nodiscard]] Sweep sweep(std::int64_t chunks) const {
    return recovery_sweep(folder_.path(), question(), chunks);
  }
  [[nodiscard]] std::string file(int number) const {
    return chunk_file(folder_.path(), number).string();
  }

  TemporaryFolder folder_;
};

TEST_F(RecoveryTest, IsTheSameHoweverManyChunksThereWere) {
  for (const std::int64_t chunks : {1, 3, 10}) {
    for (std::int64_t number = 1; number <= chunks; ++number) {
      put({number, chunks});
    }
    const std::vector<RecoveredStudy> all = read_studies(sweep(chunks));
    ASSERT_EQ(all.size(), 10U);
    for (std::int64_t number = 1; number <= 10; ++number) {
      EXPECT_EQ(all[static_cast<std::size_t>(number - 1)], study(number));
    }
  }
}

TEST_F(RecoveryTest, RefusesWhatDoesNotBelongTogether) {
  put({1, 2});
  put({2, 2});
  const auto refused = [&](auto change) {
    RecoveryQuestion other = question();
    change(other);
    return refusal([&] { recovery_sweep(folder_.path(), other, 2).read(1); });
  };
  const std::string same = file(1) + ": expected a chunk of the same question, got one of another ";
  EXPECT_EQ(refused([](RecoveryQuestion& q) { q.protocol_hash = "f"; }),
            same + "version of the protocol; give another --out");
  EXPECT_EQ(refused([](RecoveryQuestion& q) { q.observer = "{}"; }),
            same + "observer; give another --out");
  EXPECT_EQ(refused([](RecoveryQuestion& q) { q.participants = 9; }),
            same + "number of participants; give another --out");
  EXPECT_EQ(refused([](RecoveryQuestion& q) { q.seed = 4; }), same + "seed; give another --out");
  EXPECT_EQ(refusal([&] { sweep(5).read(1); }), same + "number of chunks; give another --out");
  EXPECT_EQ(refusal([&] { sweep(2).require_build("build B"); }),
            file(1) +
                ": expected a chunk of this build, build B, got one of build A; go on with "
                "that build, or give another --out");
  put({2, 2}, "build B");
  EXPECT_EQ(refusal([&] { read_studies(sweep(2)); }),
            file(2) +
                ": expected a chunk of the build of the others, build A, got one of build B; "
                "remove it and compute it again");
  std::filesystem::remove(file(2));
  EXPECT_EQ(refusal([&] { read_studies(sweep(2)); }),
            chunk_folder(folder_.path()).string() +
                ": expected all 2 chunks, got 1 of them, without 2; --list prints the command of "
                "each");
}

TEST_F(RecoveryTest, RefusesWhatIsBroken) {
  put({1, 1});
  std::string text = text_of(file(1));
  folder_.write("chunks/chunk-0001.json", text.substr(0, text.size() / 2));
  const auto refused = [&] { return refusal([&] { sweep(1).read(1); }); };
  EXPECT_EQ(refused(), file(1) +
                           ": expected a whole chunk, got one that was cut short; remove it "
                           "and compute it again");
  const std::size_t place = text.find("10.3");
  text[place + 1] = '1';
  folder_.write("chunks/chunk-0001.json", text);
  EXPECT_EQ(refused(), file(1) +
                           ": expected a chunk as it was written, got one that was changed "
                           "since; remove it and compute it again");
  write_chunk_value(file(1), {"power", 2, "a power analysis"}, {{"chunk", 1}});
  EXPECT_EQ(refused(), file(1) +
                           ": expected a chunk of a parameter recovery, got one of another "
                           "sweep; remove it and compute it again");
}

TEST_F(RecoveryTest, CountsWhatWasFittedAndWhatItsIntervalsHold) {
  std::vector<RecoveredStudy> studies;
  for (std::int64_t number = 1; number <= 10; ++number) {
    studies.push_back(study(number));
  }
  const std::vector<ParameterRecovery> all = recovery_of(studies);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].fitted, 10);
  EXPECT_EQ(all[0].covered, 3);  // 10 ± 1 holds 10 + x / 3 for x = 1, 2, 3
  EXPECT_NEAR(all[0].mean, 10.0 + 5.5 / 3.0, 1e-12);
  EXPECT_NEAR(all[0].sd, std::sqrt(110.0 / 12.0) / 3.0, 1e-12);  // of 1 … 10: √(n(n + 1)/12)
  EXPECT_NEAR(all[0].median_width, 2.0, 1e-12);
  EXPECT_EQ(all[1].fitted, 5);
  EXPECT_EQ(all[1].not_identified, 5);
  EXPECT_EQ(all[1].covered, 5);
}

// Newcombe 1998, table I: 81 of 263, and 0 of 20.
TEST_F(RecoveryTest, SharesHaveWilsonsInterval) {
  EXPECT_NEAR(wilson_interval(81, 263).low, 0.2553, 5e-5);
  EXPECT_NEAR(wilson_interval(81, 263).high, 0.3662, 5e-5);
  EXPECT_NEAR(wilson_interval(0, 20).low, 0.0, 5e-5);
  EXPECT_NEAR(wilson_interval(0, 20).high, 0.1611, 5e-5);
}

TEST_F(RecoveryTest, ThePageHasARowForEachAndAStarWhereTheIntervalsDoNotHold) {
  std::vector<RecoveredStudy> studies;
  for (std::int64_t number = 1; number <= 10; ++number) {
    studies.push_back(study(number));
  }
  studies.push_back({11, 1, {}, "expected answers that differ"});
  const std::string page = recovery_page(question(), studies);
  EXPECT_NE(
      page.find("| threshold | 10 | 11.83 | 1.833 | 1.009 | 30.0 (10.8 to 60.3) * | 2 | 10 of "
                "10 |"),
      std::string::npos)
      << page;
  EXPECT_NE(page.find("| width | 2 | 2.5 | 0.5 | 0 | 100.0 (56.6 to 100.0) | 3 | 5 of 10 |"),
            std::string::npos)
      << page;
  EXPECT_NE(page.find("1 could not be fitted"), std::string::npos);
  EXPECT_NE(page.find("- study 11: expected answers that differ"), std::string::npos);
  const std::string csv = recovery_csv(studies);
  EXPECT_NE(csv.find("1,3000001,width,2,,,,,the study does not identify it\n"), std::string::npos)
      << csv;
  EXPECT_NE(csv.find("2,3000002,width,2,2.5,1,4,1,\n"), std::string::npos) << csv;
}

}  // namespace impetus::recovery_test
