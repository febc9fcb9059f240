// `impetus publish`: a folder that is whole, asks nothing of others, and never overwrites.
// SPDX-License-Identifier: MIT
#include "experiments/site/site_folder.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/program.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus::site_folder_test {

using nlohmann::json;

/// A folder with something in place of what the browser's build makes.
std::string stand_in_program(const TemporaryFolder& folder) {
  folder.write("page/impetus.js", "js");
  folder.write("page/impetus.wasm", "wasm");
  return folder / "page";
}

ProgramResult publish(const TemporaryFolder& folder, const std::vector<std::string>& more,
                      const std::string& protocol = causality_file()) {
  std::vector<std::string> words{"publish", protocol, "--out", "site"};
  words.insert(words.end(), more.begin(), more.end());
  return run_program(folder, words);
}

TEST(Publish, WritesAllThatAPageNeeds) {
  const TemporaryFolder folder;
  const ProgramResult result =
      publish(folder, {"--program", stand_in_program(folder), "--drop", "https://a.org/api",
                       "--experiment", "abc", "--completion", "https://b.org/?cc=1"});
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.output,
            "site: causality, for a web server to serve; trials are sent to https://a.org/api\n");
  for (const char* file : {"session_page.css", "session_page.js", "impetus.js", "impetus.wasm"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / ("site/" + std::string(file)))) << file;
  }
  EXPECT_NE(text_of(folder / "site/index.html").find("connect-src 'self' https://a.org\">"),
            std::string::npos);
  const json site = json::parse(text_of(folder / "site/site.json"));
  EXPECT_EQ(site["drop"], json({{"url", "https://a.org/api"}, {"experiment", "abc"}}));
  EXPECT_EQ(site["completion"], "https://b.org/?cc=1");
  EXPECT_EQ(site["language"], "en");
  const PublishedStudy study =
      published_study_from(json::parse(text_of(folder / "site/study.json")));
  EXPECT_EQ(protocol_of(study, std::make_shared<ShapeLibrary>()).hash, causality().hash);
}

TEST(Publish, PagesSayInTheStudysLanguageAllThatIsTheirs) {
  const TemporaryFolder folder;
  const std::string german = changed_protocol(folder, "/language", "de");
  ASSERT_EQ(publish(folder, {"--program", stand_in_program(folder)}, german).status, 0);
  const json texts = json::parse(text_of(folder / "site/site.json"))["texts"];
  EXPECT_EQ(texts["page_cannot_go_on"], "Diese Studie kann nicht weitergehen");
  std::string scripts = text_of(source_file("experiments/browser/page_session.cpp"));
  for (const auto& file : std::filesystem::directory_iterator(folder / "site")) {
    scripts += file.path().extension() == ".js" ? text_of(file.path()) : "";
  }
  for (const TextRow& row : kTextRows) {
    const std::string key(row.key);
    if (key.starts_with("page_")) {
      EXPECT_NE(scripts.find(key), std::string::npos) << key << " is on no page";
    }
  }
}

TEST(Publish, AsksForTheScreenUnlessToldNotTo) {
  const TemporaryFolder folder;
  const std::string program = stand_in_program(folder);
  ASSERT_EQ(publish(folder, {"--program", program}).status, 0);
  const auto asked = [&] {
    const json site = json::parse(text_of(folder / "site/site.json"));
    return json{site["assume_screen"], site["in_window"], site["allow_failed_sync"]};
  };
  EXPECT_EQ(asked(), json({false, false, false}));
  ASSERT_EQ(publish(folder, {"--program", program, "--force", "--assume-screen", "--in-window",
                             "--allow-failed-sync"})
                .status,
            0);
  EXPECT_EQ(asked(), json({true, true, true}));
}

TEST(Publish, TreesThatTakeLongComeWithIt) {
  const TemporaryFolder folder;
  const ProgramResult result = publish(folder, {"--program", stand_in_program(folder)},
                                       source_file("tests/builds/every-option.json").string());
  ASSERT_EQ(result.status, 0) << result.errors;
  const json trees = json::parse(text_of(folder / "site/site.json"))["trees"];
  EXPECT_GE(trees.size(), 5U);
  for (const json& tree : trees) {
    EXPECT_TRUE(std::filesystem::exists(folder / ("site/trees/" + tree.get<std::string>())));
  }
}

TEST(Publish, WithoutTheProgramOfPagesSaysHowToMakeIt) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "empty");
  const ProgramResult result = publish(folder, {"--program", "empty"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(
      result.errors,
      "impetus: expected empty/impetus.js, the program that runs in a page, but there is none; "
      "`cmake --preset browser && cmake --build build-browser --target impetus_page` makes it, "
      "with emscripten\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "site"));
}

TEST(Publish, NeverOverwrites) {
  const TemporaryFolder folder;
  folder.write("site/mine.txt", "mine");
  const std::string program = stand_in_program(folder);
  const ProgramResult result = publish(folder, {"--program", program});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.errors,
            "impetus: " + (folder / "site").string() +
                ": expected a new folder, got one that holds files; --force replaces a site\n");
  EXPECT_EQ(publish(folder, {"--program", program, "--force"}).errors,
            "impetus: " + (folder / "site").string() +
                ": expected a new folder, got one that holds files that are no site\n");
  EXPECT_EQ(text_of(folder / "site/mine.txt"), "mine");
}

TEST(Publish, ASiteThatHoldsSomethingElseIsLeftAsItIs) {
  const TemporaryFolder folder;
  const std::string protocol = source_file("tests/builds/every-option.json").string();
  const std::string program = stand_in_program(folder);
  ASSERT_EQ(publish(folder, {"--program", program}, protocol).status, 0);
  for (const std::string mine : {"logo.png", "trees/mine.txt", "returned/P01.jsonl"}) {
    folder.write("site/" + mine, "mine");
    EXPECT_EQ(publish(folder, {"--program", program, "--force"}).errors,
              "impetus: " + (folder / "site").string() +
                  ": expected a new folder, got one that holds " + mine +
                  ", which is of no site\n");
    EXPECT_EQ(text_of(folder / ("site/" + mine)), "mine");
    std::filesystem::remove(folder / ("site/" + mine));
  }
  std::filesystem::remove(folder / "site/returned");
  EXPECT_EQ(publish(folder, {"--program", program, "--force"}).status, 0);
}

TEST(Publish, RefusesWhatNoPageCanRun) {
  const TemporaryFolder folder;
  const std::string program = stand_in_program(folder);
  EXPECT_NE(
      publish(folder, {"--program", program},
              source_file("protocols/scheduler-distribution.json").string())
          .errors.find(":/participants: expected a protocol in which somebody takes part, got "
                       "none\n"),
      std::string::npos);
  EXPECT_NE(
      publish(folder, {"--program", program},
              source_file("protocols/gaze-contingent-yoked.json").string())
          .errors.find(":/gaze/yoked_to: expected none in a page, which does not know the gaze "
                       "of others\n"),
      std::string::npos);
  EXPECT_EQ(
      publish(folder, {"--program", program, "--drop", "http://a.org", "--experiment", "x"}).errors,
      "impetus: --drop: expected a link that begins with https://, got http://a.org\n");
  EXPECT_EQ(publish(folder, {"--program", program, "--drop", "https://a.org"}).errors,
            "impetus: --drop and --experiment: expected both or neither\n");
  EXPECT_EQ(publish(folder, {"--program", program, "--completion", "javascript:alert(1)"}).errors,
            "impetus: --completion: expected a link that begins with https://, got "
            "javascript:alert(1)\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "site"));
}

}  // namespace impetus::site_folder_test
