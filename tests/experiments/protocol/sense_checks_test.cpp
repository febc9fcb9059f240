// What passes every check by itself and cannot be meant, each refused with one sentence.
// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/sense_checks.hpp"

#include "tests/experiments/refusals.hpp"

namespace impetus::sense_checks_test {

std::string nonsense(const Study& study) {
  const Protocol protocol = study.made();  // every other check finds no fault
  const std::string said = refusal([&] { check_sense(protocol); });
  return said == "accepted" ? said : said.substr(std::string(kProtocolName).size() + 1);
}

/// A fourth factor.
Study with_factor(const char* factor) {
  return Study()
      .without("/design/practice_until")
      .without("/design/practice")
      .with("/yes_no", json::parse(R"({"question": "Natural?"})"))
      .with("/design/factors/3", json::parse(factor));
}

TEST(Sense, TheShippedStudyHasIt) { EXPECT_EQ(nonsense(Study()), "accepted"); }

TEST(Sense, AFactorWithinAnotherOneUndoesIt) {
  EXPECT_EQ(nonsense(with_factor(R"({"name": "all", "levels": ["a", "b"], "sets": {
                "a": {"/imposed": {"contact_hold_ms": 0}},
                "b": {"/imposed": {"contact_hold_ms": 300}}}})")),
            "/design/factors/3: expected values that no other factor overrides, got \"/imposed\" "
            "beside \"/imposed/contact_hold_ms\"");
}

TEST(Sense, ACatchTrialHasKeysThatSomebodyCanPress) {
  Study study = with_factor(R"({"name": "keys", "keys_of": "yes_no", "levels": ["f j", "j f"]})");
  const auto caught = [&](const char* keys) {
    return study.with(
        "/design/catch_trials",
        {{{"count", 1},
          {"condition",
           {{"delay_ms", 0}, {"speed_deg_s", 10}, {"viewpoint_deg", 0}, {"keys", keys}}}}});
  };
  EXPECT_EQ(nonsense(caught("j f")), "accepted");
  for (const char* keys : {"a b c", "zzz", "x y"}) {
    EXPECT_EQ(nonsense(caught(keys)),
              "/design/catch_trials/0/condition/keys: expected one of the factor's levels [\"f "
              "j\",\"j f\"], got " +
                  json(keys).dump());
  }
}

TEST(Sense, AQuestionHasNoKeysBesideAFactorOfThem) {
  Study study = with_factor(R"({"name": "keys", "keys_of": "yes_no", "levels": ["f j", "j f"]})");
  EXPECT_EQ(nonsense(study), "accepted");
  EXPECT_EQ(nonsense(study.with("/yes_no/keys", "a b")),
            "/yes_no/keys: expected none beside the factor \"keys\", whose levels are the keys, "
            "got \"a b\"");
}

TEST(Sense, OptionsAndBoundsAreOfFieldsThatHaveThem) {
  Study study;
  EXPECT_EQ(nonsense(study.with("/session/demographics/0/options", {"young", "old"})),
            "/session/demographics/0/options: expected none, for the field is no choice");
  EXPECT_EQ(nonsense(study.without("/session/demographics/0/options")
                         .with("/session/demographics/1/minimum", 1)),
            "/session/demographics/1/minimum: expected none, for the field is no number");
}

TEST(Sense, EachScaleIsAskedInSomeTrial) {
  const auto asked = [](const json& first_when, const json& second_when) {
    json scales =
        json::parse(R"([{"question": "A?", "minimum": 0, "maximum": 1, "words": ["a", "b"]},
                                  {"question": "B?", "minimum": 0, "maximum": 1, "words": ["a", "b"]}])");
    scales[0]["when"] = first_when;
    scales[1]["when"] = second_when;
    return nonsense(Study()
                        .without("/design/practice_until")
                        .without("/design/practice")
                        .without("/rating")
                        .with("/slider", {{"scales", scales}}));
  };
  EXPECT_EQ(asked({{"delay_ms", 0}}, json::object()), "accepted");
  EXPECT_EQ(asked(json::object(), {{"delay_ms", 0}}),
            "/slider/scales/1: expected a scale that some trial asks, but each asks one that is "
            "before it");
}

TEST(Sense, TheStandardOfTwoIntervalsChangesTheScene) {
  Study study = with_factor(R"({"name": "word", "levels": ["a", "b"], "sets": {
      "a": {"/engine/restitution": 1}, "b": {"/engine/restitution": 0.5}}})");
  study.without("/yes_no").with("/two_interval", json::parse(R"({"question": "Which?"})"));
  const auto standard = [&](const json& levels) {
    return nonsense(study.with("/two_interval/standard", levels));
  };
  EXPECT_EQ(standard({{"word", "a"}}), "accepted");
  EXPECT_EQ(standard({{"word", "zzz"}}),
            "/two_interval/standard/word: expected a word that \"sets\" has, got \"zzz\"");
  study.with("/design/factors/3", json::parse(R"({"name": "word", "keys_of": "two_interval",
                                                  "levels": ["f j", "j f"]})"));
  EXPECT_EQ(standard({{"word", "j f"}}),
            "/two_interval/standard: expected a level that changes the scene, or both intervals "
            "show the same, got {\"word\":\"j f\"}");
}

TEST(Sense, QuestPlusOfTwoIntervalsExpectsThatHalfIsGuessed) {
  const auto guessed = [](const json& rates) {
    return nonsense(
        Study()
            .without("/design/longest_runs")
            .with("/design/repetitions", 1)
            .with("/two_interval",
                  json::parse(R"({"question": "Which?", "standard": {"delay_ms": 0}})"))
            .with("/design/adaptive", json::parse(R"({"factor": "delay_ms", "trials_per_track": 10,
                "quest_plus": {"function": "normal", "scale": "linear", "thresholds": [50, 100],
                               "slopes": [20], "lapse_rates": [0.02]}})"))
            .with("/design/adaptive/quest_plus/guess_rates", rates));
  };
  EXPECT_EQ(guessed({0.5}), "accepted");
  EXPECT_EQ(guessed({0.5, 0.1}),
            "/design/adaptive/quest_plus/guess_rates: expected rates of at least 0.5, which "
            "guessing between two intervals reaches, got 0.1");
}

TEST(Sense, TrainingGoesThroughAllThatThereIsToTrainWith) {
  const auto trained = [](int most) {
    return nonsense(
        Study()
            .without("/design/practice_until")
            .with("/yes_no",
                  json::parse(
                      R"({"question": "Late?", "right_when": {"factor": "delay_ms", "above": 0}})"))
            .with("/design/train_until", {{"right", 1}, {"of", 1}, {"most_trials", most}}));
  };
  const auto practice =
      static_cast<int>(json::parse(shipped(kProtocolName))["design"]["practice"].size());
  ASSERT_GT(practice, 1);
  EXPECT_EQ(trained(practice), "accepted");
  EXPECT_EQ(trained(practice - 1), "/design/train_until/most_trials: expected at least the " +
                                       std::to_string(practice) + " trials of practice, got " +
                                       std::to_string(practice - 1));
}

TEST(Sense, NoContactHoldsWhatPassesThrough) {
  EXPECT_EQ(nonsense(Study().scene_with("/bodies/0/passes_through", true))
                .substr(0, std::string("/design/factors: expected a contact_hold_ms of 0").size()),
            "/design/factors: expected a contact_hold_ms of 0");
}

TEST(Sense, ASoundComesWhileTheSceneIsShown) {
  const auto sounding = [](json sound) {
    sound["kind"] = "tone";
    return nonsense(Study().scene_with("/meeting/lead_s", 0.5).scene_with("/sound", sound));
  };
  EXPECT_EQ(sounding({{"lag_ms", -500}}), "accepted");
  const std::string early =
      "/design/factors: expected a sound's lag_ms of at least -500, or it would come before the "
      "stimulus, got -600 under {";
  EXPECT_EQ(sounding({{"lag_ms", -600}}).substr(0, early.size()), early);
  EXPECT_EQ(sounding({{"at_s", 3000}}).substr(0, 61),
            "/design/factors: expected a sound's at_s of at most the 1.5 s");
}

}  // namespace impetus::sense_checks_test
