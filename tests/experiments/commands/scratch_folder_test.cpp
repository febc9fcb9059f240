// Folders for what is thrown away: those of killed processes go, a user's own stay.
// SPDX-License-Identifier: MIT
#include "experiments/commands/scratch_folder.hpp"

#include <gtest/gtest.h>

#include "tests/experiments/temporary_folder.hpp"

namespace impetus::scratch_folder_test {

TEST(ScratchFolder, RemovesWhatAKilledProcessLeftAndNothingElseThatBeginsSo) {
  const TemporaryFolder folder;
  const std::string killed = "simulating-0b1c:1:999999999999";  // 1 runs, and began at another time
  folder.write(killed + "/studies.tsv", "");
  folder.write("simulating-notes/mine.txt", "mine");
  folder.write("simulating-a:b:c", "mine");
  std::filesystem::path own;
  {
    const ScratchFolder scratch(folder.path(), "simulating-");
    own = scratch.path();
    EXPECT_TRUE(std::filesystem::is_directory(own));
  }
  EXPECT_FALSE(std::filesystem::exists(own));
  EXPECT_FALSE(std::filesystem::exists(folder / killed));
  EXPECT_EQ(text_of(folder / "simulating-notes/mine.txt"), "mine");
  EXPECT_EQ(text_of(folder / "simulating-a:b:c"), "mine");
}

}  // namespace impetus::scratch_folder_test
