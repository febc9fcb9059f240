// Sessions that come back in parts: none is missing in between, what came late is taken then, and a
// record that is none keeps its own session out and no other.
// SPDX-License-Identifier: MIT
#include "experiments/site/returned_session.hpp"

#include "experiments/settings/input_error.hpp"
#include "experiments/site/session_keeping.hpp"
#include "tests/experiments/program.hpp"
#include "tests/experiments/site/page_session.hpp"

namespace impetus::returned_parts_test {

using nlohmann::json;

const std::string kName = kPageName;

std::string part_file(std::size_t number, const std::string& name = kName) {
  const std::string digits = std::to_string(number);
  return name + "_" + std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits +
         ".jsonl";
}

const std::vector<PagePart>& parts() {
  static const std::vector<PagePart> all = parts_of(session_lines(), kName);
  return all;
}

/// A study file and a folder of what came back.
struct Collected {
  void write_parts(std::size_t first, std::size_t last) {
    for (std::size_t number = first; number <= last; ++number) {
      folder.write("back/" + part_file(number), parts()[number - 1].lines);
    }
  }
  void remove(const std::string& file) { std::filesystem::remove(folder / ("back/" + file)); }

  TakenSession take(std::size_t at = 0) {
    return take_session(returned_files(folder / "back").at(at), published, protocol, study);
  }

  /// "taken", or the sentence with which it is refused as input.
  std::string sentence(std::size_t at = 0) {
    try {
      take(at);
    } catch (const InputError& refused) {
      return refused.what();
    }
    return "taken";
  }

  std::string value(const std::string& sql) { return study.database().execAndGet(sql).getString(); }

  /// Everything that was recorded, but for when it was saved.
  std::string content() {
    return value(
               "SELECT group_concat(slot || number || outcome || onset_ns || hash || step) FROM "
               "(SELECT * FROM trial JOIN attempt ON attempt.trial_id = trial.id JOIN step ON "
               "step.attempt_id = attempt.id ORDER BY slot, number, step)") +
           value("SELECT group_concat(question || answer) FROM answer") +
           value("SELECT group_concat(kind || text) FROM note") +
           value("SELECT group_concat(ending || page_parts) FROM session");
  }

  TemporaryFolder folder;
  PublishedStudy published{short_causality()};
  Protocol protocol{protocol_of(published, std::make_shared<ShapeLibrary>())};
  StudyFile study{opened(folder / "a.sqlite")};
};

TEST(ReturnedParts, AreInTheOrderOfTheirNumbersNotOfTheirDigits) {
  const TemporaryFolder folder;
  for (const std::size_t number : {10000U, 9999U, 2U, 100000U, 1U}) {
    folder.write("back/" + part_file(number), "");
  }
  const ReturnedFiles session = returned_files(folder / "back").at(0);
  std::vector<std::string> files;
  for (const ReturnedPart& part : session.parts) {
    files.push_back(part.file.filename().string());
  }
  EXPECT_EQ(files, (std::vector{part_file(1), part_file(2), part_file(9999), part_file(10000),
                                part_file(100000)}));
}

TEST(ReturnedParts, TheFirstThatIsMissingIsNamedAndNothingIsTaken) {
  Collected back;
  back.write_parts(1, parts().size());
  back.remove(part_file(7));
  back.remove(part_file(8));
  EXPECT_EQ(back.sentence(), kName + ": expected " + part_file(7) + " next, got " + part_file(9));
  back.remove(part_file(1));
  EXPECT_EQ(back.sentence(), kName + ": expected " + part_file(1) + " next, got " + part_file(2));
  EXPECT_EQ(back.value("SELECT count(*) FROM participant"), "0");
}

TEST(ReturnedParts, OneThatIsThereTwiceIsRefused) {
  Collected back;
  back.write_parts(1, 2);
  back.folder.write("back/" + kName + "_00002.jsonl", parts()[1].lines);
  EXPECT_EQ(back.sentence().find(kName + ": expected " + part_file(3) + " next, got " + kName), 0U);
}

TEST(ReturnedParts, WhatCameLateIsTakenThenAndMakesTheSameStudy) {
  Collected whole;
  whole.write_parts(1, parts().size());
  EXPECT_TRUE(whole.take().finished);
  Collected late;
  late.write_parts(1, 9);
  const TakenSession first = late.take();
  EXPECT_FALSE(first.finished);
  EXPECT_EQ(first.first_part, 1);
  EXPECT_EQ(first.last_part, 9);
  late.write_parts(10, parts().size());
  const TakenSession rest = late.take();
  EXPECT_TRUE(rest.finished);
  EXPECT_EQ(rest.first_part, 10);
  EXPECT_EQ(rest.last_part, static_cast<std::int64_t>(parts().size()));
  EXPECT_EQ(late.content(), whole.content());
  EXPECT_EQ(late.value("SELECT count(*) FROM session"), "1");
  EXPECT_EQ(late.sentence(), kName + ": expected a session that is not in " + late.study.name() +
                                 " yet, got one that is");
}

TEST(ReturnedParts, WhatCameLateMayComeAloneButHasNoGapEither) {
  Collected back;
  back.write_parts(1, 9);
  back.take();
  std::filesystem::remove_all(back.folder / "back");
  back.write_parts(11, parts().size());
  EXPECT_EQ(back.sentence(), kName + ": expected " + part_file(10) + " next, got " + part_file(11));
  EXPECT_EQ(back.value("SELECT page_parts FROM session"), "9");
  back.write_parts(10, 10);
  EXPECT_EQ(back.sentence(), "taken");
}

TEST(ReturnedParts, ADownloadOfASessionThatIsThereIsRefused) {
  Collected back;
  back.write_parts(1, 9);
  back.take();
  back.folder.write("back/" + kName + ".jsonl", joined(session_lines()));
  EXPECT_EQ(back.sentence(), kName + ": expected a session that is not in " + back.study.name() +
                                 " yet, got one that is");
  EXPECT_EQ(back.value("SELECT count(*) FROM attempt"), "9");
}

TEST(ReturnedParts, AfterWhichAnotherSessionBeganAreRefused) {
  Collected back;
  back.write_parts(1, 9);
  back.take();
  Standing standing{plan_of(back.published, back.protocol, "P01", kPageSeed), {}};
  standing.history = load_enrolment(back.study, 1).history;
  const auto lines = lines_from(back.published, to_json(standing, back.protocol.design));
  back.folder.write(
      "back/P01_20260103.jsonl",
      joined(lines).substr(0, joined(lines).find("\n", joined(lines).find("\"attempt\"")) + 1));
  EXPECT_EQ(back.sentence(1), "taken");
  back.write_parts(10, 12);
  EXPECT_EQ(back.sentence(), kName + ": expected the last session of P01 in " + back.study.name() +
                                 " to go on from part 10, got one after which another began");
}

TEST(ReturnedParts, OfAnotherProtocolAreRefused) {
  Collected back;
  back.write_parts(1, 9);
  back.take();
  back.write_parts(10, 12);
  PublishedStudy other = back.published;
  json protocol = json::parse(other.protocol_json);
  protocol["name"] = "another";
  other.protocol_json = protocol.dump();
  const Protocol another = protocol_of(other, std::make_shared<ShapeLibrary>());
  EXPECT_EQ(sentence_of([&] {
              take_session(returned_files(back.folder / "back").at(0), other, another, back.study);
            }),
            kName + ": expected a session of another in " + back.study.name() +
                ", got one of another protocol");
}

TEST(ReturnedParts, ARatingThatTheTablesForbidKeepsItsSessionOutAndNoOther) {
  Collected back;
  const std::size_t at = line_of_kind("attempt", 20);
  std::vector<std::string> lines = session_lines();
  const std::string trial = std::to_string(json::parse(lines[at])["slot"].get<int>());
  lines[at] = with_rating(lines[at], 99);
  back.folder.write("back/" + kName + ".jsonl", joined(lines));
  back.folder.write("back/P02_20260102.jsonl", joined(lines_from(back.published, {}, "P02")));
  EXPECT_EQ(back.sentence(0), kName + ": trial " + trial + kForbiddenRating);
  EXPECT_EQ(back.value("SELECT (SELECT count(*) FROM participant) + (SELECT count(*) FROM protocol)"
                       " + (SELECT count(*) FROM enrolment) + (SELECT count(*) FROM session)"),
            "0");
  EXPECT_EQ(back.sentence(1), "taken");
  back.folder.write("back/" + kName + ".jsonl", joined(session_lines()));
  EXPECT_EQ(back.sentence(0), "taken");
  EXPECT_EQ(back.value("SELECT count(*) FROM attempt"), "66");
}

TEST(ReturnedParts, AResponseWithMoreDetailsThanARowHoldsIsRefused) {
  Collected back;
  std::vector<std::string> lines = session_lines();
  std::string& line = lines[line_of_kind("attempt")];
  auto attempt = std::get<AttemptRecord>(record_from(json::parse(line)));
  ResponseRecord response;
  response.kind = "yes_no";
  response.device = "key";
  for (int detail = 0; detail < 1'000; ++detail) {
    response.detail.push_back({std::to_string(detail), 1.0});
  }
  attempt.responses.push_back(response);
  line = line_of(attempt);
  back.folder.write("back/" + kName + ".jsonl", joined(lines));
  EXPECT_NE(back.sentence().find("a response has at most "), std::string::npos);
  EXPECT_EQ(back.value("SELECT count(*) FROM participant"), "0");
}

TEST(ReturnedParts, AForbiddenRatingInWhatCameLateLeavesWhatIsThere) {
  Collected back;
  back.write_parts(1, 9);
  back.take();
  const std::string before = back.content();
  back.write_parts(10, 20);
  std::vector<std::string> lines = lines_in(parts()[14].lines);
  lines.back() = with_rating(lines.back(), 99);
  back.folder.write("back/" + part_file(15), joined(lines));
  EXPECT_NE(back.sentence().find(kForbiddenRating), std::string::npos);
  EXPECT_EQ(back.content(), before);
  back.write_parts(15, 15);
  EXPECT_EQ(back.sentence(), "taken");
}

TEST(ReturnedParts, AFullDiskIsNoRefusalAndLeavesNothingOfTheSession) {
  Collected back;
  back.write_parts(1, parts().size());
  back.study.database().exec("PRAGMA max_page_count = 1");
  EXPECT_THROW(back.take(), StoreError);
  EXPECT_EQ(back.value("SELECT count(*) FROM participant"), "0");
  back.study.database().exec("PRAGMA max_page_count = 1000000");
  EXPECT_EQ(back.sentence(), "taken");
}

}  // namespace impetus::returned_parts_test
