// A series: the same participant goes through several protocols, in order.
// SPDX-License-Identifier: MIT
#include "experiments/protocol/series_file.hpp"

#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include "experiments/questions/session_pages.hpp"
#include "experiments/settings/input_error.hpp"
#include "tests/experiments/program.hpp"
#include "tests/places/places.hpp"

namespace impetus::series_test {

/// Beside the series, which names no file from elsewhere.
std::string protocol_path(const std::string& name) { return "protocols/" + name + ".json"; }

/// The shipped protocols with their scenes and observers.
struct StudiesFolder : TemporaryFolder {
  StudiesFolder() {
    for (const char* part : {"protocols", "stimuli", "experiments/observers"}) {
      std::filesystem::create_directories((*this / part).parent_path());
      std::filesystem::copy(std::filesystem::path(source_folder()) / part, *this / part,
                            std::filesystem::copy_options::recursive);
    }
  }
};

std::string series_text(const std::string& first, const std::string& second) {
  return R"({"schema_version": 1, "series": "two", "title": "Two of them", "protocols": [")" +
         first + R"(", ")" + second + R"("]})";
}

std::vector<std::string> both(const std::string& participant_option, const std::string& value) {
  return {"run", "two.json",         "--db", "a.sqlite", "--observer", "causality",
          "gap", participant_option, value};
}

std::string asked(const TemporaryFolder& folder, const std::string& sql) {
  SQLite::Database database((folder / "a.sqlite").string(), SQLite::OPEN_READONLY);
  return database.execAndGet(sql).getString();
}

std::string refusal_of(const std::filesystem::path& path) {
  try {
    load_series(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Series, AParticipantGoesThroughAllPartsInOrder) {
  const StudiesFolder folder;
  folder.write("two.json", series_text(protocol_path("causality"), protocol_path("gap")));
  const ProgramResult run = run_program(folder, both("--participant", "P01"));
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run.output, "Saved in a.sqlite: participant P01, sessions 1, 2\n");
  EXPECT_EQ(asked(folder,
                  "SELECT group_concat(name || ' ' || series || ' ' || series_place || ' ' || "
                  "ending) FROM (SELECT * FROM session JOIN enrolment ON enrolment.id = "
                  "enrolment_id JOIN protocol ON protocol.id = protocol_id ORDER BY session.id)"),
            "causality two 1 finished,gap two 2 finished");
}

TEST(Series, TheLastPageOfAPartContinuesAndThatOfTheSeriesCloses) {
  const Text text{"Part 1 of 2 is complete", {}};
  EXPECT_EQ(thanks_page(text, true, {}).choices.front().label, "Continue");
  EXPECT_EQ(thanks_page(text, false, {}).choices.front().label, "Close");
}

TEST(Series, DemographicsAreAskedOnce) {
  const StudiesFolder folder;
  folder.write("two.json", series_text(protocol_path("causality"), protocol_path("gap")));
  ASSERT_EQ(run_program(folder, both("--participant", "P01")).status, 0);
  EXPECT_EQ(asked(folder,
                  "SELECT group_concat(protocol || ' ' || n) FROM (SELECT protocol, count(*) AS n "
                  "FROM questionnaire WHERE kind = 'demographic' GROUP BY protocol)"),
            "causality 3");
  EXPECT_EQ(asked(folder, "SELECT count(*) FROM questionnaire WHERE kind = 'consent'"), "2");
}

TEST(Series, ItGoesOnWithThePartThatIsNotFinished) {
  const StudiesFolder folder;
  folder.write("two.json", series_text(protocol_path("causality"), protocol_path("gap")));
  ASSERT_EQ(run_program(folder, {"run", protocol_path("causality"), "--db", "a.sqlite",
                                 "--observer", "causality", "--participant", "P01"})
                .status,
            0);
  const ProgramResult run = run_program(folder, both("--participant", "P01"));
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run.errors, "note: P01 has finished causality already\n");
  EXPECT_EQ(asked(folder, "SELECT count(*) FROM enrolment WHERE finished_utc IS NOT NULL"), "2");
}

TEST(Series, AGroupGoesThroughAllPartsWhateverRunsBeside) {
  std::vector<std::string> ratings;
  for (const char* jobs : {"1", "3"}) {
    const StudiesFolder folder;
    folder.write("two.json", series_text(protocol_path("causality"), protocol_path("gap")));
    std::vector<std::string> command = both("--participants", "3");
    command.insert(command.end(), {"--jobs", jobs});
    ASSERT_EQ(run_program(folder, command).status, 0);
    ratings.push_back(asked(folder,
                            "SELECT group_concat(protocol || slot || '=' || rating) FROM "
                            "(SELECT * FROM rated_trial ORDER BY participant, protocol, slot)"));
  }
  EXPECT_EQ(ratings[0].size(), ratings[1].size());
  EXPECT_TRUE(ratings[0] == ratings[1]);
  EXPECT_GT(ratings[0].size(), 1000U);
}

TEST(Series, TheShippedOneIsTheThesissThreeExperimentsInTheirOrder) {
  std::vector<std::string> names;
  const std::string file = source_folder() + "/protocols/series/collisions.json";
  for (const auto& protocol : load_series(file).protocols) {
    names.push_back(protocol.stem().string());
  }
  EXPECT_EQ(names, (std::vector<std::string>{"causality", "gap", "response"}));
}

TEST(Series, CheckingItChecksEachOfItsProtocols) {
  const StudiesFolder folder;
  folder.write("two.json", series_text(protocol_path("causality"), protocol_path("gap")));
  const ProgramResult run = run_program(folder, {"check", "two.json"});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_NE(run.output.find("causality.json: valid\n"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("gap.json: valid\n"), std::string::npos) << run.output;
}

TEST(Series, AFileThatIsNotThereIsRefused) {
  const StudiesFolder folder;
  const auto path = folder.write("two.json", series_text(protocol_path("causality"), "no.json"));
  EXPECT_EQ(refusal_of(path),
            path.string() +
                ":/protocols/1: expected a protocol's file, seen from this one, got \"no.json\", "
                "but " +
                (folder / "no.json").string() + ": there is no such file");
}

TEST(Series, AnUnknownKeyIsRefused) {
  const TemporaryFolder folder;
  const auto path =
      folder.write("two.json", R"({"schema_version": 1, "series": "two", "protocol": []})");
  EXPECT_EQ(refusal_of(path), path.string() + ":/: expected the key \"title\", which is missing");
}

TEST(Series, AProtocolInWhichNobodyTakesPartIsRefused) {
  const StudiesFolder folder;
  const std::string nobody = protocol_path("scheduler-distribution");
  folder.write("two.json", series_text(protocol_path("causality"), nobody));
  EXPECT_EQ(refusal_of(folder / "two.json"),
            (folder / "two.json").string() +
                ":/protocols/1: expected a protocol in which people take part, got \"" + nobody +
                "\", in which nobody does");
}

TEST(Series, AsManyObserversAsProtocolsOrOneAreExpected) {
  const StudiesFolder folder;
  folder.write("two.json", series_text(protocol_path("causality"), protocol_path("gap")));
  std::vector<std::string> command = both("--participant", "P01");
  command.insert(command.begin() + 5, "causality");
  const ProgramResult run = run_program(folder, command);
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.errors,
            "impetus: --observer: expected one, or one for each of the 2 protocols, got 3\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.sqlite"));
}

}  // namespace impetus::series_test
