// `impetus recover` as a researcher meets it: a small recovery in pieces and at once, and what it
// refuses.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/program.hpp"
#include "tests/places/places.hpp"

namespace impetus::recover_test {

Words recovery(const std::string& out, const Words& more) {
  Words words{"recover", causality_file(), "--observer", "causality", "--n", "1", "--out", out};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Recover, InPiecesIsTheSameAsAtOnce) {
  const TemporaryFolder folder;
  const ProgramResult whole = run_program(folder, recovery("whole", {"--studies", "2"}));
  ASSERT_EQ(whole.status, 0) << whole.errors;
  const Words pieces{"--studies", "2", "--chunks", "2"};
  const auto with = [&](Words more) {
    more.insert(more.begin(), pieces.begin(), pieces.end());
    return recovery("pieces", more);
  };
  const ProgramResult second = run_program(folder, with({"--chunk", "2"}));
  EXPECT_EQ(second.output, "pieces/chunks/chunk-0002.json: done\n") << second.errors;
  const ProgramResult again = run_program(folder, with({"--chunk", "2"}));
  EXPECT_EQ(again.output, "pieces/chunks/chunk-0002.json: is there already\n") << again.errors;
  const ProgramResult list = run_program(folder, with({"--list"}));
  EXPECT_NE(list.output.find("--chunk 1  # waiting\n"), std::string::npos) << list.output;
  EXPECT_NE(list.output.find("--chunk 2  # done\n"), std::string::npos) << list.output;
  EXPECT_FALSE(std::filesystem::exists(folder / "pieces/recovery.md"));
  const ProgramResult rest = run_program(folder, with({}));
  ASSERT_EQ(rest.status, 0) << rest.errors;
  EXPECT_EQ(text_of(folder / "pieces/recovery.csv"), text_of(folder / "whole/recovery.csv"));
  EXPECT_EQ(text_of(folder / "pieces/recovery.md"), text_of(folder / "whole/recovery.md"));
  EXPECT_NE(text_of(folder / "whole/recovery.md").find("| effect |"), std::string::npos);
}

/// One that is whole vouches for no other.
TEST(Recover, AChunkThatIsBrokenIsNotTakenForDone) {
  const TemporaryFolder folder;
  const Words first = recovery("out", {"--studies", "2", "--chunks", "2", "--chunk", "1"});
  ASSERT_EQ(run_program(folder, first).status, 0);
  folder.write("out/chunks/chunk-0002.json", "{");
  expect_refused(folder, recovery("out", {"--studies", "2", "--chunks", "2", "--chunk", "2"}),
                 "out/chunks/chunk-0002.json: expected a whole chunk, got one that was cut short; "
                 "remove it and compute it again");
}

TEST(Recover, RefusesWhatCannotBe) {
  const TemporaryFolder folder;
  expect_refused(folder, recovery("out", {"--studies", "2", "--chunks", "3"}),
                 "--chunks: expected at most 2, a study in each, got 3");
  expect_refused(folder, recovery("out", {"--studies", "4", "--chunks", "2", "--chunk", "3"}),
                 "--chunk: expected from 1 to 2, got 3");
  folder.write("other/file", "");
  expect_refused(folder, recovery("other", {}),
                 "other: expected a new folder, an empty one or an earlier recovery, got one that "
                 "holds file");
  folder.write("broken/chunks/chunk-0001.json", "{");
  expect_refused(folder, recovery("broken", {}),
                 "broken/chunks/chunk-0001.json: expected a whole chunk, got one that was cut "
                 "short; remove it and compute it again");
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace impetus::recover_test
