// A group of simulated participants: made in one go, gone on with, added to.
// SPDX-License-Identifier: MIT
#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include "tests/experiments/program.hpp"
#include "tests/places/places.hpp"

namespace impetus::simulated_group_test {

std::vector<std::string> group_of(int participants) {
  const std::string source = source_folder();
  return {"run",
          source + "/protocols/causality.json",
          "--db",
          "a.sqlite",
          "--observer",
          "causality",
          "--participants",
          std::to_string(participants)};
}

std::string asked(const TemporaryFolder& folder, const std::string& sql) {
  SQLite::Database database((folder / "a.sqlite").string(), SQLite::OPEN_READONLY);
  return database.execAndGet(sql).getString();
}

TEST(SimulatedGroup, AskedForAgainItGoesOnWithWhoHasNotFinished) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program(folder, group_of(2)).status, 0);
  const std::string ratings =
      "SELECT group_concat(rating) FROM (SELECT rating FROM rated_trial "
      "WHERE participant IN ('S01', 'S02') ORDER BY participant, slot)";
  const std::string before = asked(folder, ratings);
  const ProgramResult more = run_program(folder, group_of(3));
  EXPECT_EQ(more.status, 0);
  EXPECT_EQ(more.output, "Saved in a.sqlite: participants S01 to S03\n");
  EXPECT_EQ(more.errors, "simulated participant 3 of 3\nnote: 2 of them had finished before\n");
  EXPECT_EQ(asked(folder, ratings), before);
  EXPECT_EQ(asked(folder, "SELECT count(*) FROM enrolment_summary WHERE completed_trials = 81"),
            "3");
}

}  // namespace impetus::simulated_group_test
