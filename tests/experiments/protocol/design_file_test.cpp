// What a valid protocol becomes: its design, its hash, its conditions, its frames.
// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "tests/experiments/refusals.hpp"
#include "tests/places/places.hpp"

namespace impetus::design_file_test {

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

}  // namespace impetus::design_file_test
