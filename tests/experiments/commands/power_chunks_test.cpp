// `impetus power` in chunks as a researcher meets it: the commands that it prints, and what it
// refuses. That chunks come to the undivided result is tested in tests/cluster.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/program.hpp"
#include "tests/places/places.hpp"

namespace impetus::power_chunks_test {

Words in_chunks(const Words& more) {
  Words words{"power", causality_file(), "--observer", "causality", "--n",
              "4,6",   "--studies",      "2",          "--out",     "the sweep"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Without R nothing can be computed: whoever comes so far has refused nothing before.
ProgramResult without_r(const TemporaryFolder& folder, const Words& arguments) {
  return run_program(folder, arguments, [] { setenv("PATH", "/nowhere", 1); });
}

const std::string kChunks = "the sweep/chunks";

TEST(PowerChunks, AreListedAsCommandsWithTheirStateAndNothingIsWritten) {
  const TemporaryFolder folder;
  const ProgramResult result = without_r(folder, in_chunks({"--chunks", "2", "--list"}));
  const std::string command = program_file() + " power " + causality_file() +
                              " --observer causality --n 4,6 --studies 2 --out 'the sweep' "
                              "--chunks 2";
  EXPECT_EQ(result.output, command + " --chunk 1  # waiting\n" + command +
                               " --chunk 2  # waiting\n"
                               "# 0 of 2 done, 2 waiting\n"
                               "# once all are done, their page: " +
                               command + "\n");
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_FALSE(std::filesystem::exists(folder / "the sweep"));
}

TEST(PowerChunks, ThatFailedAreListedWithTheSentence) {
  const TemporaryFolder folder;
  const ProgramResult failed = without_r(folder, in_chunks({"--chunks", "2", "--chunk", "2"}));
  const std::string sentence =
      "expected R, got no Rscript on the path (apt-get install r-base-core)";
  EXPECT_EQ(failed.errors, "impetus: " + sentence + "\n");
  EXPECT_EQ(failed.status, 2);
  folder.write("the sweep/chunks/chunk-0001.json", "{\"checksum\": \"01");
  const ProgramResult result = without_r(folder, in_chunks({"--chunks", "2", "--list"}));
  EXPECT_NE(result.output.find("--chunk 2  # failed: " + sentence + "\n"), std::string::npos)
      << result.output;
  EXPECT_NE(result.output.find("--chunk 1  # failed: " + kChunks +
                               "/chunk-0001.json: expected a whole chunk, got one that was cut "
                               "short; remove it and compute it again\n"),
            std::string::npos)
      << result.output;
  EXPECT_NE(result.output.find("# 0 of 2 done, 2 failed\n"), std::string::npos) << result.output;
}

TEST(PowerChunks, RefuseNumbersThatAreNone) {
  const TemporaryFolder folder;
  expect_refused(folder, in_chunks({"--chunks", "5"}),
                 "--chunks: expected at most 4, a study in each, got 5");
  expect_refused(folder, in_chunks({"--chunks", "3", "--no-null"}),
                 "--chunks: expected at most 2, a study in each, got 3");
  expect_refused(folder, in_chunks({"--chunks", "2", "--chunk", "3"}),
                 "--chunk: expected from 1 to 2, got 3");
  expect_refused(folder, in_chunks({"--chunk", "1"}), "--chunk requires --chunks");
  expect_refused(folder, in_chunks({"--list"}), "--list requires --chunks");
  EXPECT_FALSE(std::filesystem::exists(folder / "the sweep"));
}

TEST(PowerChunks, ThatAreMissingMakeNoPage) {
  const TemporaryFolder folder;
  folder.write("the sweep/chunks/chunk-0001.running.json", "{}");
  expect_refused(folder, in_chunks({"--chunks", "2"}),
                 kChunks +
                     ": expected all 2 chunks, got 0 of them, without 1, 2; --list prints the "
                     "command of each");
  EXPECT_FALSE(std::filesystem::exists(folder / "the sweep/power.sqlite"));
}

TEST(PowerChunks, AreNotComputedBesideOneThatIsBroken) {
  const TemporaryFolder folder;
  folder.write("the sweep/chunks/chunk-0001.json", "{");
  for (const char* number : {"1", "2"}) {
    expect_refused(folder, in_chunks({"--chunks", "2", "--chunk", number}),
                   kChunks +
                       "/chunk-0001.json: expected a whole chunk, got one that was cut short; "
                       "remove it and compute it again");
  }
  EXPECT_EQ(text_of(folder / "the sweep/chunks/chunk-0001.json"), "{");
}

TEST(PowerChunks, AreNotSimulatedAgainInOnePieceUnasked) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / kChunks);
  expect_refused(folder, in_chunks({}),
                 "the sweep: expected a power analysis in one piece, got one in chunks; --chunks "
                 "and their number reads them together");
}

TEST(PowerChunks, LeaveAFolderOfOtherThingsAlone) {
  const TemporaryFolder folder;
  folder.write("the sweep/thesis.tex", "all of it");
  expect_refused(folder, in_chunks({"--chunks", "2", "--chunk", "1"}),
                 "the sweep: expected a new folder, an empty one or an earlier power analysis, got "
                 "one that holds thesis.tex");
}

TEST(PowerChunks, SayThatTheyHaveNowhereToSimulate) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program(folder, in_chunks({"--chunks", "2", "--chunk", "1"}),
                                           [] { setenv("TMPDIR", "/nowhere", 1); });
  EXPECT_EQ(result.errors,
            "impetus: TMPDIR: expected a folder of this machine to simulate in, got none\n");
  EXPECT_EQ(result.status, 2);
}

TEST(PowerChunks, SayThatTheirFolderCannotBeMade) {
  const TemporaryFolder folder;
  folder.write("a file", "");
  Words words = in_chunks({"--chunks", "2", "--chunk", "1"});
  words[words.size() - 5] = "a file/sweep";
  expect_refused(folder, words,
                 "--out: expected a folder to write to, could not make a file/sweep/chunks");
}

}  // namespace impetus::power_chunks_test
