// What a protocol and its scene must be: every refusal, word for word.
// SPDX-License-Identifier: MIT
#include "experiments/files/protocol_files.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/observer_file.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/settings/schema_sentences.hpp"
#include "tests/experiments/refusals.hpp"
#include "tests/places/places.hpp"

namespace impetus::protocol_test {

// ---------------------------------------------------------------- the protocol's schema

TEST(ProtocolSchema, AnUnknownKeyIsRefused) {
  expect_protocol_refusals(
      {{"/timing/fixation", 500,
        "/timing: expected only the keys \"between_adaptors_ms\", \"fixation_ms\", "
        "\"interval_ms\", got \"fixation\""},
       {"/design/factors/0/level",
        {1},
        "/design/factors/0: expected only the keys \"between\", \"keys_of\", \"label\", "
        "\"levels\", \"name\", \"pointer\", \"sets\", "
        "got \"level\""},
       {"/seed", 1,
        "/: expected only the keys \"$schema\", \"choice\", \"clicks\", \"design\", "
        "\"exclude_when\", "
        "\"free_text\", \"gaze\", "
        "\"language\", \"markers\", \"name\", \"participants\", \"question_order\", \"rating\", "
        "\"scene\", "
        "\"schema_version\", "
        "\"session\", \"slider\", \"solve\", \"source\", \"texts\", \"timing\", "
        "\"title\", \"two_interval\", \"yes_no\", got \"seed\""}});
}

TEST(ProtocolSchema, AMissingKeyIsRefused) {
  EXPECT_EQ(Study().without("/name").refused(),
            "protocols/causality.json:/: expected the key \"name\", which is missing");
  EXPECT_EQ(Study().without("/session/consent/statement").refused(),
            "protocols/causality.json:/session/consent: expected the key \"statement\", which is "
            "missing");
}

TEST(ProtocolSchema, AWrongTypeIsRefused) {
  expect_protocol_refusals(
      {{"/timing/fixation_ms", "500",
        "/timing/fixation_ms: expected a number or a list of 2 values ≥ 0 and ≤ 60000, got "
        "\"500\""},
       {"/design/repetitions", 1.5,
        "/design/repetitions: expected a whole number ≥ 1 and ≤ 1000, got 1.5"},
       {"/design/factors/0/levels/1",
        {1},
        "/design/factors/0/levels/1: expected a number, a text, a boolean or a null, got [1]"},
       {"/design/practice/0/delay_ms",
        {1},
        "/design/practice/0/delay_ms: expected a number, a text, a boolean or a null, got [1]"},
       {"/session", json::array(), "/session: expected an object, got []"},
       {"/session/welcome/paragraphs", "Hello",
        "/session/welcome/paragraphs: expected a list, got \"Hello\""},
       {"/title", 3, "/title: expected a text that is not empty, got 3"}});
  EXPECT_EQ(refusal([] { make_protocol(parse_json("a.json", "[]"), parse_json("b.json", "{}")); }),
            "a.json:/: expected an object, got []");
}

TEST(ProtocolSchema, AnEmptyFactorOrDesignIsRefused) {
  expect_protocol_refusals(
      {{"/design/factors/0/levels", json::array(),
        "/design/factors/0/levels: expected a list of at least 1 value without repeats, got []"},
       {"/design/factors", json::array(),
        "/design/factors: expected a list of at least 1 value, got []"}});
}

TEST(ProtocolSchema, AValueOutOfRangeIsRefused) {
  expect_protocol_refusals(
      {{"/timing/fixation_ms", -5,
        "/timing/fixation_ms: expected a number or a list of 2 values ≥ 0 and ≤ 60000, got -5"},
       {"/design/repetitions", 0,
        "/design/repetitions: expected a whole number ≥ 1 and ≤ 1000, got 0"},
       {"/design/longest_runs/0/longest", 0,
        "/design/longest_runs/0/longest: expected a whole number ≥ 1, got 0"},
       {"/design/factors/0/levels",
        {0, 100, 100},
        "/design/factors/0/levels: expected a list of at least 1 value without repeats, got "
        "[0,100,100]"},
       {"/session/demographics/1/options",
        {"one"},
        "/session/demographics/1/options: expected a list of at least 2 values, got [\"one\"]"},
       {"/session/demographics/1/kind", "menu",
        "/session/demographics/1/kind: expected one of \"number\", \"choice\", \"text\", got "
        "\"menu\""},
       {"/schema_version", 2, "/schema_version: expected 1, got 2"}});
}

TEST(ProtocolSchema, ATextOfTheWrongFormIsRefusedInWordsAndNotARegularExpression) {
  expect_protocol_refusals(
      {{"/name", "Causality",
        "/name: expected a text of lower-case letters, digits and hyphens that begins with a "
        "letter, got \"Causality\""},
       {"/design/factors/0/name", "Delay (ms)",
        "/design/factors/0/name: expected a text of lower-case letters, digits and underscores "
        "that begins with a letter, got \"Delay (ms)\""},
       {"/design/factors/0/pointer", "delay",
        "/design/factors/0/pointer: expected a text that begins with /, got \"delay\""},
       {"/scene", "", "/scene: expected a text that is not empty, got \"\""}});
}

TEST(ProtocolSchema, APlaceIsAValidJsonPointer) {
  // RFC 6901: in a key, ~ is written ~0 and / is written ~1.
  expect_protocol_refusals(
      {{"/design/practice/0",
        {{"a/b~", {1}}},
        "/design/practice/0/a~1b~0: expected a number, a text, a boolean or a null, got [1]"}});
}

TEST(ProtocolSchema, ALongValueIsCutBetweenCharacters) {
  // 60 bytes of JSON text are shown: the quotation mark and 29 whole letters of two bytes.
  std::string letters;
  for (int i = 0; i < 29; ++i) {
    letters += "ü";
  }
  expect_protocol_refusals(
      {{"/rating", letters + "üüü", "/rating: expected an object, got \"" + letters + "…"}});
}

// ---------------------------------------------------------------- what no schema can say

TEST(ProtocolChecks, FactorsHaveNamesAndPlacesOfTheirOwn) {
  expect_protocol_refusals(
      {{"/design/factors/1/name", "delay_ms",
        "/design/factors/1/name: expected a name of its own, got \"delay_ms\" again"},
       {"/design/factors/1/pointer", "/imposed/contact_hold_ms",
        "/design/factors/1/pointer: expected a value that no other factor overrides, got "
        "\"/imposed/contact_hold_ms\" again"}});
}

TEST(ProtocolChecks, AFactorOverridesASingleValueOfTheScene) {
  for (const std::string pointer : {"/nothing", "/imposed", "/imposed/~9", "/bodies/7/name"}) {
    expect_protocol_refusals({{"/design/factors/0/pointer", pointer,
                               "/design/factors/0/pointer: expected a pointer to a single value of "
                               "stimuli/two-spheres.json, got \"" +
                                   pointer + "\""}});
  }
}

TEST(ProtocolChecks, ALevelIsJudgedByTheScenesRules) {
  expect_protocol_refusals(
      {{"/design/factors/0/levels/1", -100,
        "/design/factors/0/levels/1: expected a number ≥ 0 and ≤ 60000, got -100"},
       {"/design/factors/0/levels/1", "long",
        "/design/factors/0/levels/1: expected a number ≥ 0 and ≤ 60000, got \"long\""},
       {"/design/factors/1/levels/0", 0,
        "/design/factors/1/levels/0: expected a number > 0 and ≤ 1000, got 0"},
       {"/design/factors/2/levels/2", 120,
        "/design/factors/2/levels/2: expected a number ≥ -90 and ≤ 90, got 120"}});
}

TEST(ProtocolChecks, ACellThatCannotBeShownIsRefusedThoughEachLevelCan) {
  // 1 s and 1.025 s are whole steps at 240 Hz, 1 s is at 250 Hz, but 1.025 s · 250 Hz = 256.25.
  const json factors = json::parse(R"([
    {"name": "rate", "pointer": "/engine/step_hz", "levels": [240, 250]},
    {"name": "lead", "pointer": "/meeting/lead_s", "levels": [1, 1.025]}])");
  Study study;
  study.with("/design", {{"factors", factors}, {"repetitions", 1}});
  EXPECT_EQ(study.refused(),
            "protocols/causality.json:/design/factors: /meeting/lead_s of the scene under "
            "{\"lead\":1.025,\"rate\":250}: expected a whole number of steps of 1/250 s, got "
            "1.025");
}

// Spheres of .2 deg miss each other in the scene as it is, and meet in every cell.
TEST(ProtocolChecks, ALevelIsSoundWhereEveryCellIs) {
  Study study;
  study.without("/design/practice").without("/design/practice_until");
  study.scene_with("/meeting/offset_deg", {1.5, 0});
  study.with(
      "/design",
      {{"repetitions", 1},
       {"factors",
        {{{"name", "radius"}, {"pointer", "/bodies/0/shape/radius_deg"}, {"levels", {0.2, 0.4}}},
         {{"name", "offset"}, {"pointer", "/meeting/offset_deg/0"}, {"levels", {0, 0.1}}}}}});
  EXPECT_EQ(study.refused(), "accepted");
}

TEST(ProtocolChecks, GroupsOfParticipantsMakeNobodysSessionLonger) {
  Study study;
  study.without("/design/practice_until").with("/design/practice", json::array());
  study.with("/design/repetitions", 1000);  // × 9 cells each
  EXPECT_EQ(study.with("/design/factors/2/between", true).refused(), "accepted");
}

TEST(ProtocolChecks, ADesignTooLargeForAnyoneIsRefusedBeforeItFillsTheMemory) {
  expect_protocol_refusals(
      {{"/design/repetitions", 400,
        "/design: expected at most 10000 trials, got 10800 (levels of all factors "
        "within participants × "
        "repetitions)"}});
  json factors = json::array();
  for (int i = 0; i < 12; ++i) {  // 10^12 cells
    factors.push_back({{"name", "f" + std::to_string(i)},
                       {"pointer", "/viewer/azimuth_deg"},
                       {"levels", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}});
  }
  expect_protocol_refusals(
      {{"/design/factors", factors,
        "/design: expected at most 10000 conditions, got 1000000000000 (levels of all factors)"}});
}

TEST(ProtocolChecks, AFactorOfAHundredThousandLevelsIsRefusedAtOnce) {
  json levels = json::array();
  for (int i = 0; i < 100'000; ++i) {
    levels.push_back(i);
  }
  expect_protocol_refusals(
      {{"/design/factors/0/levels", levels,
        "/design: expected at most 10000 conditions, got 900000 (levels of all factors)"}});
}

TEST(ProtocolChecks, MoreDemonstrationsThanAnybodyWatchesAreRefused) {
  const json one{
      {"id", "d"}, {"paragraphs", json::array()}, {"set", json::object()}, {"title", "t"}};
  json demonstrations = json::array();
  while (demonstrations.size() <= 100) {
    demonstrations.push_back(one);
  }
  expect_protocol_refusals(
      {{"/session/demonstrations", demonstrations,
        "/session/demonstrations: expected a list of at most 100 values, got " +
            demonstrations.dump().substr(0, 60) + "…"}});
}

TEST(ProtocolChecks, ALevelThatStandsTwiceIsARepeatHoweverItIsWritten) {
  expect_protocol_refusals(
      {{"/design/factors/0/levels",
        {0, 1, 2.0, 2},
        "/design/factors/0/levels: expected a list of at least 1 value without repeats, got "
        "[0,1,2.0,2]"}});
}

TEST(ProtocolChecks, PracticeIsMadeOfTheDesignsCells) {
  expect_protocol_refusals(
      {{"/design/practice/0/delay_ms", 50,
        "/design/practice/0/delay_ms: expected one of the factor's levels [0,100,300], got 50"},
       {"/design/practice/3",
        {{"delay_ms", 0}, {"viewpoint_deg", 0}},
        "/design/practice/3: expected a level for every factor, but \"speed_deg_s\" has none"},
       {"/design/practice/0/colour", "red",
        "/design/practice/0: expected only factors of the design, got \"colour\""}});
}

TEST(ProtocolChecks, ARuleOfOrderNamesAFactor) {
  expect_protocol_refusals(
      {{"/design/longest_runs/0/factor", "delay",
        "/design/longest_runs/0/factor: expected the name of a factor, got \"delay\""}});
}

TEST(ProtocolChecks, RulesThatNoOrderKeepsToAreRefused) {
  Study study;  // One level only: every run is as long as the session.
  study.with("/design", json::parse(R"({"factors": [{"name": "a", "pointer": "/viewer/azimuth_deg",
                                          "levels": [40]}],
                             "repetitions": 2,
                             "longest_runs": [{"factor": "a", "longest": 1}]})"));
  const Protocol protocol = study.made();
  EXPECT_EQ(refusal([&] { plan_for(protocol, "P01", 1); }),
            "protocols/causality.json:/design/longest_runs: expected rules that some order of the "
            "trials keeps to, but none was found");
}

TEST(ProtocolChecks, AScaleHasTwoEndsAndTheBestIsOne) {
  expect_protocol_refusals(
      {{"/rating/maximum", 1, "/rating/maximum: expected more than the minimum 1, got 1"},
       {"/rating/maximum", 12, "/rating/maximum: expected a whole number ≥ 1 and ≤ 9, got 12"},
       {"/rating/best", 2, "/rating/best: expected one end of the scale, 1 or 3, got 2"}});
}

TEST(ProtocolChecks, QuestionsHaveIdsAndSensibleAnswers) {
  expect_protocol_refusals(
      {{"/session/demographics/1/id", "age",
        "/session/demographics/1/id: expected an id of its own, got \"age\" again"},
       {"/session/questions/0/id", "age",
        "/session/questions/0/id: expected an id of its own, got \"age\" again"},
       {"/session/questions/0/id", "consent",
        "/session/questions/0/id: expected an id of its own, got \"consent\" again"},
       {"/session/demographics/0/maximum", 1,
        "/session/demographics/0/maximum: expected more than the minimum 5, got 1"}});
  EXPECT_EQ(Study().without("/session/demographics/1/options").refused(),
            "protocols/causality.json:/session/demographics/1: expected the key \"options\" for a "
            "choice, which is missing");
}

TEST(ProtocolChecks, TheSimulatedParticipantRefusesAScaleItCannotAnswerOn) {
  const auto refused = [](Study study, std::size_t observer_points) {
    ObserverFile observer =
        load_observer("causality", std::filesystem::path(source_folder()) / kProtocolName);
    RatingParameters parameters = *observer.parameters;
    parameters.cuts.resize(observer_points - 1);
    observer.parameters = std::make_shared<RatingParameters>(parameters);
    return refusal([&] { check_observer(study.made(), observer); });
  };
  EXPECT_EQ(refused(Study(), 3), "accepted");
  EXPECT_EQ(refused(Study().with("/rating/best", 3), 3), "accepted");
  EXPECT_EQ(refused(Study().with("/rating/maximum", 5), 5), "accepted");
  EXPECT_EQ(refused(Study().with("/rating/maximum", 5), 3),
            "protocols/causality.json:/rating: expected a scale of 3 points, as the simulated "
            "participant rates (one more than its file has cuts), got 5, from 1 to 5");
  EXPECT_EQ(refused(Study(), 5),
            "protocols/causality.json:/rating: expected a scale of 5 points, as the simulated "
            "participant rates (one more than its file has cuts), got 3, from 1 to 3");
}

// ---------------------------------------------------------------- the scene

TEST(SceneFile, EveryBrokenRuleOfItsSchemaIsNamed) {
  expect_scene_refusals(
      {{"/gravity", 9.8,
        "/: expected only the keys \"$schema\", \"appearance\", \"bodies\", \"crowd\", "
        "\"distractors\", \"duration_s\", "
        "\"enclosure\", "
        "\"engine\", \"figure_crowd\", \"figure_files\", \"figures\", "
        "\"flashing\", \"goal\", \"hidden_after_s\", \"imposed\", "
        "\"launch\", \"meeting\", \"meshes\", \"plane\", \"schema_version\", \"sound\", "
        "\"sound_files\", \"source\", "
        "\"still_s\", "
        "\"title\", "
        "\"viewer\", "
        "got \"gravity\""},
       {"/bodies", json::array(), "/bodies: expected a list of 1 to 1000 values, got []"},
       {"/bodies/0/colour", "red",
        "/bodies/0/colour: expected a text such as \"#d9813b\", got "
        "\"red\""},
       {"/bodies/0/shape/kind", "cube",
        "/bodies/0/shape/kind: expected one of \"sphere\", \"disc\", \"box\", \"plate\", "
        "\"l-block\", \"torus\", \"knot\", \"creature\", \"line-swept\", "
        "\"rectangle-swept\", \"prism\", \"mesh\", got \"cube\""},
       {"/bodies/0/shape/radius_deg", 0,
        "/bodies/0/shape/radius_deg: expected a number > 0 and ≤ 45, got 0"},
       {"/bodies/0/density_kg_m3", 1e7,
        "/bodies/0/density_kg_m3: expected a number > 0 and ≤ 1000000, got 10000000.0"},
       {"/engine/restitution", 1.5, "/engine/restitution: expected a number ≥ 0 and ≤ 1, got 1.5"},
       {"/viewer/azimuth_deg", "0",
        "/viewer/azimuth_deg: expected a number ≥ -90 and ≤ 90, got \"0\""}});
  EXPECT_EQ(Study().scene_without("/imposed/contact_hold_ms").refused(),
            "stimuli/two-spheres.json:/imposed: expected the key \"contact_hold_ms\", which is "
            "missing");
}

TEST(SceneFile, TheLeadIsWholeStepsAndBodiesHaveNamesOfTheirOwn) {
  expect_scene_refusals(
      {{"/meeting/lead_s", 1.001,
        "/meeting/lead_s: expected a whole number of steps of 1/240 s, got 1.001"},
       {"/bodies/1/name", "left",
        "/bodies/1/name: expected a name of its own, got \"left\" again"}});
}

TEST(SceneFile, ASceneThatIsNotThereIsNamedByTheProtocol) {
  const TemporaryFolder folder;
  json protocol = json::parse(shipped(kProtocolName));
  protocol["scene"] = "../stimuli/none.json";
  const std::string path = folder.write("protocols/a.json", protocol.dump()).string();
  EXPECT_EQ(refusal([&] { load_protocol(path); }),
            path +
                ":/scene: expected a file, seen from this one, got \"../stimuli/none.json\", "
                "but " +
                (folder / "stimuli/none.json").string() + ": there is no such file");
}

TEST(SceneFile, AShapeHasTheMeasuresOfItsKind) {
  const json block{{"kind", "l-block"}, {"arm_deg", 2}, {"thickness_deg", 0.7}};
  json short_of_one = block;
  short_of_one.erase("arm_deg");
  json one_too_many = block;
  one_too_many["radius_deg"] = 1;
  json too_thick = block;
  too_thick["thickness_deg"] = 3;
  const auto refused = [](const json& shape) {
    return Study().scene_with("/bodies/1/shape", shape).refused();
  };
  const std::string place = std::string(kSceneName) + ":/bodies/1/shape";
  EXPECT_EQ(refused(block), "accepted");
  EXPECT_EQ(refused(short_of_one),
            place + ": expected the key \"arm_deg\" for kind l-block, which is missing");
  EXPECT_EQ(refused(one_too_many),
            place + ": expected the measures of kind l-block alone, arm_deg, thickness_deg, got 3");
  EXPECT_EQ(refused(too_thick), place + "/thickness_deg: expected less than arm_deg, got 3");
}

TEST(SceneFile, ALevelDeeperThanTheTreeIsRefused) {
  Study study;
  study.scene_with("/engine/tree_depth", 4).scene_with("/engine/level", 5);
  EXPECT_EQ(study.refused(),
            std::string(kSceneName) +
                ":/engine/level: expected at most 4, the deepest level of the trees, got 5");
}

}  // namespace impetus::protocol_test
