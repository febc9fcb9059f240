// `impetus serve` without its web server: what pages post is kept once, whatever happens to page,
// program and disk, and nobody reaches what is another's.
// SPDX-License-Identifier: MIT
#include "experiments/site/served_study.hpp"

#include "experiments/settings/input_error.hpp"
#include "tests/experiments/program.hpp"
#include "tests/experiments/site/page_session.hpp"

namespace impetus::served_study_test {

using nlohmann::json;

std::vector<PostedPart> posted(const std::vector<std::string>& lines, const std::string& name) {
  std::vector<PostedPart> all;
  for (PagePart& part : parts_of(lines, name)) {
    all.push_back({part.name, part.number, std::move(part.lines), kPageKey});
  }
  return all;
}

const std::vector<PostedPart>& parts() {
  static const std::vector<PostedPart> all = posted(session_lines(), kPageName);
  return all;
}

/// A study that is served from a file.
struct Served {
  explicit Served(const std::filesystem::path& path, PublishedStudy of = short_causality())
      : published(std::move(of)),
        protocol(protocol_of(published, std::make_shared<ShapeLibrary>())),
        study(opened(path)),
        site(published, protocol, study) {}

  std::string sentence_of_part(const PostedPart& part) {
    try {
      site.take(part);
    } catch (const std::exception& refused) {
      return refused.what();
    }
    return "taken";
  }

  std::string value(const std::string& sql) { return study.database().execAndGet(sql).getString(); }

  PublishedStudy published;
  Protocol protocol;
  StudyFile study;
  ServedStudy site;
};

/// Everything that was recorded, but for when it was saved.
std::string all_of(const std::filesystem::path& path) {
  return value_of(path,
                  "SELECT group_concat(slot || number || outcome || onset_ns || hash || step) FROM "
                  "(SELECT * FROM trial JOIN attempt ON attempt.trial_id = trial.id JOIN step ON "
                  "step.attempt_id = attempt.id ORDER BY slot, number, step)") +
         value_of(path, "SELECT group_concat(question || answer) FROM answer") +
         value_of(path, "SELECT group_concat(kind || text) FROM note");
}

TEST(ServedStudy, AWholeSessionIsKeptVerifiedAndReplayed) {
  const TemporaryFolder folder;
  {
    Served served(folder / "a.sqlite");
    for (const PostedPart& part : parts()) {
      EXPECT_EQ(served.sentence_of_part(part), "taken");
      EXPECT_EQ(served.value("SELECT page_parts FROM session"), std::to_string(part.number));
    }
  }
  EXPECT_EQ(value_of(folder / "a.sqlite", "SELECT count(*) FROM attempt"), "33");
  EXPECT_EQ(value_of(folder / "a.sqlite",
                     "SELECT ending || (page_key IS NULL) || (finished_utc IS NOT NULL) FROM "
                     "session JOIN enrolment ON enrolment.id = enrolment_id"),
            "finished11");
  EXPECT_EQ(run_program(folder, {"verify", "a.sqlite"}).status, 0);
  const ProgramResult replayed = run_program(folder, {"replay", "a.sqlite"});
  EXPECT_NE(replayed.output.find(" 0 divergent"), std::string::npos) << replayed.output;
}

TEST(ServedStudy, PartsThatComeTwiceAndProgramsThatAreStartedAgainChangeNothing) {
  const TemporaryFolder folder;
  {
    Served served(folder / "once.sqlite");
    for (const PostedPart& part : parts()) {
      served.site.take(part);
    }
  }
  for (const PostedPart& part : parts()) {
    Served served(folder / "again.sqlite");  // it has heard of none of the earlier parts
    EXPECT_EQ(served.sentence_of_part(part), "taken");
    EXPECT_EQ(served.sentence_of_part(part), "taken");
    EXPECT_EQ(served.sentence_of_part(parts().front()), "taken");
  }
  EXPECT_EQ(all_of(folder / "again.sqlite"), all_of(folder / "once.sqlite"));
}

TEST(ServedStudy, APartThatIsWrongLeavesNothingAndTheRightOneIsTakenThen) {
  const TemporaryFolder folder;
  Served served(folder / "a.sqlite");
  for (const PostedPart& part : parts()) {
    PostedPart wrong = part;
    wrong.lines += "{\"kind\":\"prize\"}\n";
    EXPECT_NE(served.sentence_of_part(wrong), "taken");
    EXPECT_EQ(served.value("SELECT ifnull(max(page_parts), 0) FROM session"),
              std::to_string(part.number - 1));
    EXPECT_EQ(served.sentence_of_part(part), "taken");
  }
  EXPECT_EQ(served.value("SELECT count(*) FROM attempt"), "33");
}

/// The sentence with which a part is refused as input; then the page sends it no more.
std::string refusal_of(Served& served, const PostedPart& part) {
  try {
    served.site.take(part);
  } catch (const InputError& refused) {
    return refused.what();
  } catch (const std::exception& other) {
    return "sent again: " + std::string(other.what());
  }
  return "taken";
}

TEST(ServedStudy, ARatingThatTheTablesForbidIsRefusedForGoodAndLeavesNothing) {
  const TemporaryFolder folder;
  Served served(folder / "a.sqlite");
  const std::string counts =
      "SELECT (SELECT count(*) FROM participant) || (SELECT count(*) FROM enrolment) || "
      "(SELECT count(*) FROM session) || (SELECT count(*) FROM attempt)";
  const auto wrong = [](PostedPart part) {
    std::vector<std::string> lines = lines_of(part.lines);
    lines.back() = with_rating(lines.back(), 99);
    part.lines = joined(lines);
    return part;
  };
  for (const std::size_t at : {0U, 1U}) {
    const std::string before = served.value(counts);
    const std::string sentence = refusal_of(served, wrong(parts()[at]));
    EXPECT_EQ(sentence.find(std::string(kPageName) + ": trial "), 0U) << sentence;
    EXPECT_NE(sentence.find(kForbiddenRating), std::string::npos) << sentence;
    EXPECT_EQ(served.value(counts), before);
    EXPECT_EQ(refusal_of(served, parts()[at]), "taken");
  }
  EXPECT_EQ(served.value(counts), "1112");
}

TEST(ServedStudy, ALevelThatIsChosenTwiceIsRefusedForGood) {
  const TemporaryFolder folder;
  Served served(folder / "a.sqlite",
                {text_of(source_file("protocols/causality-thresholds-quest.json")),
                 text_of(source_file("stimuli/two-spheres.json")),
                 {},
                 "this test"});
  for (PostedPart part : posted(lines_from(served.published, {}), kPageName)) {
    for (const std::string& line : lines_of(part.lines)) {
      if (json::parse(line)["kind"] == "level") {
        part.lines += line + "\n";
        EXPECT_NE(refusal_of(served, part).find("has its level already"), std::string::npos);
        EXPECT_EQ(refusal_of(served, part).find("sent again"), std::string::npos);
        return;
      }
    }
    served.site.take(part);
  }
  ADD_FAILURE() << "no level was chosen";
}

TEST(ServedStudy, APartThatIsMissingIsNamed) {
  const TemporaryFolder folder;
  Served served(folder / "a.sqlite");
  served.site.take(parts()[0]);
  EXPECT_EQ(served.sentence_of_part(parts()[2]),
            std::string(kPageName) + ": expected part 2, got 3");
  EXPECT_EQ(served.sentence_of_part(parts()[1]), "taken");
}

TEST(ServedStudy, WhoHasNotTheKeyNeitherReadsNorWrites) {
  const TemporaryFolder folder;
  Served served(folder / "a.sqlite");
  served.site.take(parts()[0]);
  PostedPart foreign = parts()[1];
  foreign.key = "fedcba9876543210";
  EXPECT_EQ(served.sentence_of_part(foreign),
            std::string(kPageName) + ": this session goes on elsewhere, or is over");
  EXPECT_EQ(sentence_of([&] { served.site.standing("P01", foreign.key); }),
            "the session of P01 goes on by the link with which it began, and by no other");
  PostedPart begun = parts()[0];
  begun.name = "P01_20260103";
  begun.key = foreign.key;
  EXPECT_EQ(served.sentence_of_part(begun),
            "the session of P01 goes on by the link with which it began, and by no other");
  EXPECT_TRUE(served.site.standing("P02", kPageKey).is_null());
  EXPECT_EQ(served.value("SELECT count(*) FROM session"), "1");
}

TEST(ServedStudy, APageThatIsOpenedAgainGoesOnAndTheOldOneIsOver) {
  const TemporaryFolder folder;
  {
    Served served(folder / "a.sqlite");
    for (std::size_t at = 0; at < 12; ++at) {
      served.site.take(parts()[at]);
    }
    const json standing = served.site.standing("P01", kPageKey);
    EXPECT_EQ(standing["completed"].size(), 12U);
    std::vector<std::string> lines = lines_from(served.published, standing);
    json session = json::parse(lines.front());
    session["screen"][2] = session["screen"][2].get<int>() / 2;  // its width in pixels
    lines.front() = session.dump();
    const auto rest = posted(lines, "P01_20260103");
    EXPECT_EQ(rest.size(), 22U);
    for (const PostedPart& part : rest) {
      EXPECT_EQ(served.sentence_of_part(part), "taken");
      EXPECT_EQ(served.sentence_of_part(parts()[12]),
                std::string(kPageName) + ": this session goes on elsewhere, or is over");
    }
    EXPECT_EQ(served.site.standing("P01", kPageKey), json({{"finished", true}}));
  }
  EXPECT_EQ(value_of(folder / "a.sqlite",
                     "SELECT count(*) || ' ' || count(DISTINCT trial_id) FROM attempt"),
            "33 33");
  EXPECT_EQ(value_of(folder / "a.sqlite",
                     "SELECT group_concat(ifnull(resumed_at, '-') || ifnull(ending, '-')) FROM "
                     "session"),
            "--,trialfinished");
  EXPECT_EQ(value_of(folder / "a.sqlite",
                     "SELECT group_concat(kind) FROM note WHERE session_id = 2 AND kind IN "
                     "('screen changed', 'pixels not square')"),
            "screen changed,pixels not square");
  const ProgramResult verified = run_program(folder, {"verify", "a.sqlite"});
  EXPECT_NE(verified.output.find("P01 sat before 2 screens"), std::string::npos) << verified.output;
  EXPECT_EQ(run_program(folder, {"replay", "a.sqlite"}).status, 0);
}

/// Where its page and where the study file say that the participant stands after so many parts.
void expect_one_standing(Served& served, const std::vector<PostedPart>& all, std::size_t count) {
  Standing standing{plan_of(served.published, served.protocol, "P01", kPageSeed), {}};
  for (std::size_t at = 0; at < count; ++at) {
    served.site.take(all[at]);
    for (const std::string& line : lines_of(all[at].lines)) {
      const AnyRecord record = record_from(json::parse(line));
      if (!std::holds_alternative<PlannedTrial>(record)) {
        add(record, standing);
      }
    }
  }
  EXPECT_EQ(served.site.standing("P01", kPageKey), to_json(standing, served.protocol.design));
}

TEST(ServedStudy, PageAndStudyFileAgreeOnWhereTheParticipantStands) {
  const TemporaryFolder folder;
  Served causality(folder / "a.sqlite");
  expect_one_standing(causality, parts(), 20);
  Served adaptive(folder / "b.sqlite",
                  {text_of(source_file("protocols/causality-thresholds-quest.json")),
                   text_of(source_file("stimuli/two-spheres.json")),
                   {},
                   "this test"});
  const auto all = posted(lines_from(adaptive.published, {}), kPageName);
  expect_one_standing(adaptive, all, 25);
  const auto rest =
      posted(lines_from(adaptive.published, adaptive.site.standing("P01", kPageKey)), "P01_2027");
  for (const PostedPart& part : rest) {
    EXPECT_EQ(adaptive.sentence_of_part(part), "taken");
  }
}

TEST(ServedStudy, AFullDiskIsSaidAndWhatIsSentAgainIsKeptOnce) {
  const TemporaryFolder folder;
  {
    Served served(folder / "a.sqlite");
    served.site.take(parts()[0]);
    served.study.database().exec("PRAGMA max_page_count = 1");
    EXPECT_NE(served.sentence_of_part(parts()[1]).find("database or disk is full"),
              std::string::npos);
    served.study.database().exec("PRAGMA max_page_count = 1000000");
    for (const PostedPart& part : parts()) {
      EXPECT_EQ(served.sentence_of_part(part), "taken");
    }
  }
  EXPECT_EQ(value_of(folder / "a.sqlite", "SELECT count(*) FROM attempt"), "33");
  EXPECT_EQ(run_program(folder, {"verify", "a.sqlite"}).status, 0);
}

TEST(PostedPart, WhatIsNoneIsRefusedByItsField) {
  const auto refusal = [](const json& body) {
    return sentence_of([&] { posted_part_from(body); });
  };
  const json good{{"filename", "P01_2026_0001.jsonl"}, {"data", ""}, {"key", kPageKey}};
  EXPECT_EQ(posted_part_from(good).name, "P01_2026");
  EXPECT_EQ(posted_part_from(good).number, 1);
  json bad = good;
  bad["filename"] = "../P01_2026_0001.jsonl";
  EXPECT_EQ(refusal(bad),
            "filename: expected CODE_TIME_0001.jsonl, got \"../P01_2026_0001.jsonl\"");
  bad["filename"] = std::string(200'000, 'P') + "_2026_0001.jsonl";
  EXPECT_EQ(refusal(bad).find("filename: expected CODE_TIME_0001.jsonl, got \"PPP"), 0U);
  bad = good;
  bad["key"] = "short";
  EXPECT_EQ(refusal(bad), "key: expected 16 to 100 letters, got 5");
  bad.erase("data");
  EXPECT_EQ(refusal(bad).find("expected an object with texts"), 0U);
  EXPECT_EQ(refusal(json::array()).find("expected an object with texts"), 0U);
}

}  // namespace impetus::served_study_test
