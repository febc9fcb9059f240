// `impetus report` as a researcher meets it: what it refuses, and that nothing is left behind then.
// What the page says is tested in tests/analysis/test_report.R and report_test.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include "experiments/exports/r_scripts.hpp"
#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/program.hpp"
#include "tests/places/places.hpp"

namespace impetus::report_command_test {

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

/// A folder with a study of one participant.
class ReportCommand : public testing::Test {
 protected:
  void SetUp() override {
    const ProgramResult run = run_program(folder_, simulated_run({"--participant", "P01"}));
    ASSERT_EQ(run.status, 0) << run.errors;
  }

  [[nodiscard]] std::string refusal_to_overwrite(const std::string& why) const {
    return (folder_ / "out").string() +
           ": expected a new folder, an empty one or an earlier report, got one " + why;
  }

  TemporaryFolder folder_;
};

TEST_F(ReportCommand, LeavesAFolderOfOtherThingsAlone) {
  folder_.write("out/report.html", "<p>");
  folder_.write("out/thesis.tex", "all of it");
  expect_refused(folder_, {"report", "a.sqlite", "--out", "out"},
                 refusal_to_overwrite("that holds thesis.tex"));
  EXPECT_EQ(text_of(folder_ / "out/thesis.tex"), "all of it");
}

TEST_F(ReportCommand, LeavesAReportAloneThatHoldsSomethingElse) {
  folder_.write("out/report.html", "<p>");
  folder_.write("out/figures/causality-rating-1.svg", "<svg/>");
  folder_.write("out/figures/mine/plot.svg", "mine");
  expect_refused(folder_, {"report", "a.sqlite", "--out", "out"},
                 refusal_to_overwrite("that holds figures/mine/plot.svg"));
  EXPECT_EQ(text_of(folder_ / "out/figures/mine/plot.svg"), "mine");
}

TEST_F(ReportCommand, ReplacesWhatAReportListsAndNothingElse) {
  const std::filesystem::path rscript =
      folder_.write("bin/Rscript",
                    "#!/bin/sh\nwhile [ \"$1\" != --out ]; do shift; done\nmkdir \"$2/tables\" "
                    "\"$2/figures\"\necho 1 >\"$2/tables/own.csv\"\necho 1 >\"$2/report.html\"\n");
  std::filesystem::permissions(rscript, std::filesystem::perms::owner_all);
  const std::string path = rscript.parent_path().string() + ":/usr/bin:/bin";
  const auto report = [&] {
    return run_program(folder_, {"report", "a.sqlite", "--out", "out"},
                       [&path] { setenv("PATH", path.c_str(), 1); });
  };
  for (int i = 0; i < 2; ++i) {
    const ProgramResult written = report();
    ASSERT_EQ(written.status, 0) << written.errors;
  }
  for (const char* mine : {"tables/mine.csv", "analysis/R/mine.R", "data/mine.csv"}) {
    folder_.write("out/" + std::string(mine), "mine");
    EXPECT_EQ(report().errors,
              "impetus: " + refusal_to_overwrite("that holds " + std::string(mine)) + "\n");
    EXPECT_EQ(text_of(folder_ / ("out/" + std::string(mine))), "mine");
    std::filesystem::remove(folder_ / ("out/" + std::string(mine)));
  }
}

TEST_F(ReportCommand, TakesAFolderOfDataForNoReport) {
  folder_.write("out/data/a.csv", "1");
  expect_refused(folder_, {"report", "a.sqlite", "--out", "out"},
                 refusal_to_overwrite("without report.html"));
}

TEST_F(ReportCommand, RefusesWhatIsNoStudy) {
  folder_.write("b.sqlite", "words");
  const ProgramResult result = run_program(folder_, {"report", "b.sqlite", "--out", "out"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.errors.rfind("impetus: b.sqlite: expected an Impetus study", 0), 0U)
      << result.errors;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(ReportCommand, WithoutRSaysSoAndLeavesNothingBehind) {
  folder_.write("out/report.html", "an earlier report");
  const std::set<std::string> before = names_in(folder_.path());
  const ProgramResult result = run_program(folder_, {"report", "a.sqlite", "--out", "out"},
                                           [] { setenv("PATH", "/nowhere", 1); });
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.errors,
            "impetus: expected R, got no Rscript on the path (apt-get install r-base-core)\n");
  EXPECT_EQ(result.output, "");
  std::set<std::string> after = names_in(folder_.path());
  after.erase("stdout");
  after.erase("stderr");
  std::set<std::string> expected = before;
  expected.erase("stdout");
  expected.erase("stderr");
  EXPECT_EQ(after, expected);
  EXPECT_EQ(text_of(folder_ / "out/report.html"), "an earlier report");
}

TEST_F(ReportCommand, PassesOnWhyRRefusesAndLeavesNothingBehind) {
  const std::filesystem::path rscript = folder_.write(
      "bin/Rscript", "#!/bin/sh\necho 'report.R: expected these R packages' >&2\nexit 2\n");
  std::filesystem::permissions(rscript, std::filesystem::perms::owner_all);
  const std::string path = rscript.parent_path().string() + ":/usr/bin:/bin";
  const ProgramResult result = run_program(folder_, {"report", "a.sqlite", "--out", "out"},
                                           [&path] { setenv("PATH", path.c_str(), 1); });
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.errors, "report.R: expected these R packages\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST(RScripts, AreThoseOfTheRepository) {
  const TemporaryFolder folder;
  const std::filesystem::path script = write_r_scripts(folder.path(), {"report.R"}) / "report.R";
  const std::filesystem::path source = std::filesystem::path(source_folder()) / "analysis";
  EXPECT_EQ(text_of(script), text_of(source / "report.R"));
  EXPECT_EQ(names_in(script.parent_path() / "R"), names_in(source / "R"));
  for (const std::string& name : names_in(source / "R")) {
    EXPECT_EQ(text_of(script.parent_path() / "R" / name), text_of(source / "R" / name)) << name;
  }
}

}  // namespace impetus::report_command_test
