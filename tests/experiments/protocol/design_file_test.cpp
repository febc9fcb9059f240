// What a valid protocol becomes: its design, its hash, its conditions, its frames.
// SPDX-License-Identifier: MIT
#include "experiments/files/protocol_files.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/design_words.hpp"
#include "experiments/protocol/protocol_page.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "tests/experiments/refusals.hpp"
#include "tests/places/places.hpp"

namespace impetus::design_file_test {

// ---------------------------------------------------------------- adaptation

TEST(AdaptationRows, SayWhatIsWrongWithThem) {
  const json whole{{"delay_ms", 0}, {"speed_deg_s", 5}, {"viewpoint_deg", 0}};
  const auto refused = [&](const json& when, const json& condition, int first, int before_each) {
    const json stream{{"when", when},
                      {"conditions", {condition}},
                      {"first", first},
                      {"before_each", before_each}};
    return Study().with("/design/adaptation", {stream}).refused();
  };
  const std::string place = "protocols/causality.json:/design/adaptation/0";
  const json always = json::object();
  EXPECT_EQ(refused({{"speed_deg_s", 5}}, whole, 10, 2), "accepted");
  EXPECT_EQ(refused({{"colour", 5}}, whole, 10, 2),
            place + "/when: expected a factor of the design, got \"colour\"");
  EXPECT_EQ(refused({{"speed_deg_s", 6}}, whole, 10, 2),
            place + "/when/speed_deg_s: expected one of the factor's levels [5,10,15], got 6");
  EXPECT_EQ(refused(always, whole, 0, 0),
            place + ": expected some trials, first or before each, got none");
  EXPECT_EQ(refused(always, whole, 0, 1000),
            "protocols/causality.json:/design: expected at most 10000 trials, got 81081 (all "
            "tracks, catch trials and adaptation counted)");
  json part = whole;
  part.erase("delay_ms");
  EXPECT_NE(refused(always, part, 1, 1), "accepted");
}

TEST(PracticeRule, ItsTwoEndsAreTwoLevels) {
  const json rule{{"factor", "delay_ms"}, {"best", 0}, {"worst", 0}, {"rounds", 2}};
  EXPECT_EQ(
      Study().with("/design/practice_until", rule).refused(),
      "protocols/causality.json:/design/practice_until/worst: expected another level than the "
      "best, got 0");
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
  EXPECT_EQ(refusal([] {
              check_frames(Study().with("/timing/fixation_ms", {490, 500}).made(), 60.0, false);
            }),
            "protocols/causality.json:/timing/fixation_ms: expected a whole number of 60 Hz frames "
            "(16.67 ms), got 490");
  EXPECT_EQ(
      refusal([] { check_frames(Study().scene_with("/still_s", 0.1125).made(), 60.0, false); }),
      "stimuli/two-spheres.json:/still_s: expected a whole number of 60 Hz frames (16.67 ms), got "
      "0.1125");
}

TEST(Frames, WordsAndDemonstrationsAreOnThemToo) {
  const auto refused = [](Study study) {
    return refusal([&] { check_frames(study.made(), 60.0, false); });
  };
  Study words;
  words.without("/design/practice_until").without("/design/practice");
  words.with("/design/factors/0", json::parse(R"({"name": "delay_ms", "levels": ["short", "long"],
      "sets": {"short": {"/imposed/contact_hold_ms": 50},
               "long": {"/imposed/contact_hold_ms": 310}}})"));
  EXPECT_EQ(refused(words),
            "protocols/causality.json:/design/factors/0/sets/long: expected a whole number of 60 "
            "Hz frames (16.67 ms), got 310");
  EXPECT_EQ(refused(words.with("/design/factors/0/sets/long", {{"/engine/restitution", 0.5}})
                        .scene_with("/imposed/contact_hold_ms", 25)),
            "stimuli/two-spheres.json:/imposed/contact_hold_ms: expected a whole number of 60 Hz "
            "frames (16.67 ms), got 25");
  EXPECT_EQ(refused(Study().with("/session/demonstrations", json::parse(R"([{"id": "late",
                "title": "Late", "paragraphs": [], "set": {"/imposed/contact_hold_ms": 25}}])"))),
            "protocols/causality.json:/session/demonstrations/0/set: expected a whole number of 60 "
            "Hz frames (16.67 ms), got 25");
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
  EXPECT_EQ(refusal([] { load_protocol(std::filesystem::path(source_folder()) / kProtocolName); }),
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

// ---------------------------------------------------------------- between participants, keys,
// blocks

/// The shipped study asking yes or no, the viewpoint between participants.
Study grouped_study() {
  Study study;
  study.with("/design/factors/2/between", true)
      .with("/yes_no", json::parse(R"({"question": "Natural?", "keys": "f j"})"))
      .with("/design/practice", json::parse(R"([{"delay_ms": 0, "speed_deg_s": 10}])"));
  study.without("/design/practice_until");
  return study;
}

const json kKeys = json::parse(
    R"({"name": "keys", "keys_of": "yes_no", "between": true, "levels": ["f j", "j f"]})");

TEST(DesignFile, AFactorBetweenParticipantsIsExplained) {
  const Protocol protocol = grouped_study().with("/design/factors/3", kKeys).made();
  EXPECT_TRUE(protocol.design.factors[2].between);
  EXPECT_EQ(plan_for(protocol, "P01", 1).size(), 1U + 27U);
  const std::vector<std::string> lines = design_lines(protocol.design);
  EXPECT_EQ(lines[0], "3 × 3 cells, 3 repetitions of each.");
  EXPECT_EQ(
      lines[1],
      "Between participants: `viewpoint_deg` × `keys`, 6 groups. Whoever is planned for joins "
      "one that has the fewest so far, drawn by seed and code; that is kept with the plan.");
  const std::string page = protocol_page(protocol);
  EXPECT_NE(page.find("| `keys of yes_no` |"), std::string::npos) << page;
}

TEST(DesignFile, WhatCannotBeBetweenParticipantsIsRefused) {
  const auto refused = [](const std::string& pointer, const json& value) {
    return grouped_study()
        .with(pointer, value)
        .refused()
        .substr(std::string(kProtocolName).size() + 1);
  };
  const std::string within =
      "expected a factor that varies within participants, got \"viewpoint_deg\", which is between "
      "them";
  EXPECT_EQ(grouped_study().refused(), "accepted");
  EXPECT_EQ(refused("/design/longest_runs", json::parse(R"([{"factor": "viewpoint_deg",
                                                             "longest": 3}])")),
            "/design/longest_runs/0/factor: " + within);
  EXPECT_EQ(
      refused("/design/blocks", json::parse(R"({"factors": ["viewpoint_deg"], "order": "fixed"})")),
      "/design/blocks/factors/0: " + within);
  EXPECT_EQ(refused("/design/practice/0/viewpoint_deg", 0),
            "/design/practice/0/viewpoint_deg: expected no level of a factor between participants, "
            "whose own holds here too, got 0");
  EXPECT_EQ(refused("/participants", "none").substr(0, 30), "/timing: expected none where n");
}

TEST(DesignFile, KeysAreAsManyLettersOrDigitsAsThereAreAnswers) {
  const auto refused = [](const std::string& pointer, const json& value) {
    return grouped_study()
        .with("/design/factors/3", kKeys)
        .with(pointer, value)
        .refused()
        .substr(std::string(kProtocolName).size() + 1);
  };
  const std::string expected =
      ": expected 2 keys that differ, letters from a to z or digits, a blank between (\"f j\"), "
      "got ";
  for (const char* keys : {"f", "f f", "f j k", "F J", "left right"}) {
    EXPECT_EQ(refused("/yes_no/keys", keys), "/yes_no/keys" + expected + json(keys).dump());
    EXPECT_EQ(refused("/design/factors/3/levels/1", keys),
              "/design/factors/3/levels/1" + expected + json(keys).dump());
  }
  EXPECT_EQ(refused("/design/factors/3/levels/1", nullptr),
            "/design/factors/3/levels/1" + expected + "null");
  EXPECT_EQ(refused("/design/factors/3/levels/1", "d k"),
            "/design/factors/3/levels/1: expected the keys of the first level (\"f j\") in another "
            "order, got \"d k\"");
  EXPECT_EQ(refused("/design/factors/3/keys_of", "rating"),
            "/design/factors/3/keys_of: expected a question of the protocol whose answers have "
            "keys (yes_no, two_interval, choice) and no other factor of keys, got \"rating\"");
  EXPECT_EQ(refused("/design/factors/3/pointer", "/title"),
            "/design/factors/3: expected either \"pointer\" or \"keys_of\", got both");
  EXPECT_EQ(Study().without("/design/factors/0/pointer").refused(),
            std::string(kProtocolName) +
                ":/design/factors/0: expected the key \"pointer\", which is missing");
}

TEST(DesignFile, AFactorMaySetSeveralValuesAtOnce) {
  const json sets = json::parse(R"({"name": "pace", "levels": ["calm", "hasty"], "sets": {
    "calm": {"/meeting/speed_deg_s": 5, "/meeting/follow_s": 2},
    "hasty": {"/meeting/speed_deg_s": 20, "/bodies/0/shape": {"kind": "sphere", "radius_deg": 2}},
    "drill": {"/meeting/speed_deg_s": 1}}})");
  const auto study = [&] {
    Study made;
    made.with("/design/factors/1", sets)
        .with("/design/practice",
              json::parse(R"([{"delay_ms": 0, "pace": "drill", "viewpoint_deg": 0}])"));
    made.without("/design/practice_until");
    return made;
  };
  EXPECT_EQ(study().refused(), "accepted");
  const Protocol protocol = study().made();
  const json hasty = scene_under(protocol, {{"pace", std::string("hasty")}});
  EXPECT_EQ(hasty["meeting"]["speed_deg_s"], 20);
  EXPECT_EQ(hasty["bodies"][0]["shape"]["radius_deg"], 2);
  EXPECT_EQ(scene_under(protocol, {{"pace", std::string("drill")}})["meeting"]["speed_deg_s"], 1);
  const auto refused = [&](const std::string& pointer, const json& value) {
    return study().with(pointer, value).refused().substr(std::string(kProtocolName).size() + 1);
  };
  EXPECT_EQ(refused("/design/factors/1/levels", json::parse(R"(["calm", "wild"])")),
            "/design/factors/1/levels/1: expected a word that \"sets\" has, got \"wild\"");
  EXPECT_EQ(refused("/design/factors/1/pointer", "/meeting/lead_s"),
            "/design/factors/1: expected either \"pointer\" or \"sets\", got both");
  EXPECT_EQ(refused("/design/factors/1/sets/calm", json::parse(R"({"/meeting/haste": 5})")),
            "/design/factors/1/sets: expected pointers to values of stimuli/two-spheres.json, got "
            "\"/meeting/haste\"");
  EXPECT_EQ(refused("/design/factors/1/sets/calm", json::parse(R"({"/viewer/azimuth_deg": 5})")),
            "/design/factors/2/pointer: expected a value that no other factor overrides, got "
            "\"/viewer/azimuth_deg\" again");
  EXPECT_NE(refused("/design/factors/1/sets/drill", json::parse(R"({"/meeting/lead_s": -1})"))
                .find("/design/practice/0"),
            std::string::npos);
}

TEST(DesignFile, BlocksAreOfFactorsOrAlike) {
  const auto refused = [](const char* blocks) {
    return Study()
        .with("/design/blocks", json::parse(blocks))
        .refused()
        .substr(std::string(kProtocolName).size() + 1);
  };
  EXPECT_EQ(refused(R"({"count": 2})"),
            "/design/blocks/count: expected a number that divides the 3 repetitions, so that each "
            "block has every cell equally often, got 2");
  EXPECT_EQ(refused(R"({})"),
            "/design/blocks: expected either \"factors\" or \"count\", got neither");
  EXPECT_EQ(refused(R"({"count": 3, "factors": ["delay_ms"], "order": "fixed"})"),
            "/design/blocks: expected either \"factors\" or \"count\", got both");
  EXPECT_EQ(refused(R"({"factors": ["delay_ms"]})"),
            "/design/blocks: expected the key \"order\", which is missing");
  EXPECT_EQ(refused(R"({"count": 3, "order": "fixed"})"),
            "/design/blocks: expected no \"order\" of blocks that are alike (count)");
  const Protocol protocol = Study().with("/design/blocks", json::parse(R"({"count": 3})")).made();
  EXPECT_EQ(design_lines(protocol.design)[1],
            "3 blocks alike, each with every cell equally often, in random order within.");
}

TEST(DesignFile, BreaksAfterBlocksNeedBlocksAndAStopNeedsBreaks) {
  EXPECT_EQ(Study().without("/session/breaks/every").refused(),
            std::string(kProtocolName) +
                ":/session/breaks: expected the key \"every\", which is missing, where /design has "
                "no blocks");
  EXPECT_EQ(Study()
                .without("/session/breaks/every")
                .with("/design/blocks", json::parse(R"({"count": 3})"))
                .refused(),
            "accepted");
  EXPECT_EQ(
      Study()
          .without("/session/breaks")
          .with("/session/late_frames", json::parse(R"({"then": "stop"})"))
          .refused(),
      std::string(kProtocolName) +
          ":/session/late_frames/then: expected \"tell\" or \"nothing\" where the session has "
          "no breaks to stop at, got \"stop\"");
}

// ---------------------------------------------------------------- levels that the scene has

TEST(DesignFile, NullIsTheScenesOwnValueWhereverALevelIsNamed) {
  const json own = json::parse(shipped(kSceneName))[json::json_pointer(
      json::parse(shipped(kProtocolName))["design"]["factors"][1]["pointer"].get<std::string>())];
  ASSERT_TRUE(own.is_number());
  Study study;
  study.with("/design/factors/1/levels", {nullptr, 15})
      .with("/design/practice", json::parse(R"([{"delay_ms": 0, "speed_deg_s": null,
                                                 "viewpoint_deg": 0}])"))
      .with("/design/catch_trials", json::parse(R"([{"condition": {"delay_ms": 900,
              "speed_deg_s": null, "viewpoint_deg": 0}, "count": 1}])"));
  study.without("/design/practice_until");
  const Design design = study.made().design;
  EXPECT_EQ(design.factors[1].levels, (std::vector<LevelValue>{own.get<double>(), 15.0}));
  EXPECT_EQ(design.practice[0][1].value, LevelValue(own.get<double>()));
  EXPECT_EQ(design.catch_trials[0].condition[1].value, LevelValue(own.get<double>()));
  EXPECT_EQ(
      study.with("/design/factors/1/levels", {nullptr, own}).refused(),
      std::string(kProtocolName) +
          ":/design/factors/1/levels: expected levels that differ, but null is the scene's own "
          "value: [" +
          own.dump() + "," + own.dump() + "]");
}

TEST(DesignFile, AStudyWithNullIsTheSameStudyWithTheValue) {
  const json own = json::parse(shipped(kSceneName))[json::json_pointer(
      json::parse(shipped(kProtocolName))["design"]["factors"][1]["pointer"].get<std::string>())];
  Study with_null;
  Study with_value;
  for (Study* study : {&with_null, &with_value}) {
    study->with("/design/practice", json::array()).without("/design/practice_until");
  }
  const Protocol null = with_null.with("/design/factors/1/levels", {5, nullptr, 15}).made();
  const Protocol value = with_value.with("/design/factors/1/levels", {5, own, 15}).made();
  EXPECT_EQ(plan_for(null, "P01", 1), plan_for(value, "P01", 1));
  EXPECT_NE(null.hash, value.hash) << "the file is another";
}

}  // namespace impetus::design_file_test
