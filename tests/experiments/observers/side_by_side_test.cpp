// Pieces of work shared among threads.
// SPDX-License-Identifier: MIT
#include "experiments/observers/side_by_side.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
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

}  // namespace impetus::side_by_side_test
