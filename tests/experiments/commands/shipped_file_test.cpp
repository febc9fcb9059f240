// Commands find the program's own protocols and scenes from any folder.
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>

#include "tests/experiments/command_lines.hpp"

namespace impetus::shipped_file_test {

TEST(ShippedFiles, AreFoundFromAnyFolder) {
  const TemporaryFolder folder;  // no protocols lie here
  const ProgramResult checked = run_program(folder, {"check", "protocols/causality.json"});
  EXPECT_EQ(checked.status, 0) << checked.errors;
  std::filesystem::create_directory(folder.path() / "causality");  // nor is this an observer
  const ProgramResult run =
      run_program(folder, {"run", "protocols/causality.json", "--db", "s.sqlite", "--observer",
                           "causality", "--participant", "S01"});
  EXPECT_EQ(run.status, 0) << run.errors;
}

TEST(ShippedFiles, GiveWayToThoseOfTheFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "protocols");
  std::ofstream(folder.path() / "protocols" / "causality.json") << "{}";
  EXPECT_EQ(run_program(folder, {"check", "protocols/causality.json"}).status, 1);
}

TEST(ShippedFiles, ANameThatNobodyHasStaysAsItWasGiven) {
  const TemporaryFolder folder;
  EXPECT_EQ(
      run_program(folder, {"check", "protocols/none.json"}).errors,
      "impetus: protocols/none.json: expected a JSON file, but it cannot be read: there is no "
      "such file\n");
}

}  // namespace impetus::shipped_file_test
