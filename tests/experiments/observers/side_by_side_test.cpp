// Pieces of work shared among threads.
// SPDX-License-Identifier: MIT
#include "experiments/observers/side_by_side.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <stdexcept>
#include <thread>
#include <vector>

namespace impetus::side_by_side_test {

TEST(SideBySide, DoesEachPieceOnce) {
  std::vector<std::atomic<int>> done(1000);
  do_side_by_side(done.size(), [&](std::size_t i) { ++done[i]; });
  for (const std::atomic<int>& one : done) {
    EXPECT_EQ(one, 1);
  }
  do_side_by_side(0, [](std::size_t /*none*/) { FAIL(); });
}

TEST(SideBySide, ThrowsWhatAPieceThrew) {
  const auto refuse_seventh = [](std::size_t i) {
    if (i == 7) {
      throw std::invalid_argument("the seventh");
    }
  };
  EXPECT_THROW(do_side_by_side(20, refuse_seventh), std::invalid_argument);
}

TEST(SideBySide, BeginsNoPieceOnceOneHasThrown) {
  std::size_t begun = 0;
  const auto refuse_seventh = [&](std::size_t i) {
    ++begun;
    if (i == 7) {
      throw std::invalid_argument("the seventh");
    }
  };
  EXPECT_THROW(do_side_by_side(20, refuse_seventh, /*jobs=*/1), std::invalid_argument);
  EXPECT_EQ(begun, 8U);
}

TEST(Workers, RunOnceEach) {
  std::vector<std::atomic<int>> runs(5);
  std::atomic<bool> stops{false};
  run_workers(5, stops, [&](std::int64_t job) { ++runs[static_cast<std::size_t>(job)]; });
  for (const std::atomic<int>& one : runs) {
    EXPECT_EQ(one, 1);
  }
  EXPECT_FALSE(stops);
}

TEST(Workers, StopOnceOneHasThrownAndItsFailureIsTheOneThatIsThrown) {
  for (const std::int64_t fails : {0, 1, 2}) {
    std::atomic<int> stopped{0};
    std::atomic<bool> stops{false};
    const auto work = [&](std::int64_t job) {
      if (job == fails) {
        throw std::invalid_argument("the first");
      }
      while (!stops) {
        std::this_thread::yield();
      }
      ++stopped;
      throw std::runtime_error("a later one");
    };
    EXPECT_THROW(run_workers(3, stops, work), std::invalid_argument) << fails;
    EXPECT_EQ(stopped, 2) << fails;
  }
}

}  // namespace impetus::side_by_side_test
