// Designs that cannot be run as written: blocks, catch trials, adaptive levels, training; each is
// refused with one sentence.
// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::adaptive_refusals_test {

constexpr const char* kStaircase =
    R"({"factor": "delay_ms", "trials_per_track": 10,
        "staircase": {"up": 1, "down": 2, "starts": [300, 0]}})";
constexpr const char* kQuestPlus =
    R"({"factor": "delay_ms", "trials_per_track": 10,
        "quest_plus": {"function": "normal", "scale": "linear", "thresholds": [50, 100, 200],
                       "slopes": [20, 40], "guess_rates": [0, 0.05], "lapse_rates": [0.02]}})";

/// The shipped study, made adaptive, with a question that is answered yes or no.
Study adaptive(const char* method) {
  return Study()
      .with("/yes_no", json::parse(R"({"question": "Did you see a delay?"})"))
      .with("/design/repetitions", 1)
      .without("/design/longest_runs")
      .with("/design/adaptive", json::parse(method));
}

Study two_interval(const char* method) {
  return adaptive(method).without("/yes_no").with(
      "/two_interval",
      json::parse(R"({"question": "Which had a delay?", "standard": {"delay_ms": 0}})"));
}

std::string sentence(const std::string& words) { return std::string(kProtocolName) + ":" + words; }

void expect_refusals(const char* method, const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    EXPECT_EQ(adaptive(method).with(one.pointer, one.value).refused(), sentence(one.sentence));
  }
}

TEST(AdaptiveRefusal, SoundDesignsAreNone) {
  EXPECT_EQ(adaptive(kStaircase).refused(), "accepted");
  EXPECT_EQ(adaptive(kQuestPlus).refused(), "accepted");
  EXPECT_EQ(two_interval(kStaircase).refused(), "accepted");
}

TEST(AdaptiveRefusal, TheFactorMustHaveLevelsInOrder) {
  expect_refusals(
      kStaircase,
      {{"/design/adaptive/factor", "gap",
        "/design/adaptive/factor: expected the name of a factor, got \"gap\""},
       {"/design/factors/0/levels", json::array({0, 300, 100}),
        "/design/factors/0/levels: expected levels from hard to easy, all rising or all falling, "
        "as the factor is adaptive, got [0,300,100]"},
       {"/design/factors/0/levels", json::array({100}),
        "/design/factors/0/levels: expected at least 2 levels to choose from, as the factor is "
        "adaptive, got [100]"},
       {"/design/factors/0/levels", json::array({"a", "b"}),
        "/design/factors/0/levels: expected numbers, as the factor is adaptive, got "
        "[\"a\",\"b\"]"}});
}

TEST(AdaptiveRefusal, OneMethodChoosesTheLevels) {
  const json quest_plus = json::parse(kQuestPlus)["quest_plus"];
  expect_refusals(
      kStaircase,
      {{"/design/adaptive/quest_plus", quest_plus,
        "/design/adaptive: expected either \"staircase\" or \"quest_plus\", got both"}});
  EXPECT_EQ(adaptive(kStaircase).without("/design/adaptive/staircase").refused(),
            sentence("/design/adaptive: expected either \"staircase\" or \"quest_plus\", got "
                     "neither"));
}

TEST(AdaptiveRefusal, AStaircaseStartsAtALevel) {
  expect_refusals(kStaircase,
                  {{"/design/adaptive/staircase/starts/1", 50,
                    "/design/adaptive/staircase/starts/1: expected one of the factor's levels "
                    "[0,100,300], got 50"}});
}

TEST(AdaptiveRefusal, TracksSayHowManyTrialsThereAreAndRunsCannotBeOfTheirLevels) {
  expect_refusals(
      kStaircase,
      {{"/design/repetitions", 3,
        "/design/repetitions: expected 1 with adaptive levels, where trials_per_track says how "
        "many trials there are, got 3"},
       {"/design/longest_runs", json::parse(R"([{"factor": "delay_ms", "longest": 3}])"),
        "/design/longest_runs/0/factor: expected a factor whose levels are known beforehand, got "
        "\"delay_ms\", which is adaptive"},
       {"/design/adaptation",
        json::parse(R"([{"when": {"delay_ms": 0}, "first": 1, "before_each": 1,
            "conditions": [{"delay_ms": 0, "speed_deg_s": 5, "viewpoint_deg": 0}]}])"),
        "/design/adaptation/0/when/delay_ms: expected a factor whose levels are known beforehand, "
        "got \"delay_ms\", which is adaptive"},
       {"/design/adaptive/trials_per_track", 1000,
        "/design: expected at most 10000 trials, got 18000 (all tracks, catch trials and "
        "adaptation "
        "counted)"}});
}

TEST(AdaptiveRefusal, RatingsHaveNoThreshold) {
  EXPECT_EQ(adaptive(kStaircase).without("/yes_no").refused(),
            sentence("/: expected the key \"yes_no\" or \"two_interval\", because adaptive levels "
                     "follow answers that are positive or negative, but both are missing"));
}

TEST(AdaptiveRefusal, AStaircaseBetweenTwoIntervalsSettlesAboveGuessing) {
  EXPECT_EQ(two_interval(kStaircase).with("/design/adaptive/staircase/down", 1).refused(),
            sentence("/design/adaptive/staircase: expected a rule that settles above 50 % right "
                     "answers, which guessing between two intervals reaches, got 1 up, 1 down, "
                     "which settles at 50.0 %"));
  EXPECT_EQ(adaptive(kStaircase).with("/design/adaptive/staircase/down", 1).refused(), "accepted");
}

TEST(AdaptiveRefusal, ThresholdsMustBeReachable) {
  const std::string place = "/design/adaptive/quest_plus";
  expect_refusals(
      kQuestPlus,
      {{place + "/thresholds/2", 301,
        place + "/thresholds/2: expected a threshold that some level can reach, from 0 to 300 on "
                "the scale, got 301"},
       {place + "/guess_rates/1", 0.98,
        place + "/lapse_rates: expected the largest guess rate and the largest lapse rate to add "
                "up to less than 1, or no level has a higher share of positive answers than "
                "another, got 0.98 and 0.02"},
       {place + "/lapse_rates/0", -0.1,
        place + "/lapse_rates/0: expected a probability of at least 0 and less than 1, got -0.1"},
       {place + "/slopes/1", 0, place + "/slopes/1: expected a number > 0, got 0"},
       {place + "/scale", "log10",
        "/design/factors/0/levels/0: expected a level above 0, which has a logarithm, got 0"},
       {"/design/factors/0/levels", json::array({300, 100, 0}),
        "/design/factors/0/levels: expected levels that rise from hard to easy, because the "
        "functions of QUEST+ rise with the level, got [300,100,0]"}});
  json grid = json::array();
  for (int number = 1; number <= 1000; ++number) {
    grid.push_back(number / 1000.0);
  }
  EXPECT_EQ(adaptive(kQuestPlus)
                .with(place + "/slopes", grid)
                .with(place + "/thresholds", grid)
                .refused(),
            sentence(place + ": expected at most 1000000 combinations of the levels and the grids, "
                             "got 6000000"));
  EXPECT_EQ(adaptive(kQuestPlus)
                .with(place + "/thresholds", json::array({100}))
                .with(place + "/slopes", json::array({20}))
                .with(place + "/guess_rates", json::array({0}))
                .refused(),
            sentence(place + ": expected grids with at least two psychometric functions to tell "
                             "apart, got one"));
}

TEST(AdaptiveRefusal, AWeibullFunctionOfTheLevelItselfNeedsAThresholdAboveZero) {
  const std::string place = "/design/adaptive/quest_plus";
  EXPECT_EQ(adaptive(kQuestPlus)
                .with(place + "/function", "weibull")
                .with(place + "/thresholds/0", 0)
                .refused(),
            sentence(place + "/thresholds/0: expected a threshold above 0, for a Weibull function "
                             "of the level itself, got 0"));
}

// ---------------------------------------------------------------- blocks

TEST(BlockRefusal, BlocksAreOfFactorsWhoseLevelsAreKnown) {
  EXPECT_EQ(Study()
                .with("/design/blocks",
                      json::parse(R"({"factors": ["speed_deg_s", "level"], "order": "random"})"))
                .refused(),
            sentence("/design/blocks/factors/1: expected the name of a factor, got \"level\""));
  EXPECT_EQ(
      adaptive(kStaircase)
          .with("/design/blocks", json::parse(R"({"factors": ["delay_ms"], "order": "fixed"})"))
          .refused(),
      sentence("/design/blocks/factors/0: expected a factor whose levels are known "
               "beforehand, got \"delay_ms\", which is adaptive"));
}

TEST(BlockRefusal, ALatinSquareNeedsACodeWithANumber) {
  const Protocol protocol =
      Study()
          .with("/design/blocks",
                json::parse(R"({"factors": ["speed_deg_s"], "order": "latin-square"})"))
          .made();
  EXPECT_EQ(refusal([&] { plan_for(protocol, "Anna", 1); }),
            "--participant Anna: expected a code that ends in a number, such as P01, because that "
            "number decides the order of the blocks, got \"Anna\"");
  EXPECT_EQ(plan_for(protocol, "P02", 1).size(), 6U + 81U);
}

TEST(BlockRefusal, ABlockOfOneLevelLongerThanItsLongestRunHasNoOrder) {
  const Protocol protocol =
      Study()
          .with("/design/blocks", json::parse(R"({"factors": ["delay_ms"], "order": "random"})"))
          .made();
  EXPECT_EQ(refusal([&] { plan_for(protocol, "P01", 1); }),
            sentence("/design/longest_runs: expected rules that some order of the trials keeps to, "
                     "but none was found"));
}

// ---------------------------------------------------------------- catch trials

Study with_catch(const char* condition) {
  return Study().with("/design/catch_trials",
                      json::array({{{"condition", json::parse(condition)}, {"count", 2}}}));
}

TEST(CatchRefusal, ACatchTrialHasALevelOfTheRightTypeForEveryFactor) {
  const std::string place = "/design/catch_trials/0/condition";
  EXPECT_EQ(with_catch(R"({"delay_ms": 0, "speed_deg_s": 10})").refused(),
            sentence(place + ": expected a level for every factor, but \"viewpoint_deg\" has "
                             "none"));
  EXPECT_EQ(with_catch(R"({"delay_ms": 0, "speed_deg_s": 10, "viewpoint_deg": "front"})").refused(),
            sentence(place + "/viewpoint_deg: expected a number, as the factor's own levels are, "
                             "got \"front\""));
  EXPECT_EQ(
      with_catch(R"({"delay_ms": 0, "speed_deg_s": 10, "viewpoint_deg": 0, "gap": 1})").refused(),
      sentence(place + ": expected only factors of the design, got \"gap\""));
}

TEST(CatchRefusal, ACatchTrialIsCheckedAgainstTheSceneAndTheFramesLikeAnyLevel) {
  EXPECT_EQ(with_catch(R"({"delay_ms": 600, "speed_deg_s": 12, "viewpoint_deg": 0})").refused(),
            "accepted");
  EXPECT_EQ(with_catch(R"({"delay_ms": -1, "speed_deg_s": 10, "viewpoint_deg": 0})").refused(),
            sentence("/design/catch_trials/0/condition/delay_ms: expected a number ≥ 0 and ≤ "
                     "60000, got -1"));
  EXPECT_EQ(refusal([] {
              check_frames(
                  with_catch(R"({"delay_ms": 90, "speed_deg_s": 10, "viewpoint_deg": 0})").made(),
                  60.0, false);
            }),
            sentence("/design/catch_trials/0/condition/delay_ms: expected a whole number of 60 Hz "
                     "frames (16.67 ms), got 90"));
}

TEST(CatchRefusal, TwoKindsAreNotAlike) {
  const json kind = json::parse(
      R"({"condition": {"delay_ms": 0, "speed_deg_s": 10, "viewpoint_deg": 0}, "count": 2})");
  EXPECT_EQ(Study().with("/design/catch_trials", json::array({kind, kind})).refused(),
            sentence("/design/catch_trials/1/condition: expected a condition of its own, got "
                     "{\"delay_ms\":0,\"speed_deg_s\":10,\"viewpoint_deg\":0} again"));
}

// ---------------------------------------------------------------- training

Study trained(const char* rule) {
  return Study()
      .with("/yes_no", json::parse(R"({"question": "Did you see a delay?",
                                       "right_when": {"factor": "delay_ms", "above": 0}})"))
      .with("/design/train_until", json::parse(rule));
}

TEST(TrainingRefusal, ACriterionThatCannotBeMet) {
  EXPECT_EQ(trained(R"({"right": 5, "of": 6, "most_trials": 12})").refused(), "accepted");
  EXPECT_EQ(trained(R"({"right": 7, "of": 6, "most_trials": 12})").refused(),
            sentence("/design/train_until/right: expected at most the 6 trials that are looked at, "
                     "got 7"));
  EXPECT_EQ(trained(R"({"right": 5, "of": 6, "most_trials": 4})").refused(),
            sentence("/design/train_until/of: expected at most the 4 trials that there are "
                     "(most_trials), got 6"));
}

}  // namespace impetus::adaptive_refusals_test
