// Questions that do not fit their protocol are refused by name.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "tests/experiments/asked_study.hpp"

namespace impetus::response_checks_test {

TEST(ResponseChecks, SomethingMustBeAsked) {
  EXPECT_EQ(asked_refusal(asked_protocol({})),
            "asked.json:/: expected something that participants answer, a key \"rating\", "
            "\"yes_no\", \"two_interval\", \"choice\", \"slider\", \"free_text\" or \"clicks\", "
            "but there is none");
  for (const char* question :
       {kAskRating, kAskYesNo, kAskTwoInterval, kAskChoice, kAskSlider, kAskFreeText, kAskClicks}) {
    EXPECT_EQ(asked_refusal(asked_protocol({question})), "accepted") << question;
  }
}

TEST(ResponseChecks, OptionsOfAChoiceDifferAndOneIsRightAtEachLevel) {
  const auto refused = [](const char* pointer, const json& value) {
    json protocol = asked_protocol({kAskChoice});
    protocol[json::json_pointer(pointer)] = value;
    return asked_refusal(protocol);
  };
  EXPECT_EQ(refused("/choice/options", {"a hit"}),
            "asked.json:/choice/options: expected a list of 2 to 9 values, got [\"a hit\"]");
  EXPECT_EQ(refused("/choice/options/2", "a hit"),
            "asked.json:/choice/options/2: expected options that differ, got \"a hit\" twice");
  EXPECT_EQ(refused("/choice/right_when/options/0", "a kiss"),
            "asked.json:/choice/right_when/options/0: expected one of the options, got \"a kiss\"");
  EXPECT_EQ(
      refused("/choice/right_when/options", {{"0", "a hit"}}),
      "asked.json:/choice/right_when/options: expected an option for every level of delay_ms, "
      "got none for 300");
  EXPECT_EQ(refused("/choice/right_when/factor", "gap"),
            "asked.json:/choice/right_when/factor: expected the name of a factor, got \"gap\"");
  EXPECT_EQ(refused("/choice/right_when", {{"factor", "delay_ms"}}),
            "asked.json:/choice/right_when: expected the key \"options\", which is missing");
  EXPECT_EQ(
      refused("/choice/keys", "f j"),
      "asked.json:/choice/keys: expected 3 keys that differ, letters from a to z or digits, a "
      "blank between (\"f j\"), got \"f j\"");
  EXPECT_EQ(refused("/choice/keys", "f g h"), "accepted");
  EXPECT_EQ(refused("/exclude_when", {{"practice_right_below", 2}}),
            "asked.json:/exclude_when: expected a question that rules of answers go by, a key "
            "\"yes_no\" or \"two_interval\", but there is none");
}

TEST(ResponseChecks, ASliderHasAScaleForEveryCondition) {
  json protocol = asked_protocol({kAskSlider});
  json& scale = protocol["slider"]["scales"][0];
  scale["when"] = {{"delay_ms", 0}};
  EXPECT_EQ(asked_refusal(protocol),
            "asked.json:/slider/scales: expected a scale for every condition, got none for "
            "{\"delay_ms\":300}");
  scale["when"] = {{"delay_ms", 20}};
  EXPECT_EQ(asked_refusal(protocol),
            "asked.json:/slider/scales/0/when: expected a level of delay_ms, got 20");
  scale["when"] = {{"delay_ms", 0}};
  json of_the_other = scale;
  of_the_other["when"] = {{"delay_ms", 300}};
  protocol["slider"]["scales"].push_back(of_the_other);
  EXPECT_EQ(asked_refusal(protocol), "accepted");
  const json good = protocol;
  const std::string none_for_150 =
      "asked.json:/slider/scales: expected a scale for every condition, got none for "
      "{\"delay_ms\":150}";
  protocol["design"]["practice"][0]["delay_ms"] = 150;
  EXPECT_EQ(asked_refusal(protocol), none_for_150);
  protocol = good;
  protocol["design"]["catch_trials"] = {{{"condition", {{"delay_ms", 150}}}, {"count", 1}}};
  EXPECT_EQ(asked_refusal(protocol), none_for_150);
}

TEST(ResponseChecks, ASlidersScaleHasItsEndsInOrder) {
  json protocol = asked_protocol({kAskSlider});
  json& scale = protocol["slider"]["scales"][0];
  scale["when"] = {{"gap", 0}};
  EXPECT_EQ(asked_refusal(protocol),
            "asked.json:/slider/scales/0/when: expected the name of a factor, got \"gap\"");
  scale.erase("when");
  scale["minimum"] = 100;
  EXPECT_EQ(asked_refusal(protocol),
            "asked.json:/slider/scales/0/maximum: expected more than the minimum 100, got 100");
}

TEST(ResponseChecks, AFactorMayChangeNothingButTheQuestion) {
  json protocol = asked_protocol({kAskSlider});
  protocol["design"]["factors"].push_back(
      json::parse(R"({"name": "asked", "between": true, "levels": ["how late", "how odd"]})"));
  EXPECT_EQ(asked_refusal(protocol),
            "asked.json:/design/factors/1: expected the key \"pointer\", which is missing");
  json odd = protocol["slider"]["scales"][0];
  odd["question"] = "How odd was it?";
  odd["when"] = {{"asked", "how odd"}};
  protocol["slider"]["scales"].insert(protocol["slider"]["scales"].begin(), odd);
  EXPECT_EQ(asked_refusal(protocol), "accepted");
}

TEST(ResponseChecks, YesIsRightByAFactorOfNumbers) {
  json protocol = asked_protocol({kAskYesNo});
  protocol["yes_no"]["right_when"]["factor"] = "gap";
  EXPECT_EQ(asked_refusal(protocol),
            "asked.json:/yes_no/right_when/factor: expected the name of a factor, got \"gap\"");
  protocol["yes_no"]["right_when"]["factor"] = "colour";
  protocol["design"]["factors"].push_back(json::parse(
      R"({"name": "colour", "pointer": "/bodies/0/colour", "levels": ["#ffffff", "#000000"]})"));
  EXPECT_EQ(asked_refusal(protocol),
            "asked.json:/yes_no/right_when/factor: expected a factor whose levels are numbers, got "
            "\"colour\", which has \"#ffffff\"");
}

TEST(ResponseChecks, WhoIsLeftOutByRulesIsAskedWhatTheyGoBy) {
  const auto refused = [](json protocol, const json& rules) {
    protocol["exclude_when"] = rules;
    return asked_refusal(protocol);
  };
  const json yes_no = asked_protocol({kAskYesNo});
  EXPECT_EQ(refused(yes_no, {{"equal_answers_in_a_row", 4}, {"practice_right_below", 2}}),
            "accepted");
  EXPECT_EQ(refused(yes_no, {{"practice_right_below", 3}}),
            "asked.json:/exclude_when/practice_right_below: expected at most the 2 trials of "
            "practice, got 3");
  json unknown = asked_protocol({kAskYesNo, kAskChoice});  // the rule goes by no choices
  unknown["yes_no"].erase("right_when");
  EXPECT_EQ(refused(unknown, {{"practice_right_below", 1}}),
            "asked.json:/exclude_when/practice_right_below: expected a question that has a right "
            "answer (yes_no with right_when, or two_interval), but there is none");
  EXPECT_EQ(refused(asked_protocol({kAskRating}), {{"equal_answers_in_a_row", 4}}),
            "asked.json:/exclude_when: expected a question that rules of answers go by, a key "
            "\"yes_no\" or \"two_interval\", but there is none");
  EXPECT_EQ(refused(yes_no, {{"equal_answers_in_a_row", 1}}),
            "asked.json:/exclude_when/equal_answers_in_a_row: expected a whole number ≥ 2 and ≤ "
            "10000, got 1");
}

TEST(ResponseChecks, YesIsRightWhereTwoBodiesTouch) {
  const auto refused = [](const json& right_when) {
    json protocol = asked_protocol({kAskYesNo});
    protocol["yes_no"]["right_when"] = right_when;
    return asked_refusal(protocol);
  };
  EXPECT_EQ(refused({{"touch", {"left", "right"}}}), "accepted");
  EXPECT_EQ(refused({{"touch", {"left", "middle"}}}),
            "asked.json:/yes_no/right_when/touch/1: expected the name of a body of the scene, got "
            "\"middle\"");
  EXPECT_EQ(refused({{"touch", {"left", "left"}}}),
            "asked.json:/yes_no/right_when/touch: expected two bodies, got \"left\" twice");
  EXPECT_EQ(refused({{"touch", {"left"}}}),
            "asked.json:/yes_no/right_when/touch: expected a list of 2 values, got [\"left\"]");
  const std::string either =
      "asked.json:/yes_no/right_when: expected either \"factor\" and \"above\" or \"touch\"";
  EXPECT_EQ(refused({{"touch", {"left", "right"}}, {"above", 0}}), either);
  EXPECT_EQ(refused(json::object()), either);
  EXPECT_EQ(refused({{"factor", "delay_ms"}}),
            "asked.json:/yes_no/right_when: expected the key \"above\", which is missing");
}

TEST(ResponseChecks, TheStandardNamesFactorsAndHasLevelsThatTheSceneCanShow) {
  const auto refused = [](const json& standard) {
    json protocol = asked_protocol({kAskTwoInterval});
    protocol["two_interval"]["standard"] = standard;
    return asked_refusal(protocol);
  };
  EXPECT_EQ(refused({{"gap", 0}}),
            "asked.json:/two_interval/standard: expected only factors of the design, got \"gap\"");
  EXPECT_EQ(refused(json::object()),
            "asked.json:/two_interval/standard: expected at least one level, or both intervals "
            "show the same, got {}");
  EXPECT_EQ(refused({{"delay_ms", "long"}}),
            "asked.json:/two_interval/standard/delay_ms: expected a number ≥ 0 and ≤ 60000, got "
            "\"long\"");
  EXPECT_EQ(
      refused({{"delay_ms", -100}}),
      "asked.json:/two_interval/standard/delay_ms: expected a number ≥ 0 and ≤ 60000, got -100");
  EXPECT_EQ(refused({{"delay_ms", 100}}), "accepted");
}

TEST(ResponseChecks, TheStandardAndTheBlankFallOnFrames) {
  const auto refused = [](const json& standard, double between_ms, bool allow_rounding) {
    json protocol = asked_protocol({kAskTwoInterval});
    protocol["two_interval"]["standard"] = standard;
    protocol["two_interval"]["between_ms"] = between_ms;
    return refusal([&] { check_frames(study_of(protocol), 60.0, allow_rounding); });
  };
  EXPECT_EQ(refused({{"delay_ms", 90}}, 500, false),
            "asked.json:/two_interval/standard/delay_ms: expected a whole number of 60 Hz frames "
            "(16.67 ms), got 90");
  EXPECT_EQ(refused({{"delay_ms", 100}}, 510, false),
            "asked.json:/two_interval/between_ms: expected a whole number of 60 Hz frames (16.67 "
            "ms), got 510");
  EXPECT_EQ(refused({{"delay_ms", 90}}, 510, true), "accepted");
  EXPECT_EQ(refused({{"delay_ms", 100}}, 500, false), "accepted");
}

json with_training(json protocol) {
  protocol["design"]["train_until"] = json::parse(R"({"right": 1, "of": 2, "most_trials": 9})");
  return protocol;
}

TEST(ResponseChecks, TrainingNeedsARightAnswerAndPracticeAndNoOtherRule) {
  EXPECT_EQ(asked_refusal(with_training(asked_protocol({kAskYesNo}))), "accepted");
  EXPECT_EQ(asked_refusal(with_training(asked_protocol({kAskTwoInterval}))), "accepted");
  json without_rule = with_training(asked_protocol({kAskYesNo, kAskRating}));
  without_rule["yes_no"].erase("right_when");
  EXPECT_EQ(asked_refusal(without_rule),
            "asked.json:/design/train_until: expected a question that has a right answer (yes_no "
            "or choice with right_when, or two_interval), but there is none");
  json untrained = with_training(asked_protocol({kAskYesNo}));
  untrained["design"].erase("practice");
  EXPECT_EQ(asked_refusal(untrained),
            "asked.json:/design/train_until: expected conditions to train with in "
            "/design/practice, but there are none");
  json both = with_training(asked_protocol({kAskYesNo, kAskRating}));
  both["design"]["practice_until"] =
      json::parse(R"({"factor": "delay_ms", "best": 0, "worst": 300, "rounds": 2})");
  EXPECT_EQ(asked_refusal(both),
            "asked.json:/design/train_until: expected either this or practice_until, but both are "
            "there");
}

TEST(ResponseChecks, PracticeUntilNeedsARating) {
  json protocol = asked_protocol({kAskYesNo});
  protocol["design"]["practice_until"] =
      json::parse(R"({"factor": "delay_ms", "best": 0, "worst": 300, "rounds": 2})");
  EXPECT_EQ(asked_refusal(protocol),
            "asked.json:/design/practice_until: expected the key \"rating\" in the protocol, "
            "because the best level must be rated better than the worst, but it is missing");
}

TEST(ResponseChecks, ATimeLimitIsPositive) {
  for (const char* kind : {"rating", "yes_no", "two_interval"}) {
    json protocol = asked_protocol({kAskRating, kAskYesNo, kAskTwoInterval});
    protocol[kind]["timeout_ms"] = 0;
    EXPECT_EQ(asked_refusal(protocol),
              std::string("asked.json:/") + kind +
                  "/timeout_ms: expected a number > 0 and ≤ 600000, got 0");
  }
}

}  // namespace impetus::response_checks_test
