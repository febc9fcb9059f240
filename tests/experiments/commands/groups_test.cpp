// Factors between participants, from the command line: who joins which group, and who says so.
// SPDX-License-Identifier: MIT
#include "tests/experiments/command_lines.hpp"

namespace impetus::groups_test {

using nlohmann::json;

/// A short causality study, its speed between participants.
std::string grouped_protocol(const TemporaryFolder& folder) {
  changed_protocol(folder, "/design/repetitions", 1);
  json protocol = json::parse(text_of(folder / "protocols/a.json"));
  json& design = protocol["design"];
  design["factors"][1]["between"] = true;
  design["factors"][1]["levels"] = {5, 10};
  design["factors"][2]["levels"] = {0};
  design["practice"] = json::array();
  design.erase("practice_until");
  folder.write("protocols/a.json", protocol.dump());
  return "protocols/a.json";
}

ProgramResult simulated(const TemporaryFolder& folder, const Words& more) {
  Words words{"run", "protocols/a.json", "--db", "a.sqlite", "--observer", "causality"};
  words.insert(words.end(), more.begin(), more.end());
  return run_program(folder, words);
}

/// "5 3, 10 3": each level of the speed and how many participants have it.
std::string sizes(const TemporaryFolder& folder, const std::string& file = "a.sqlite") {
  return value_of(folder,
                  "SELECT group_concat(speed || ' ' || people, ', ') FROM (SELECT speed, "
                  "count(DISTINCT enrolment_id) AS people FROM (SELECT enrolment_id, condition ->> "
                  "'speed_deg_s' AS speed FROM trial) GROUP BY speed ORDER BY speed)",
                  file);
}

/// The groups of all participants in the order of their codes.
std::string groups_in(const TemporaryFolder& folder, const std::string& file = "a.sqlite") {
  return value_of(
      folder,
      "SELECT group_concat(speed, ' ') FROM (SELECT condition ->> 'speed_deg_s' AS speed "
      "FROM trial JOIN enrolment ON enrolment.id = enrolment_id JOIN participant ON "
      "participant.id = participant_id WHERE slot = 1 ORDER BY pseudonym)",
      file);
}

TEST(Groups, OfSimulatedParticipantsAreEquallyLargeAndTheSameForAnyNumberOfJobs) {
  const TemporaryFolder folder;
  grouped_protocol(folder);
  ASSERT_EQ(simulated(folder, {"--participants", "6", "--jobs", "1"}).status, 0);
  EXPECT_EQ(sizes(folder), "5 3, 10 3");
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM trial"), "18");
  ASSERT_EQ(run_program(folder, {"run", "protocols/a.json", "--db", "b.sqlite", "--observer",
                                 "causality", "--participants", "6", "--jobs", "4"})
                .status,
            0);
  EXPECT_EQ(groups_in(folder, "b.sqlite"), groups_in(folder));
  const ProgramResult verified = run_program(folder, {"verify", "a.sqlite", "--replay"});
  EXPECT_EQ(verified.status, 0) << verified.output;
}

TEST(Groups, WhoIsLeftOutOfTheAnalysisLeavesAPlaceInTheGroup) {
  const TemporaryFolder folder;
  grouped_protocol(folder);
  simulated(folder, {"--participant", "A1"});
  const std::string first = groups_in(folder);
  run_program(folder, {"exclude", "a.sqlite", "--participant", "A1", "--reason", "asleep"});
  simulated(folder, {"--participant", "A2"});
  simulated(folder, {"--participant", "A3"});
  const std::string all = groups_in(folder);
  EXPECT_EQ(sizes(folder).find("3"), std::string::npos);
  // A2 and A3 have the two levels, whichever A1 has.
  EXPECT_TRUE(all == first + " 5 10" || all == first + " 10 5") << all;
}

TEST(Groups, AreKeptWithThePlanWhateverComesLater) {
  const TemporaryFolder folder;
  grouped_protocol(folder);
  simulated(folder, {"--participants", "3"});
  change(
      folder,
      "DELETE FROM rating; DELETE FROM frame; DELETE FROM step; DELETE FROM collision; DELETE "
      "FROM attempt; DELETE FROM answer; DELETE FROM note; DELETE FROM session; UPDATE enrolment "
      "SET finished_utc = NULL");
  const std::string before = order_of(folder, "S02");
  ASSERT_EQ(simulated(folder, {"--participants", "3"}).status, 0);
  EXPECT_EQ(order_of(folder, "S02"), before);
}

TEST(Groups, APlanOfNoGroupIsFoundByVerify) {
  const TemporaryFolder folder;
  grouped_protocol(folder);
  simulated(folder, {"--participants", "2"});
  change(folder,
         "UPDATE trial SET condition = json_set(condition, '$.speed_deg_s', 15) WHERE "
         "enrolment_id = 1");
  const ProgramResult result = run_program(folder, {"verify", "a.sqlite"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.output.find("S01, causality: cannot be planned anew: its first trial is of no "
                               "group of the factors between participants: {"),
            std::string::npos)
      << result.output;
}

TEST(Groups, AreListedBySessionsAndCheck) {
  const TemporaryFolder folder;
  grouped_protocol(folder);
  simulated(folder, {"--participants", "2"});
  const ProgramResult listed = run_program(folder, {"sessions", "a.sqlite"});
  for (const char* words : {"  group\n", "speed_deg_s 5\n", "speed_deg_s 10\n"}) {
    EXPECT_NE(listed.output.find(words), std::string::npos) << words << listed.output;
  }
  const json as_json = json::parse(run_program(folder, {"sessions", "a.sqlite", "--json"}).output);
  EXPECT_EQ(as_json["participations"][0]["group"].get<std::string>().substr(0, 12), "speed_deg_s ");
  const ProgramResult checked = run_program(folder, {"check", "protocols/a.json"});
  EXPECT_NE(checked.output.find("Between participants: `speed_deg_s`, 2 groups."),
            std::string::npos)
      << checked.output;
}

}  // namespace impetus::groups_test
