// `impetus extremes` as it is used.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <fstream>

#include "tests/experiments/program.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::extremes_command_test {

TEST(ExtremesCommand, PrintsWhatIsPromisedAndMeasuredAndWritesItAsJson) {
  const TemporaryFolder folder;
  const ProgramResult ran =
      run_program(folder, {"extremes", "--quick", "--only", "speeds-balls", "--json", "a.json"});
  EXPECT_EQ(ran.status, 0) << ran.errors;
  EXPECT_NE(ran.output.find("speeds-balls"), std::string::npos) << ran.output;
  EXPECT_NE(ran.output.find("kept"), std::string::npos);
  EXPECT_NE(ran.output.find("3 promises, 0 not kept"), std::string::npos);
  const json written = json::parse(text_of(folder / "a.json"));
  ASSERT_EQ(written["cases"].size(), 1U);
  const json& one = written["cases"][0];
  EXPECT_EQ(one["case"].get<std::string>(), "speeds-balls");
  EXPECT_EQ(one["promises"][0]["at_most"].get<double>(), 1e-9);
  EXPECT_TRUE(one["promises"][0]["kept"].get<bool>());
}

TEST(ExtremesCommand, RefusesAFileThatIsThereOrCannotBeWrittenBeforeItBegins) {
  const TemporaryFolder folder;
  folder.write("there.json", "mine");
  const auto refusal = [&](const std::string& file) {
    const ProgramResult ran =
        run_program(folder, {"extremes", "--quick", "--only", "speeds-balls", "--json", file});
    EXPECT_EQ(ran.status, 2);
    EXPECT_EQ(ran.output, "");
    return ran.errors;
  };
  EXPECT_EQ(refusal("there.json"), "impetus: there.json: exists already and is not overwritten\n");
  EXPECT_EQ(refusal("none/a.json"),
            "impetus: none/a.json: cannot be written (No such file or directory)\n");
  EXPECT_EQ(text_of(folder / "there.json"), "mine");
}

TEST(ExtremesCommand, RefusesACaseThatThereIsNoneOf) {
  const TemporaryFolder folder;
  const ProgramResult ran = run_program(folder, {"extremes", "--only", "luck"});
  EXPECT_EQ(ran.status, 2);
  EXPECT_TRUE(ran.errors.starts_with(
      "impetus: --only: expected the beginning of one of the cases sizes-balls, "))
      << ran.errors;
  EXPECT_TRUE(ran.errors.ends_with(", got luck\n")) << ran.errors;
}

}  // namespace impetus::extremes_command_test
