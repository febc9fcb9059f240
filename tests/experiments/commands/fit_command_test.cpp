// `impetus fit` from outside: a simulated study in, a participant file and a page out.
// SPDX-License-Identifier: MIT
#include <SQLiteCpp/Database.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/experiments/command_lines.hpp"
#include "tests/places/places.hpp"

namespace impetus::fit_command_test {

using nlohmann::json;

/// Three participants of the causality study, simulated and fitted once.
class FittedStudy {
 public:
  FittedStudy() {
    ran_ = run_program(folder_, simulated_run({"--participants", "3"}));
    fitted_ =
        run_program(folder_, {"fit", "a.sqlite", "--observer", "causality", "--out", "fitted.json",
                              "--compare", "null-causality", "--folds", "3", "--posterior"});
  }
  static const FittedStudy& once() {
    static const FittedStudy study;
    return study;
  }

  [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }
  [[nodiscard]] const ProgramResult& ran() const { return ran_; }
  [[nodiscard]] const ProgramResult& fitted() const { return fitted_; }
  [[nodiscard]] json file() const { return json::parse(text_of(folder_ / "fitted.json")); }

 private:
  TemporaryFolder folder_;
  ProgramResult ran_;
  ProgramResult fitted_;
};

TEST(FitCommand, ParametersSayWhatTheyWereFittedTo) {
  const FittedStudy& study = FittedStudy::once();
  ASSERT_EQ(study.ran().status, 0) << study.ran().errors;
  ASSERT_EQ(study.fitted().status, 0) << study.fitted().errors;
  const json threshold = study.file()["parameters"]["threshold_mean_ms"];
  const std::string source = threshold["source"];
  EXPECT_EQ(source.rfind("fitted to a.sqlite (", 0), 0U) << source;
  EXPECT_NE(source.find("), 3 people"), std::string::npos) << source;
  EXPECT_EQ(threshold["note"].get<std::string>().rfind("95 % interval ", 0), 0U);
  EXPECT_EQ(threshold["unit"], "ms");
}

TEST(FitCommand, WhoGoesByNothingIsComparedAsSuchAndForetellsWorse) {
  const std::string page = text_of(FittedStudy::once().folder() / "fitted.md");
  EXPECT_NE(page.find("causality foretells answers best"), std::string::npos);
  EXPECT_EQ(page.find("null-causality foretells answers best"), std::string::npos);
}

// Of a normal posterior the middle of the draws is near its highest place, which is near the fit.
TEST(FitCommand, ThePosteriorIsDrawnAndToldOnThePage) {
  const FittedStudy& study = FittedStudy::once();
  ASSERT_EQ(study.fitted().status, 0) << study.fitted().errors;
  const std::string page = text_of(study.folder() / "fitted.md");
  EXPECT_NE(page.find("## Posterior"), std::string::npos);
  EXPECT_EQ(page.find("Not to be used"), std::string::npos);
  std::istringstream draws(text_of(study.folder() / "fitted.draws.csv"));
  std::string line;
  std::getline(draws, line);
  ASSERT_EQ(line.rfind("chain,threshold_mean_ms,", 0), 0U) << line;
  std::vector<double> thresholds;
  while (std::getline(draws, line)) {
    thresholds.push_back(std::stod(line.substr(line.find(',') + 1)));
  }
  ASSERT_GE(thresholds.size(), 2000U);
  std::nth_element(thresholds.begin(), thresholds.begin() + thresholds.size() / 2,
                   thresholds.end());
  const json threshold = study.file()["parameters"]["threshold_mean_ms"];
  EXPECT_NEAR(thresholds[thresholds.size() / 2], threshold["value"].get<double>(), 40.0);
}

TEST(FitCommand, WhatIsNotFittedStaysAsAssumed) {
  const json parameters = FittedStudy::once().file()["parameters"];
  for (const char* name : {"reaction_median_ms", "baseline", "effect_sd"}) {
    const std::string source = parameters[name]["source"];
    EXPECT_EQ(source.rfind("assumed", 0), 0U) << name;
  }
  EXPECT_EQ(parameters["reaction_median_ms"]["value"], 900);
}

TEST(FitCommand, ItsFileSimulatesParticipants) {
  const FittedStudy& study = FittedStudy::once();
  const ProgramResult shown = run_program(study.folder(), {"observers", "fitted.json"});
  EXPECT_EQ(shown.status, 0) << shown.errors;
  const ProgramResult run =
      run_program(study.folder(), {"run", causality_file(), "--db", "b.sqlite", "--participant",
                                   "S01", "--observer", "fitted.json"});
  EXPECT_EQ(run.status, 0) << run.errors;
}

TEST(FitCommand, ThePageHasFitComparisonAndResiduals) {
  const std::string page = text_of(FittedStudy::once().folder() / "fitted.md");
  for (const char* part :
       {"# causality, fitted to a.sqlite (", "3 people, 243 completed main trials",
        "No person took part", "| threshold_mean_ms | ", "## Observers compared",
        "| none (goes by nothing that was shown) | ", "## Residuals",
        "Of the rating, in steps from the scale's good end:"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part << "\n" << page;
  }
}

TEST(FitCommand, BesidePeopleNobodyWhoIsSimulatedIsFitted) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program(folder, simulated_run({"--participants", "4"})).status, 0);
  SQLite::Database(folder / "a.sqlite", SQLite::OPEN_READWRITE)
      .exec("UPDATE participant SET simulated = 0 WHERE id > 2");
  const ProgramResult fitted =
      run_program(folder, {"fit", "a.sqlite", "--observer", "causality", "--out", "fitted.json"});
  ASSERT_EQ(fitted.status, 0) << fitted.errors;
  EXPECT_NE(text_of(folder / "fitted.md")
                .find("2 people, 162 completed main trials. 2 simulated are left out, since people "
                      "took part."),
            std::string::npos)
      << text_of(folder / "fitted.md");
}

TEST(FitCommand, ARatingThatNobodyGaveLeavesItsCutsApart) {
  const TemporaryFolder folder;
  run_program(folder, simulated_run({"--participant", "S01"}));
  change(folder, "UPDATE rating SET rating = 3 WHERE rating = 2");
  const ProgramResult fitted =
      run_program(folder, {"fit", "a.sqlite", "--observer", "causality", "--out", "fitted.json"});
  ASSERT_EQ(fitted.status, 0) << fitted.errors;
  const json own = json::parse(text_of(folder / "fitted.json"))["parameters"];
  EXPECT_GT(own["cut_2_3"]["value"], own["cut_1_2"]["value"]);
  EXPECT_LT(own["cut_2_3"]["value"].get<double>(), own["cut_1_2"]["value"].get<double>() + 1e-3);
}

TEST(FitCommand, RefusesInOneSentence) {
  const FittedStudy& study = FittedStudy::once();
  const TemporaryFolder& folder = study.folder();
  const auto fit = [](const std::vector<std::string>& more) {
    std::vector<std::string> words{"fit", "a.sqlite", "--observer", "causality"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  expect_refused(folder, fit({"--out", "fitted.json"}),
                 "fitted.json: exists already and is not overwritten");
  expect_refused(folder, fit({"--out", "x.json", "--code", "P99"}),
                 "a.sqlite: expected completed main trials of P99 that are not excluded, got none");
  expect_refused(folder, fit({"--out", "x.json", "--protocol", "gap"}),
                 "--protocol: expected one of a.sqlite (causality), got gap");
  expect_refused(folder, fit({"--out", "x.md"}),
                 "--out and the page beside it: expected two files, got x.md for both");
  EXPECT_FALSE(std::filesystem::exists(folder / "x.json"));
  EXPECT_FALSE(std::filesystem::exists(folder / "x.md"));
}

TEST(FitCommand, AKindThatCannotBeFittedIsRefused) {
  const FittedStudy& study = FittedStudy::once();
  const ProgramResult result =
      run_program(study.folder(), {"fit", "a.sqlite", "--observer", "response", "--out", "x.json"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.errors.find("/observer: expected a kind that can be fitted (causality, "
                               "counterfactual, foreseeing, gap, gap-thresholds, gaze-contingent, "
                               "launching, psychometric, rebound), got response"),
            std::string::npos)
      << result.errors;
}

}  // namespace impetus::fit_command_test
