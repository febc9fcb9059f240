// `impetus new`: every template is a study that runs at once; what cannot be one is refused.
// SPDX-License-Identifier: MIT
#include <filesystem>

#include "experiments/languages/language_file.hpp"
#include "experiments/protocol/new_study.hpp"
#include "experiments/settings/json_document.hpp"
#include "tests/experiments/command_lines.hpp"

namespace impetus::new_test {

/// Makes, checks, runs and replays a study.
void expect_runs(const TemporaryFolder& folder, std::vector<std::string> choices) {
  choices.insert(choices.begin(), {"new", "mine"});
  const ProgramResult made = run_program(folder, choices);
  ASSERT_EQ(made.status, 0) << made.errors;
  const ProgramResult checked =
      run_program(folder, {"check", "mine/protocol.json", "--observer", "mine/observer.json"});
  EXPECT_EQ(checked.status, 0) << checked.errors;
  EXPECT_EQ(checked.errors, "");
  const ProgramResult run =
      run_program(folder, {"run", "mine/protocol.json", "--db", "mine/study.sqlite", "--observer",
                           "mine/observer.json", "--participant", "S01"});
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run_program(folder, {"replay", "mine/study.sqlite"}).status, 0);
  std::filesystem::remove_all(folder / "mine");
}

TEST(New, EveryTemplateRunsAsItComes) {
  const TemporaryFolder folder;
  for (const StudyTemplate& each : study_templates()) {
    SCOPED_TRACE(each.name);
    expect_runs(folder, {"--template", each.name});
  }
}

TEST(New, EveryQuestionCanBeAsked) {
  const TemporaryFolder folder;
  for (const OfferedQuestion& offered : offered_questions("two-balls")) {
    SCOPED_TRACE(offered.name);
    expect_runs(folder, {"--ask", offered.name, "--vary", "restitution=.2,.8"});
  }
}

TEST(New, LevelsAreChosenByWhatIsAnswered) {
  const TemporaryFolder folder;
  for (const char* rule : {"staircase", "quest"}) {
    for (const char* ask : {"detection", "two-interval"}) {
      SCOPED_TRACE(std::string(rule) + " " + ask);
      expect_runs(folder, {"--vary", "gap_arcmin", "--ask", ask, "--levels", rule});
    }
  }
}

TEST(New, OfTwoIntervalsTheStandardIsWhatTheSceneSaysAndNoPracticeShowsItTwice) {
  const auto protocol_of = [](const char* shown, const std::string& factor) {
    return nlohmann::json::parse(
        make_study({"mine", shown, {factor}, "two-interval", "", "en"}).at("protocol.json"));
  };
  const nlohmann::json by_level = protocol_of("two-blocks", "level");
  EXPECT_EQ(by_level["two_interval"]["standard"], nlohmann::json({{"level", 4}}));
  EXPECT_EQ(by_level["design"]["practice"], nlohmann::json::array({{{"level", 0}}}));
  EXPECT_EQ(by_level.dump().find("no right or wrong"), std::string::npos);
  const nlohmann::json by_delay = protocol_of("two-balls", "delay_ms");
  EXPECT_EQ(by_delay["two_interval"]["standard"], nlohmann::json({{"delay_ms", 0}}));
  EXPECT_EQ(by_delay["design"]["practice"], nlohmann::json::array({{{"delay_ms", 200}}}));
  const nlohmann::json between = protocol_of("two-blocks", "speed_percent");
  EXPECT_EQ(between["two_interval"]["standard"], nlohmann::json({{"speed_percent", 100}}));
  EXPECT_EQ(between["design"]["practice"].size(), 2U);
  const nlohmann::json by_words = protocol_of("blocks-by-gaze", "detail");
  EXPECT_EQ(by_words["two_interval"]["standard"], nlohmann::json({{"detail", "all-good"}}));
}

TEST(New, TheSimulatedParticipantFindsNaturalWhatIs) {
  const auto falls = [](const char* shown, const char* factor, const char* ask) {
    return nlohmann::json::parse(
        make_study({"mine", shown, {factor}, ask, "", "en"}).at("observer.json"))["falling"];
  };
  for (const char* of_unnatural : {"detection", "two-interval", "rating", "click"}) {
    EXPECT_EQ(falls("two-blocks", "level", of_unnatural), true) << of_unnatural;
    EXPECT_EQ(falls("two-balls", "delay_ms", of_unnatural), false) << of_unnatural;
    EXPECT_EQ(falls("two-balls", "gap_arcmin=20,10,0", of_unnatural), false) << of_unnatural;
  }
  EXPECT_EQ(falls("two-blocks", "level", "yes-no"), false);
  EXPECT_EQ(falls("two-balls", "delay_ms", "yes-no"), true);
}

TEST(New, LevelsThatRiseToWhatLooksNaturalAreNotChosenFrom) {
  EXPECT_EQ(
      refusal([] {
        make_study({"mine", "two-blocks", {"level=0,1,2,3,4"}, "detection", "", "en", "staircase"});
      }),
      "--levels: to choose from, expected levels of level that rise from the most natural, of "
      "these "
      "4, next to the scene's own, got [0,1,2,3,4]");
}

TEST(New, WhoFollowsTheGazeSaysSoBeforeConsent) {
  const auto protocol_of = [](const char* shown) {
    return nlohmann::json::parse(
        make_study({"mine", shown, {}, "click", "", "en"}).at("protocol.json"));
  };
  const nlohmann::json followed = protocol_of("blocks-by-gaze");
  EXPECT_TRUE(followed.contains("gaze"));
  EXPECT_NE(followed["session"]["consent"].dump().find("Where you look is recorded"),
            std::string::npos);
  const nlohmann::json not_followed = protocol_of("blocks-in-a-cube");
  EXPECT_FALSE(not_followed.contains("gaze"));
  EXPECT_EQ(not_followed.dump().find("look is recorded"), std::string::npos);
}

TEST(New, EveryFactorThatIsOfferedCanBeVaried) {
  const TemporaryFolder folder;
  for (const StudyTemplate& each : study_templates()) {
    for (const std::string& factor : each.offered) {
      const ProgramResult made =
          run_program(folder, {"new", "mine", "--template", each.name, "--vary", factor});
      EXPECT_EQ(made.status, 0) << each.name << " " << factor << ": " << made.errors;
      std::filesystem::remove_all(folder / "mine");
    }
  }
}

TEST(New, AStudyIsInTheLanguageOfItsParticipants) {
  for (const auto& language : shipped_languages()) {
    for (const StudyTemplate& shown : study_templates()) {
      for (const OfferedQuestion& asked : offered_questions(shown.name)) {
        SCOPED_TRACE(language.first + " " + shown.name + " " + asked.name);
        StudyChoices choices{"mine", shown.name, {}, asked.name, "", language.first};
        const std::string study = make_study(choices).at("protocol.json");
        for (const char* open : {"THINGS", "SEES", "DOES"}) {
          EXPECT_EQ(study.find(open), std::string::npos) << open;
        }
        EXPECT_EQ(study.find("Thank you") == std::string::npos, language.first != "en");
      }
    }
  }
}

TEST(New, WritesWhatWasChosen) {
  const TemporaryFolder folder;
  const ProgramResult made =
      run_program(folder, {"new", "bounce", "--vary", "restitution=.2,.5,.8", "--vary",
                           "angle_deg=0,30", "--ask", "yes-no", "--question", "Natural?"});
  ASSERT_EQ(made.status, 0) << made.errors;
  const nlohmann::json protocol = read_json(folder / "bounce/protocol.json").value;
  EXPECT_EQ(protocol["name"], "bounce");
  EXPECT_EQ(protocol["yes_no"]["question"], "Natural?");
  EXPECT_EQ(protocol["design"]["factors"][0]["levels"], nlohmann::json({0.2, 0.5, 0.8}));
  EXPECT_EQ(protocol["design"]["factors"][1]["name"], "angle_deg");
  EXPECT_EQ(protocol["design"]["repetitions"], 10);
  EXPECT_FALSE(protocol.contains("language"));
  const nlohmann::json observer = read_json(folder / "bounce/observer.json").value;
  EXPECT_EQ(observer["of"]["factor"], "restitution");
  EXPECT_EQ(observer["parameters"]["threshold"]["value"], 0.5);
  EXPECT_EQ(lines_of(made.output),
            (std::vector<std::string>{
                "bounce: protocol.json, scene.json, observer.json, and protocol.md, which explains "
                "them",
                "Try next:", "  impetus check bounce/protocol.json",
                "  impetus run bounce/protocol.json --db bounce/study.sqlite --observer "
                "bounce/observer.json --participants 10",
                "  impetus report bounce/study.sqlite --out bounce/report/"}));
}

TEST(New, AnyValueOfTheSceneCanBeVaried) {
  const TemporaryFolder folder;
  expect_runs(folder, {"--vary", "/bodies/0/density_kg_m3=500,1000"});
}

TEST(New, RefusesInASentenceAndLeavesNothing) {
  const TemporaryFolder folder;
  const auto refused = [&](std::vector<std::string> choices) {
    choices.insert(choices.begin(), {"new", "mine"});
    const ProgramResult made = run_program(folder, choices);
    EXPECT_EQ(made.status, 2);
    EXPECT_FALSE(std::filesystem::exists(folder / "mine"));
    return made.errors;
  };
  EXPECT_EQ(refused({"--template", "three-balls"}),
            "impetus: --template: expected one of two-balls, two-blocks, two-figures, "
            "blocks-in-a-cube, blocks-by-gaze, got "
            "three-balls\n");
  EXPECT_EQ(refused({"--template", "study"}),
            "impetus: --template: expected one of two-balls, two-blocks, two-figures, "
            "blocks-in-a-cube, blocks-by-gaze, got "
            "study\n");
  EXPECT_EQ(refused({"--ask", "maybe"}),
            "impetus: --ask: expected one of yes-no, detection, rating, two-interval, click, got "
            "maybe\n");
  EXPECT_EQ(refused({"--vary", "weight=1,2"}),
            "impetus: --vary: expected one of restitution, angle_deg, speed_deg_s, delay_ms, "
            "gap_arcmin, offset_deg, or a JSON Pointer into the scene, got weight\n");
  for (const std::string levels : {"restitution=.2,.5,", "restitution=.2,x"}) {
    EXPECT_EQ(
        refused({"--vary", levels}),
        "impetus: --vary: expected levels of restitution that are all numbers or all words, got " +
            levels + "\n");
  }
  EXPECT_EQ(refused({"--vary", "restitution=1"}),
            "impetus: --vary: expected restitution= and two levels or more, got restitution=1\n");
  EXPECT_EQ(
      refused({"--levels", "quest"}),
      "impetus: --levels quest: expected --ask detection or two-interval, whose answers become "
      "right as levels rise, got yes-no\n");
  EXPECT_EQ(refused({"--levels", "some"}),
            "impetus: --levels: expected all, staircase or quest, got some\n");
  EXPECT_EQ(
      refused({"--levels", "quest", "--ask", "detection", "--vary", "speed_deg_s"}),
      "impetus: --levels: to choose from, expected four numbers or more of speed_deg_s, rising "
      "from hard to easy, got [5,10]\n");
  const std::string beyond = refused({"--vary", "restitution=.5,2"});
  EXPECT_NE(beyond.find("; nothing was written\n"), std::string::npos) << beyond;
  EXPECT_EQ(beyond.find("partial"), std::string::npos) << beyond;
}

TEST(New, ARefusalLeavesNoneOfTheFoldersAboveBehind) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "mine");
  const auto made = [&](const char* level) {
    return run_program(
        folder, {"new", "mine/of/this/study", "--vary", "restitution=.5," + std::string(level)});
  };
  const ProgramResult refused = made("2");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.errors.find("; nothing was written\n"), std::string::npos) << refused.errors;
  EXPECT_TRUE(std::filesystem::is_empty(folder / "mine"));
  const ProgramResult fine = made(".8");
  EXPECT_EQ(fine.status, 0) << fine.errors;
  EXPECT_TRUE(std::filesystem::exists(folder / "mine/of/this/study/protocol.json"));
}

TEST(New, OverwritesNothing) {
  const TemporaryFolder folder;
  folder.write("mine", "");
  EXPECT_EQ(run_program(folder, {"new", "mine"}).errors,
            "impetus: mine: exists already and is not overwritten\n");
}

// ---------------------------------------------------------------- simulated participants

TEST(Observers, AreListedAndExplainedFromAnyFolder) {
  const TemporaryFolder folder;
  const ProgramResult all = run_program(folder, {"observers"});
  EXPECT_EQ(all.status, 0) << all.errors;
  for (const char* words : {"causality-thresholds", "the delay at contact", "psychometric"}) {
    EXPECT_NE(all.output.find(words), std::string::npos) << words;
  }
  const ProgramResult one = run_program(folder, {"observers", "gap"});
  EXPECT_NE(one.output.find("10 arcmin"), std::string::npos) << one.output << one.errors;
  const ProgramResult kind = run_program(folder, {"observers", "psychometric"});
  EXPECT_NE(kind.output.find("weibull"), std::string::npos) << kind.output << kind.errors;
  EXPECT_EQ(run_program(folder, {"observers", "nobody"}).status, 2);
}

TEST(Observers, WhoLooksAtNothingThatVariesIsWarnedOf) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program(folder, {"new", "bounce"}).status, 0);
  const ProgramResult checked =
      run_program(folder, {"check", "bounce/protocol.json", "--observer", "causality"});
  EXPECT_EQ(checked.status, 0);
  EXPECT_NE(checked.errors.find("looks at the delay at contact, which no factor that varies "
                                "changes (restitution): its answers will not depend on them\n"),
            std::string::npos)
      << checked.errors;
}

std::size_t count_of(const std::string& text, const std::string& words) {
  std::size_t count = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) {
    ++count;
  }
  return count;
}

/// What the program says to who types these lines at its terminal.
ProgramResult typed(const TemporaryFolder& folder, const std::vector<std::string>& arguments,
                    const std::string& lines) {
  const int keyboard = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  EXPECT_TRUE(keyboard >= 0 && grantpt(keyboard) == 0 && unlockpt(keyboard) == 0);
  const int terminal = open(ptsname(keyboard), O_RDWR | O_NOCTTY | O_CLOEXEC);
  EXPECT_EQ(write(keyboard, lines.data(), lines.size()), static_cast<ssize_t>(lines.size()));
  ProgramResult result =
      run_program(folder, arguments, [terminal] { dup2(terminal, STDIN_FILENO); });
  close(terminal);
  close(keyboard);
  return result;
}

TEST(New, AnAnswerThatLeadsToNoStudyIsSaidAtOnceAndAskedAgain) {
  const TemporaryFolder folder;
  const ProgramResult result = typed(folder, {"new", "mine"},
                                     "xx\n\n"                                 // language
                                     "one-ball\ntwo-balls\n"                  // template
                                     "mass=1,2\nrestitution=5,6\ndelay_ms\n"  // factor
                                     "nothing\ndetection\n"                   // question
                                     "Seen?\n"                                // its words
                                     "dice\nstaircase\n");                    // levels
  EXPECT_EQ(result.status, 0) << result.errors;
  for (const char* refusal :
       {"/language: expected one of", "--template: expected one of two-balls",
        "--vary: expected one of restitution", "levels/0: expected a number ≥ 0 and ≤ 1, got 5",
        "--ask: expected one of yes-no", "--levels: expected all, staircase or quest, got dice"}) {
    EXPECT_EQ(count_of(result.output, refusal), 1U) << refusal << "\n" << result.output;
  }
  const auto protocol = nlohmann::json::parse(text_of(folder / "mine/protocol.json"));
  EXPECT_EQ(protocol["yes_no"]["question"], "Seen?");
  EXPECT_TRUE(protocol["design"].contains("adaptive"));
}

TEST(New, WithLevelsOfTheirOwnTooFewForAStaircaseNoneIsOffered) {
  const TemporaryFolder folder;
  const ProgramResult few = typed(folder, {"new", "few"}, "\n\nrestitution=.2,.8\ndetection\n\n");
  EXPECT_EQ(few.status, 0) << few.output << few.errors;
  EXPECT_EQ(count_of(few.output, "Which levels are shown?"), 0U) << few.output;
}

}  // namespace impetus::new_test
