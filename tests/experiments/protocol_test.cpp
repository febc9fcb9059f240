// What a protocol, a scene, an observer and a screen file must be: every refusal, word for word.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "experiments/protocol/observer_file.hpp"
#include "experiments/protocol/protocol_checks.hpp"
#include "experiments/protocol/protocol_file.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/protocol/validation.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "tests/experiments/temporary_folder.hpp"

namespace impetus {
namespace {

using nlohmann::json;

constexpr const char* kProtocolName = "protocols/causality.json";
constexpr const char* kSceneName = "stimuli/two-spheres.json";

std::string shipped(const std::string& path) {
  return text_of(std::filesystem::path(IMPETUS_SOURCE_DIR) / path);
}

/// The sentence with which something is refused; "accepted" when it is not.
std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string json_refusal(const std::string& text) {
  return refusal([&] { parse_json("a.json", text); });
}

void erase(json& object, const std::string& pointer) {
  const json::json_pointer place(pointer);
  object[place.parent_pointer()].erase(place.back());
}

/// The shipped protocol and its scene, with single values changed.
class Study {
 public:
  Study& with(const std::string& pointer, json value) {
    protocol_[json::json_pointer(pointer)] = std::move(value);
    return *this;
  }
  Study& without(const std::string& pointer) {
    erase(protocol_, pointer);
    return *this;
  }
  Study& scene_with(const std::string& pointer, json value) {
    scene_[json::json_pointer(pointer)] = std::move(value);
    return *this;
  }
  Study& scene_without(const std::string& pointer) {
    erase(scene_, pointer);
    return *this;
  }

  [[nodiscard]] Protocol made() const {
    return make_protocol(parse_json(kProtocolName, protocol_.dump()),
                         parse_json(kSceneName, scene_.dump()));
  }
  [[nodiscard]] std::string refused() const {
    return refusal([this] { static_cast<void>(made()); });
  }

 private:
  json protocol_ = json::parse(shipped(kProtocolName));
  json scene_ = json::parse(shipped(kSceneName));
};

/// One changed value and the sentence that it deserves, after the file's name.
struct Case {
  std::string pointer;
  json value;
  std::string sentence;
};

void expect_protocol_refusals(const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    EXPECT_EQ(Study().with(one.pointer, one.value).refused(),
              std::string(kProtocolName) + ":" + one.sentence);
  }
}

void expect_scene_refusals(const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    EXPECT_EQ(Study().scene_with(one.pointer, one.value).refused(),
              std::string(kSceneName) + ":" + one.sentence);
  }
}

// ---------------------------------------------------------------- JSON

TEST(JsonDocument, MalformedJsonIsRefusedAtItsLineAndColumn) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "a.json:1:1: expected valid JSON, got the end of the file"},
      {"[1,2", "a.json:1:5: expected valid JSON, got the end of the file"},
      {"{\n  \"a\": 1,\n}", "a.json:3:1: expected valid JSON, got '}'"},
      {"{\"a\" 1}", "a.json:1:6: expected valid JSON, got '1'"},
      {"{\"a\": tru}", "a.json:1:10: expected valid JSON, got '}'"},
      {"{\"a\": 'x'}", "a.json:1:7: expected valid JSON, got '''"},
      {"// words\n{}", "a.json:1:1: expected valid JSON, got '/'"},
      {"{} {}", "a.json:1:4: expected valid JSON, got '{'"},
      {"{\n\"a\": \"x\ny\"}", "a.json:2:8: expected valid JSON, got the end of the line"},
      {"[\"a\tb\"]", "a.json:1:4: expected valid JSON, got a control character"},
      {"[NaN]", "a.json:1:2: expected valid JSON, got 'N'"}};
  for (const auto& [text, sentence] : cases) {
    EXPECT_EQ(json_refusal(text), sentence);
  }
}

TEST(JsonDocument, AColumnIsACharacterAndNotAByte) {
  EXPECT_EQ(json_refusal("[\"é°\" é]"), "a.json:1:7: expected valid JSON, got 'é'");
}

TEST(JsonDocument, TextInAnotherEncodingIsRefusedAsSuch) {
  EXPECT_EQ(json_refusal("{\"a\": \"\xb0/s\"}"),
            "a.json:1:8: expected text in UTF-8, got a byte that is not");
}

TEST(JsonDocument, AKeyThatStandsTwiceIsRefusedAtItsPlace) {
  EXPECT_EQ(json_refusal(R"({"a": 1, "a": 1})"), "a.json:/a: expected each key once, got it twice");
  EXPECT_EQ(json_refusal(R"({"a": [{"b": 1}, {"b": 1, "c": {}, "b": 2}]})"),
            "a.json:/a/1/b: expected each key once, got it twice");
  EXPECT_EQ(json_refusal(R"({"a": {"x": 1}, "b": {"x": 1}})"), "accepted");
}

TEST(JsonDocument, ANumberTooLargeIsRefusedAtItsPlace) {
  EXPECT_EQ(json_refusal(R"({"a": [1, [], 1e400]})"),
            "a.json:/a/2: expected a number of at most 1.8e308, got 1e400");
}

TEST(JsonDocument, BottomlessNestingIsRefused) {
  const std::string open(65, '[');
  const std::string close(65, ']');
  std::string place;
  for (int level = 0; level < 64; ++level) {
    place += "/0";
  }
  EXPECT_EQ(json_refusal(open + close),
            "a.json:" + place + ": expected at most 64 levels of nesting, got more");
  EXPECT_EQ(json_refusal(open.substr(1) + close.substr(1)), "accepted");
}

TEST(JsonDocument, AFileThatCannotBeReadIsRefusedWithTheReason) {
  const TemporaryFolder folder;
  const std::string missing = (folder / "none.json").string();
  EXPECT_EQ(refusal([&] { read_json(missing); }),
            missing + ": expected a JSON file, but it cannot be read: No such file or directory");
  EXPECT_EQ(
      refusal([&] { read_json(folder.path()); }),
      folder.path().string() + ": expected a JSON file, but it cannot be read: it is a directory");
}

// ---------------------------------------------------------------- the protocol's schema

TEST(ProtocolSchema, AnUnknownKeyIsRefused) {
  expect_protocol_refusals(
      {{"/timing/fixation", 500,
        "/timing: expected only the keys \"fixation_ms\", \"interval_ms\", got \"fixation\""},
       {"/design/factors/0/level",
        {1},
        "/design/factors/0: expected only the keys \"label\", \"levels\", \"name\", \"pointer\", "
        "got \"level\""},
       {"/seed", 1,
        "/: expected only the keys \"$schema\", \"design\", \"name\", \"rating\", \"scene\", "
        "\"schema_version\", \"session\", \"source\", \"timing\", \"title\", got \"seed\""}});
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
        "/timing/fixation_ms: expected a number ≥ 0 and ≤ 60000, got \"500\""},
       {"/design/repetitions", 1.5,
        "/design/repetitions: expected a whole number ≥ 1 and ≤ 1000, got 1.5"},
       {"/design/factors/0/levels/1", nullptr,
        "/design/factors/0/levels/1: expected a number, a text or a boolean, got null"},
       {"/design/practice/0/delay_ms",
        {1},
        "/design/practice/0/delay_ms: expected a number, a text or a boolean, got [1]"},
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
        "/timing/fixation_ms: expected a number ≥ 0 and ≤ 60000, got -5"},
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
        "/design/practice/0/a~1b~0: expected a number, a text or a boolean, got [1]"}});
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

TEST(ProtocolChecks, ADesignTooLargeForAnyoneIsRefusedBeforeItFillsTheMemory) {
  expect_protocol_refusals(
      {{"/design/repetitions", 400,
        "/design: expected at most 10000 trials, got 10800 (levels of all factors × "
        "repetitions)"}});
  json factors = json::array();
  for (int i = 0; i < 12; ++i) {  // 10^12 cells
    factors.push_back({{"name", "f" + std::to_string(i)},
                       {"pointer", "/viewer/azimuth_deg"},
                       {"levels", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}});
  }
  expect_protocol_refusals(
      {{"/design/factors", factors,
        "/design: expected at most 10000 trials, got 3000000000000 (levels of all factors × "
        "repetitions)"}});
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
  EXPECT_EQ(refusal([] { check_scale_for_observer(Study().made()); }), "accepted");
  const std::string expected =
      "protocols/causality.json:/rating: expected three points of which the lowest is the best, as "
      "simulated participants rate, got ";
  EXPECT_EQ(refusal([] { check_scale_for_observer(Study().with("/rating/maximum", 5).made()); }),
            expected + "1 to 5, best 1");
  EXPECT_EQ(refusal([] { check_scale_for_observer(Study().with("/rating/best", 3).made()); }),
            expected + "1 to 3, best 3");
}

// ---------------------------------------------------------------- the scene

TEST(SceneFile, EveryBrokenRuleOfItsSchemaIsNamed) {
  expect_scene_refusals(
      {{"/gravity", 9.8,
        "/: expected only the keys \"$schema\", \"bodies\", \"engine\", \"imposed\", \"meeting\", "
        "\"schema_version\", \"source\", \"title\", \"viewer\", got \"gravity\""},
       {"/bodies", json::array(), "/bodies: expected a list of 2 values, got []"},
       {"/bodies/0/colour", "red",
        "/bodies/0/colour: expected a text such as \"#d9813b\", got "
        "\"red\""},
       {"/bodies/0/shape/kind", "cube",
        "/bodies/0/shape/kind: expected one of \"sphere\", \"l-block\", got \"cube\""},
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
                "but there is no " +
                (folder / "stimuli/none.json").string());
}

// ---------------------------------------------------------------- frames

TEST(Frames, CausalityFallsOnTheFramesOf60And100Hz) {
  const Protocol protocol = Study().made();
  for (const double hz : {50.0, 60.0, 100.0, 120.0}) {
    EXPECT_EQ(refusal([&] { check_frames(protocol, hz, false); }), "accepted") << hz;
  }
}

TEST(Frames, ADelayBetweenTheFramesOf85And144HzIsRefused) {
  const Protocol protocol = Study().made();
  EXPECT_EQ(refusal([&] { check_frames(protocol, 85.0, false); }),
            "protocols/causality.json:/design/factors/0/levels/1: expected a whole number of 85 Hz "
            "frames (11.76 ms), got 100");
  EXPECT_EQ(refusal([&] { check_frames(protocol, 144.0, false); }),
            "protocols/causality.json:/design/factors/0/levels/1: expected a whole number of 144 "
            "Hz frames (6.94 ms), got 100");
}

TEST(Frames, EveryDurationThatIsShownIsChecked) {
  // 1.0125 s are 243 steps of 1/240 s but 60.75 frames of 1/60 s.
  EXPECT_EQ(refusal([] {
              check_frames(Study().scene_with("/meeting/lead_s", 1.0125).made(), 60.0, false);
            }),
            "stimuli/two-spheres.json:/meeting/lead_s: expected a whole number of 60 Hz frames "
            "(16.67 ms), got 1.0125");
  EXPECT_EQ(
      refusal([] { check_frames(Study().with("/timing/fixation_ms", 490).made(), 60.0, false); }),
      "protocols/causality.json:/timing/fixation_ms: expected a whole number of 60 Hz frames "
      "(16.67 ms), got 490");
}

TEST(Frames, RoundingIsForImposedHoldsAndNotForTheContact) {
  const Protocol protocol = Study().made();
  EXPECT_EQ(refusal([&] { check_frames(protocol, 85.0, true); }), "accepted");
  EXPECT_EQ(refusal([] {
              check_frames(Study().scene_with("/meeting/lead_s", 1.0125).made(), 60.0, true);
            }),
            "stimuli/two-spheres.json:/meeting/lead_s: expected a whole number of 60 Hz frames "
            "(16.67 ms), got 1.0125");
}

TEST(Frames, RoundingKeepsWhatWasIntendedBesideWhatIsRealised) {
  const Protocol protocol = Study().made();
  const ProtocolScenes scenes(protocol, 85.0);
  const StagedScene scene = scenes.stage(
      {{"delay_ms", 100.0}, {"speed_deg_s", 10.0}, {"viewpoint_deg", 0.0}}, assumed_screen());
  EXPECT_DOUBLE_EQ(scene.intended_hold_s, 0.1);
  // 0.1 s · 85 Hz = 8.5 frames, rounded up to 9.
  EXPECT_DOUBLE_EQ(scene.realised_hold_s, 9.0 / 85.0);
}

// ---------------------------------------------------------------- the design

TEST(Protocol, CausalityIs27CellsTimesThreeRepetitions) {
  const Protocol protocol = Study().made();
  EXPECT_EQ(protocol.name, "causality");
  EXPECT_EQ(cells(protocol.design).size(), 27U);
  EXPECT_EQ(protocol.design.repetitions, 3);
  EXPECT_EQ(protocol.design.practice.size(), 6U);
  EXPECT_EQ(make_plan(protocol.design, {"causality", "P01", 1}).size(), 6U + 81U);
  const Condition last{{"delay_ms", 300.0}, {"speed_deg_s", 15.0}, {"viewpoint_deg", 85.0}};
  EXPECT_EQ(cells(protocol.design).back(), last);
}

TEST(Protocol, TheShippedFilesAreValid) {
  EXPECT_EQ(
      refusal([] { load_protocol(std::filesystem::path(IMPETUS_SOURCE_DIR) / kProtocolName); }),
      "accepted");
}

TEST(Protocol, TheHashIgnoresWhiteSpaceAndNotValues) {
  const std::string protocol = shipped(kProtocolName);
  const std::string scene = shipped(kSceneName);
  const auto hash = [](const std::string& first, const std::string& second) {
    return make_protocol(parse_json("a", first), parse_json("b", second)).hash;
  };
  const std::string original = hash(protocol, scene);
  EXPECT_EQ(original.size(), 32U);
  EXPECT_EQ(hash(json::parse(protocol).dump(), json::parse(scene).dump(4)), original);
  EXPECT_NE(Study().with("/timing/interval_ms", 800).made().hash, original);
  EXPECT_NE(Study().with("/session/thanks/title", "Thanks").made().hash, original);
  EXPECT_NE(Study().scene_with("/engine/restitution", 0.9).made().hash, original);
}

TEST(Protocol, LevelsArePutIntoTheSceneByPointerAndNothingElseChanges) {
  const Protocol protocol = Study().made();
  json expected = protocol.scene.value;
  expected["imposed"]["contact_hold_ms"] = 300;
  expected["meeting"]["speed_deg_s"] = 5;
  expected["viewer"]["azimuth_deg"] = 85;
  EXPECT_EQ(
      scene_under(protocol, {{"delay_ms", 300.0}, {"speed_deg_s", 5.0}, {"viewpoint_deg", 85.0}}),
      expected);
}

TEST(Protocol, AConditionSurvivesJsonWithEveryTypeOfLevel) {
  Design design;
  design.factors = {
      {"number", {0.5, 100.0, -3.0}}, {"text", {"a\"b", ""}}, {"flag", {true, false}}};
  const std::vector<Condition> all = cells(design);
  ASSERT_EQ(all.size(), 12U);
  for (const Condition& cell : all) {
    EXPECT_EQ(condition_from_json(json::parse(to_json(cell).dump()), design), cell);
  }
  EXPECT_EQ(to_json(Condition{{"number", 100.0}, {"flag", true}}).dump(),
            R"({"flag":true,"number":100})");
}

// ---------------------------------------------------------------- the observer's file

/// The shipped observer with one value changed, refused.
std::string observer_refusal(const TemporaryFolder& folder, const std::string& pointer,
                             const json& value) {
  json observer = json::parse(shipped("experiments/observers/causality.json"));
  observer[json::json_pointer(pointer)] = value;
  const std::string path = folder.write("o.json", observer.dump()).string();
  const std::string sentence = refusal([&] { load_observer(path, "protocols/causality.json"); });
  return sentence.rfind(path, 0) == 0 ? "o.json" + sentence.substr(path.size()) : sentence;
}

TEST(ObserverFile, EveryRefusalNamesThePlace) {
  const TemporaryFolder folder;
  const std::vector<Case> cases{
      {"/observer", "gaze",
       "o.json:/observer: expected one of \"causality\", \"gap\", got \"gaze\""},
      {"/parameters/lapse_rate/value", 2,
       "o.json:/parameters/lapse_rate/value: expected a number ≥ 0 and ≤ 1, got 2"},
      {"/parameters/threshold_sd_ms/value", -1,
       "o.json:/parameters/threshold_sd_ms/value: expected a number ≥ 0 and ≤ 1000000000, got -1"},
      {"/parameters/threshold_width_ms/value", 0,
       "o.json:/parameters/threshold_width_ms/value: expected a number ≥ 0.001 and ≤ 1000000000, "
       "got 0"},
      {"/parameters/baseline/source", "",
       "o.json:/parameters/baseline/source: expected a text that is not empty, got \"\""},
      {"/parameters/baseline", -2.2, "o.json:/parameters/baseline: expected an object, got -2.2"},
      {"/parameters/cut_2_3/value", -1.5,
       "o.json:/parameters/cut_2_3/value: expected more than cut_1_2, got -1.5"},
      {"/parameters/cut_2_3",
       {{"value", 1}, {"unit", "logit"}},
       "o.json:/parameters/cut_2_3: expected the key \"source\", which is missing"}};
  for (const Case& one : cases) {
    EXPECT_EQ(observer_refusal(folder, one.pointer, one.value), one.sentence);
  }
  EXPECT_EQ(observer_refusal(folder, "/note", "mine"), "accepted");
}

TEST(ObserverFile, AnUnknownNameIsRefusedWithTheFolderThatWasSearched) {
  const TemporaryFolder folder;
  EXPECT_EQ(refusal([&] { load_observer("nobody", folder / "protocols/a.json"); }),
            "--observer nobody: expected a file, or the name of one in " +
                (folder / "experiments/observers").string());
}

// ---------------------------------------------------------------- the screen's file

TEST(ScreenFile, EveryRefusalNamesThePlace) {
  const TemporaryFolder folder;
  const std::string path = (folder / "screen.json").string();
  const auto refused = [&](const std::string& text) {
    folder.write("screen.json", text);
    return refusal([&] { load_screen(path); });
  };
  EXPECT_EQ(refused(R"({"schema_version": 1, "width_cm": 40, "height_cm": 30})"),
            path + ":/: expected the key \"viewing_distance_cm\", which is missing");
  EXPECT_EQ(refused(R"({"schema_version": 1, "width_cm": 0.4, "height_cm": 30,
                        "viewing_distance_cm": 57})"),
            path + ":/width_cm: expected a number ≥ 10 and ≤ 300, got 0.4");
  EXPECT_EQ(refused(R"({"schema_version": 1, "width_cm": 40, "height_cm": "30",
                        "viewing_distance_cm": 57})"),
            path + ":/height_cm: expected a number ≥ 10 and ≤ 200, got \"30\"");
}

TEST(ScreenFile, WhatIsSavedIsLoadedAgain) {
  const TemporaryFolder folder;
  const ScreenGeometry screen{0.376, 0.301, 0, 0, 0.57};
  save_screen(screen, folder / "new/folder/screen.json");
  const ScreenGeometry loaded = load_screen(folder / "new/folder/screen.json");
  // Kept to the micrometre, in whole digits of a centimetre; one rounding on the way back.
  EXPECT_DOUBLE_EQ(loaded.width_m, screen.width_m);
  EXPECT_DOUBLE_EQ(loaded.height_m, screen.height_m);
  EXPECT_DOUBLE_EQ(loaded.viewing_distance_m, screen.viewing_distance_m);
}

TEST(ScreenFile, AFileThatCannotBeWrittenIsRefusedWithTheReason) {
  const TemporaryFolder folder;
  folder.write("file", "");
  const std::string path = (folder / "file/screen.json").string();
  EXPECT_EQ(refusal([&] { save_screen(assumed_screen(), path); }),
            path + ": expected a file that can be written, but it cannot be: Not a directory");
}

}  // namespace
}  // namespace impetus
