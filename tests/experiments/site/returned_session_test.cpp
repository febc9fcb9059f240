// Sessions that come back from pages: what a page hands over becomes a study like any other, the
// same states as the program's own; what was changed on the way is refused by name.
// SPDX-License-Identifier: MIT
#include "experiments/site/returned_session.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "engine/numerics/random_stream.hpp"
#include "tests/experiments/program.hpp"
#include "tests/experiments/site/page_session.hpp"

namespace impetus::returned_session_test {

using nlohmann::json;

/// The sentence with which a session is refused one of whose lines was changed.
std::string refusal_of(std::size_t at, const std::function<void(json& line)>& change) {
  std::vector<std::string> lines = session_lines();
  json line = json::parse(lines[at]);
  change(line);
  lines[at] = line.dump();
  const TemporaryFolder folder;
  folder.write(std::string(kPageName) + ".jsonl", joined(lines));
  const PublishedStudy published = short_causality();
  const Protocol protocol = protocol_of(published, std::make_shared<ShapeLibrary>());
  StudyFile study = opened(folder / "a.sqlite");
  const std::string sentence = sentence_of(
      [&] { take_session(returned_files(folder.path()).front(), published, protocol, study); });
  for (const char* table : {"session", "enrolment", "participant", "protocol"}) {
    EXPECT_EQ(study.database().execAndGet(std::string("SELECT count(*) FROM ") + table).getInt(),
              sentence == "accepted" ? 1 : 0)
        << table << ": " << sentence;
  }
  return sentence;
}

/// A site's study.json and a folder of what came back, in parts of ten lines.
void write_returned(const TemporaryFolder& folder) {
  folder.write("site/study.json", to_json(short_causality()).dump());
  const std::vector<std::string>& lines = session_lines();
  for (std::size_t at = 0, part = 1; at < lines.size(); at += 10, ++part) {
    const std::size_t end = std::min(at + 10, lines.size());
    char number[8];
    std::snprintf(number, sizeof number, "%04zu", part);
    folder.write("back/" + std::string(kPageName) + "_" + number + ".jsonl",
                 joined({lines.begin() + static_cast<std::ptrdiff_t>(at),
                         lines.begin() + static_cast<std::ptrdiff_t>(end)}));
  }
}

TEST(ReturnedSession, IsCollectedVerifiedAndReplayed) {
  const TemporaryFolder folder;
  write_returned(folder);
  const ProgramResult collected =
      run_program(folder, {"collect", "back", "--site", "site", "--into", "a.sqlite"});
  EXPECT_EQ(collected.status, 0) << collected.errors;
  EXPECT_EQ(collected.output.find(std::string(kPageName) + ": parts 1 to 8, "), 0U)
      << collected.output;
  EXPECT_NE(collected.output.find(" steps simulated again, 0 divergent\n"), std::string::npos)
      << collected.output;
  EXPECT_NE(collected.output.find("a.sqlite: 1 of 1 sessions taken\n"), std::string::npos);
  const ProgramResult replayed = run_program(folder, {"replay", "a.sqlite"});
  EXPECT_EQ(replayed.status, 0) << replayed.output;
  EXPECT_NE(replayed.output.find(" 0 divergent"), std::string::npos) << replayed.output;
  const ProgramResult verified = run_program(folder, {"verify", "a.sqlite"});
  EXPECT_EQ(verified.status, 0) << verified.output << verified.errors;
  EXPECT_EQ(value_of(folder / "a.sqlite", "SELECT count(*) FROM attempt"), "33");
  EXPECT_EQ(value_of(folder / "a.sqlite",
                     "SELECT machine || ', ' || ending || ', ' || page_name || ', ' || page_parts "
                     "FROM session"),
            "a browser, finished, " + std::string(kPageName) + ", 8");
  EXPECT_EQ(value_of(folder / "a.sqlite", "SELECT recording_format FROM session"),
            std::to_string(kRecordingFormat));
}

TEST(ReturnedSession, OfAFolderThatDoesNotSayItsRecordingFormatIsOfTheSecond) {
  const TemporaryFolder folder;
  write_returned(folder);
  json published = json::parse(text_of(folder / "site/study.json"));
  EXPECT_EQ(published_study_from(published).recording_format, kRecordingFormat);
  published["recording_format"] = 99;
  const std::string build = published["build"];
  folder.write("site/study.json", published.dump());
  EXPECT_NE(run_program(folder, {"collect", "back", "--site", "site", "--into", "a.sqlite"})
                .errors.find("study.json: expected sessions of recording format 1 to " +
                             std::to_string(kRecordingFormat) + ", got 99, published by " + build),
            std::string::npos);
  published.erase("recording_format");
  folder.write("site/study.json", published.dump());
  const ProgramResult collected =
      run_program(folder, {"collect", "back", "--site", "site", "--into", "a.sqlite"});
  EXPECT_EQ(collected.status, 0) << collected.errors;
  EXPECT_EQ(value_of(folder / "a.sqlite", "SELECT recording_format FROM session"), "2");
}

TEST(ReturnedSession, HasThePlanAndTheStatesOfTheProgramItself) {
  const TemporaryFolder folder;
  write_returned(folder);
  run_program(folder, {"collect", "back", "--site", "site", "--into", "a.sqlite"});
  folder.write("stimuli/two-spheres.json", short_causality().scene_json);
  folder.write("protocols/own.json", short_causality().protocol_json);
  const ProgramResult own =
      run_program(folder, {"run", "protocols/own.json", "--db", "own.sqlite", "--observer",
                           source_file("experiments/observers/causality.json").string(),
                           "--participant", "P01", "--seed", std::to_string(kPageSeed)});
  ASSERT_EQ(own.status, 0) << own.errors;
  const std::string sql =
      "SELECT group_concat(slot || condition || seed || step || ':' || hash) FROM (SELECT * FROM "
      "trial JOIN attempt ON attempt.trial_id = trial.id JOIN step ON step.attempt_id = attempt.id "
      "ORDER BY slot, step)";
  EXPECT_EQ(value_of(folder / "a.sqlite", sql), value_of(folder / "own.sqlite", sql));
}

TEST(ReturnedSession, IsTakenOnce) {
  const TemporaryFolder folder;
  write_returned(folder);
  run_program(folder, {"collect", "back", "--site", "site", "--into", "a.sqlite"});
  const ProgramResult again =
      run_program(folder, {"collect", "back", "--site", "site", "--into", "a.sqlite"});
  EXPECT_EQ(again.status, 1);
  EXPECT_EQ(again.errors,
            "refused: " + std::string(kPageName) +
                ": expected a session that is not in a.sqlite yet, got one that is\n");
  std::filesystem::rename(folder / "back", folder / "old");
  folder.write("back/P01_20260103.jsonl", joined(session_lines()));
  const ProgramResult renamed =
      run_program(folder, {"collect", "back", "--site", "site", "--into", "a.sqlite"});
  EXPECT_NE(renamed.errors.find("participant P01 has finished causality already"),
            std::string::npos)
      << renamed.errors;
  EXPECT_EQ(value_of(folder / "a.sqlite", "SELECT count(*) FROM attempt"), "33");
}

TEST(ReturnedSession, OneBitOfAStateIsNamedByTrialAndStep) {
  const std::size_t at = line_of_kind("attempt", 2);
  const std::int64_t slot = json::parse(session_lines()[at])["slot"];
  EXPECT_EQ(refusal_of(at,
                       [](json& line) {
                         json& hash = line["steps"][1 + 12][4];
                         hash = hash.get<std::uint64_t>() ^ 1U;
                       }),
            std::string(kPageName) + ": line " + std::to_string(at + 1) +
                ": expected the states that these inputs lead to, got others from trial " +
                std::to_string(slot) + ", step 12 on");
}

TEST(ReturnedSession, AnotherPlanSeedProtocolOrTrialIsRefused) {
  const std::string start = std::string(kPageName) + ": line ";
  EXPECT_NE(refusal_of(1, [](json& line) { line["seed"] = 1; })
                .find("expected the trials that code and seed lead to, got others"),
            std::string::npos);
  EXPECT_NE(refusal_of(0, [](json& line) { line["seed"] = 1; })
                .find("expected the trials that code and seed lead to, got others"),
            std::string::npos);
  EXPECT_EQ(refusal_of(0, [](json& line) { line["protocol_hash"] = "0"; })
                .find(start + "1: expected a session of causality ("),
            0U);
  const std::size_t attempt = line_of_kind("attempt");
  EXPECT_EQ(refusal_of(attempt, [](json& line) { line["slot"] = 99; }),
            start + std::to_string(attempt + 1) + ": expected a trial of the plan, got 99");
  EXPECT_EQ(refusal_of(attempt + 1, [](json& line) { line["kind"] = "prize"; }).find(start), 0U);
}

TEST(ReturnedSession, ACollisionOfNoBodyIsRefused) {
  const std::size_t at = line_of_kind("attempt", 8);
  EXPECT_NE(refusal_of(at, [](json& line) { line["body_names"] = json::array({"alone"}); })
                .find(": expected collisions of its bodies, got one of others"),
            std::string::npos);
}

TEST(ReturnedSession, AnyNumberOfATrialThatIsAnotherIsProvedOrRefused) {
  RandomStream places(20'26, "numbers of attempts");
  for (int change = 0; change < 40; ++change) {
    const std::string sentence =
        refusal_of(line_of_kind("attempt", places.place_below(10)), [&](json& line) {
          json* at = &line;
          while (at->is_structured() && !at->empty()) {
            auto next = at->begin();
            std::advance(next, static_cast<std::ptrdiff_t>(places.below(at->size())));
            at = &*next;
          }
          if (at->is_number()) {
            *at = places.below(2) == 0 ? -1 : 1'000'000'000;
          }
        });
    EXPECT_NE(sentence, "");
  }
}

TEST(ReturnedSession, AFolderWithoutSessionsIsRefused) {
  const TemporaryFolder folder;
  folder.write("site/study.json", to_json(short_causality()).dump());
  folder.write("back/readme.txt", "");
  const ProgramResult result =
      run_program(folder, {"collect", "back", "--site", "site", "--into", "a.sqlite"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.errors,
            "impetus: back: expected a folder with sessions that came back (.jsonl), got one "
            "without\n");
}

}  // namespace impetus::returned_session_test
