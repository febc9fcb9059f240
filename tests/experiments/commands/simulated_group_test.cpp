// A group of simulated participants: made in one go, gone on with, added to.
// SPDX-License-Identifier: MIT
#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include "tests/experiments/program.hpp"
#include "tests/places/places.hpp"

namespace impetus::simulated_group_test {

std::vector<std::string> group_of(int participants, const std::string& file = "a.sqlite") {
  const std::string source = source_folder();
  return {"run",
          source + "/protocols/causality.json",
          "--db",
          file,
          "--observer",
          "causality",
          "--participants",
          std::to_string(participants)};
}

std::string asked(const TemporaryFolder& folder, const std::string& sql,
                  const std::string& file = "a.sqlite") {
  SQLite::Database database((folder / file).string(), SQLite::OPEN_READONLY);
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

TEST(SimulatedGroup, IsInTheFileWhateverSqliteTakesItsNameFor) {
  const TemporaryFolder folder;
  for (const char* file : {":memory:", "file:a?mode=memory"}) {
    ASSERT_EQ(run_program(folder, group_of(1, file)).status, 0);
    EXPECT_EQ(asked(folder, "SELECT count(*) FROM rated_trial WHERE phase = 'main'", file), "81");
  }
}

TEST(SimulatedGroup, LooksAtTheScreenOfTheFileThatIsGiven) {
  const TemporaryFolder folder;
  std::vector<std::string> words = group_of(1);
  words.insert(words.end(), {"--screen", "s.json"});
  const ProgramResult without = run_program(folder, words);
  EXPECT_EQ(without.status, 2);
  EXPECT_EQ(without.errors,
            "impetus: s.json: expected a JSON file, but it cannot be read: there "
            "is no such file\n");
  run_program(folder, {"screen", "--width-cm", "60", "--height-cm", "34", "--distance-cm", "80",
                       "--file", "s.json"});
  ASSERT_EQ(run_program(folder, words).status, 0);
  EXPECT_EQ(
      asked(folder,
            "SELECT screen_width_m || ' ' || screen_height_m || ' ' || screen_width_px || ' ' || "
            "screen_height_px || ' ' || viewing_distance_m || ' ' || screen_measured FROM session"),
      "0.6 0.34 1807 1024 0.8 1");
}

}  // namespace impetus::simulated_group_test
