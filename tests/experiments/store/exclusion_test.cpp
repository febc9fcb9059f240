// Exclusions are data: with a reason, taken back by a later row, never deleted.
// SPDX-License-Identifier: MIT
#include "experiments/store/exclusion.hpp"

#include "tests/experiments/program.hpp"
#include "tests/experiments/test_study.hpp"
#include "tests/places/places.hpp"

namespace impetus::exclusion_test {

/// A study that one simulated participant, P01, finished.
std::string finished_study(const TemporaryFolder& folder) {
  const std::string protocol = source_folder() + "/protocols/causality.json";
  EXPECT_EQ(run_program(folder, {"run", protocol, "--db", "a.sqlite", "--observer", "causality",
                                 "--participant", "P01"})
                .status,
            0);
  return (folder / "a.sqlite").string();
}

ProgramResult excluded(const TemporaryFolder& folder, std::vector<std::string> options) {
  std::vector<std::string> command{"exclude", "a.sqlite", "--participant", "P01"};
  command.insert(command.end(), options.begin(), options.end());
  return run_program(folder, command);
}

TEST(Exclusion, ItsReasonStandsInTheViewUntilItIsTakenBack) {
  const TemporaryFolder folder;
  const std::string study = finished_study(folder);
  EXPECT_EQ(excluded(folder, {"--reason", "asleep"}).output,
            "P01: excluded. Nothing was deleted; --take-back undoes it.\n");
  EXPECT_EQ(value_of(study, "SELECT participant || coalesce(trial, '') || reason FROM excluded"),
            "P01asleep");
  EXPECT_EQ(excluded(folder, {"--reason", "was awake", "--take-back"}).output,
            "P01: in again. Nothing was deleted: the study keeps each decision with its reason.\n");
  EXPECT_EQ(value_of(study, "SELECT count(*) FROM excluded"), "0");
  EXPECT_EQ(value_of(study, "SELECT group_concat(reason) FROM exclusion"), "asleep,was awake");
  EXPECT_EQ(value_of(study, "SELECT count(*) FROM rated_trial WHERE phase = 'main'"), "81");
}

TEST(Exclusion, OneTrialIsExcludedAlone) {
  const TemporaryFolder folder;
  const std::string study = finished_study(folder);
  EXPECT_EQ(excluded(folder, {"--trial", "9", "--reason", "phone"}).output,
            "P01, trial 9: excluded. Nothing was deleted; --take-back undoes it.\n");
  EXPECT_EQ(value_of(study, "SELECT group_concat(trial) FROM excluded"), "9");
}

TEST(Exclusion, WhatCannotBeExcludedIsRefusedAndLeavesTheFileAsItIs) {
  const TemporaryFolder folder;
  const std::string study = finished_study(folder);
  const std::string before = text_of(study);
  EXPECT_NE(excluded(folder, {"--reason", " \t"}).errors.find("expected a reason, got none"),
            std::string::npos);
  EXPECT_EQ(excluded(folder, {"--trial", "9999", "--reason", "phone"}).errors,
            "impetus: a.sqlite: expected a trial of P01, got 9999\n");
  EXPECT_EQ(excluded(folder, {"--reason", "back", "--take-back"}).errors,
            "impetus: a.sqlite: P01 is not excluded\n");
  EXPECT_EQ(
      run_program(folder, {"exclude", "a.sqlite", "--participant", "P02", "--reason", "x"}).errors,
      "impetus: a.sqlite: expected a participant of the study, got P02\n");
  EXPECT_EQ(text_of(study), before);
  folder.write("empty.sqlite", "");
  EXPECT_EQ(
      run_program(folder, {"exclude", "empty.sqlite", "--participant", "P01", "--reason", "x"})
          .errors,
      "impetus: empty.sqlite: expected an Impetus study, got an empty file\n");
  EXPECT_EQ(text_of(folder / "empty.sqlite"), "");
  ASSERT_EQ(excluded(folder, {"--reason", "asleep"}).status, 0);
  EXPECT_EQ(excluded(folder, {"--reason", "asleep"}).errors,
            "impetus: a.sqlite: P01 is excluded already\n");
  EXPECT_EQ(excluded(folder, {"--reason", ""}).status, 2);
  EXPECT_EQ(value_of(study, "SELECT count(*) FROM exclusion"), "1");
}

}  // namespace impetus::exclusion_test
