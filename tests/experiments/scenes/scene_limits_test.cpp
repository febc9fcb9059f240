// Scenes beyond the engine's limits, and the sentences with which they are refused.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "engine/dynamics/limits.hpp"
#include "tests/experiments/program.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::scene_limits_test {

TEST(SceneLimits, ScenesThatAreShippedLieWithinThem) {
  EXPECT_EQ(scene_refusal(free_scene()), "accepted");
  EXPECT_EQ(scene_refusal(crowd_scene()), "accepted");
}

TEST(SceneLimits, ABodyThinnerThanAMicrometreIsRefused) {
  EXPECT_EQ(scene_refusal(changed(free_scene(), "/bodies/0/shape/radius_deg", 1e-5)),
            "/bodies/0/shape/radius_deg: expected 1e-06 m or more, seen on the screen, got "
            "9.94863e-08 m");
  EXPECT_EQ(scene_refusal(changed(free_scene(), "/bodies/1/shape/height_deg", 5e-5)),
            "/bodies/1/shape/height_deg: expected 1e-06 m or more, seen on the screen, got "
            "4.97431e-07 m");
  EXPECT_EQ(scene_refusal(changed(crowd_scene(), "/crowd/shape/thickness_deg", 5e-5)),
            "/crowd/shape/thickness_deg: expected 1e-06 m or more, seen on the screen, got "
            "4.97431e-07 m");
  EXPECT_EQ(scene_refusal(changed(free_scene(), "/bodies/0/shape/radius_deg", 1e-300)),
            "/bodies/0/shape/radius_deg: expected 1e-06 m or more, seen on the screen, got "
            "9.94863e-303 m");
}

TEST(SceneLimits, ANeedleBeyondTheRatioOfItsMomentsIsRefused) {
  json needle = changed(free_scene(), "/bodies/1/shape/width_deg", 2e-4);
  needle["bodies"][1]["shape"]["height_deg"] = 2e-4;
  EXPECT_EQ(scene_refusal(needle),
            "/bodies/1/shape: expected moments of inertia at most 1e+07 to one, got 1.125e+08");
}

TEST(SceneLimits, MassesFurtherApartThanTheRatioAreRefused) {
  json scene = changed(free_scene(), "/bodies/0/density_kg_m3", 1e-8);
  scene["bodies"][1]["density_kg_m3"] = 1e6;
  const std::string sentence = scene_refusal(scene);
  EXPECT_TRUE(sentence.starts_with("/bodies: expected masses at most 1e+12 to one, got "))
      << sentence;
  scene["bodies"][1]["fixed"] = true;
  scene["bodies"][1].erase("spin_deg_s");
  EXPECT_EQ(scene_refusal(changed(scene, "/bodies/2/density_kg_m3", 1e-8)), "accepted")
      << "what is fixed has no mass";
}

TEST(SceneLimits, AFallBeyondWherePlacesAreKnownIsRefused) {
  json scene = changed(free_scene(), "/engine/gravity_m_s2", {0, -1000, 0});
  scene["duration_s"] = 3600;
  EXPECT_EQ(scene_refusal(scene), "accepted") << "there are walls";
  scene.erase("enclosure");
  EXPECT_EQ(scene_refusal(scene),
            "/engine/gravity_m_s2: expected a fall of 1e+08 m at most in the 3600 s that the scene "
            "lasts, got 6.48e+09 m");
}

TEST(SceneLimits, ARandomSpinBeyondTheLimitIsRefused) {
  json scene = json::parse(shipped("stimuli/two-l-blocks-off-centre.json"));
  EXPECT_EQ(scene_refusal(scene), "accepted");
  scene["imposed"]["random_spin"]["b"]["most_rad_s"] = {6000, 8000, 100};
  EXPECT_EQ(scene_refusal(scene),
            "/imposed/random_spin/b: expected a spin of 10000 rad/s at most, got 10000.5 rad/s");
}

TEST(SceneLimits, TheSchemaKeepsWithinAllOthers) {
  const json& schema = scene_schema();
  const json& engine = schema["properties"]["engine"]["properties"];
  EXPECT_GE(1.0 / engine["step_hz"]["maximum"].get<double>(), kLeastStep_s);
  EXPECT_LE(1.0 / engine["step_hz"]["minimum"].get<double>(), kMostStep_s);
  const double farthest_m =
      metres_of(std::sqrt(3.0) * schema["definitions"]["vector"]["items"]["maximum"].get<double>());
  const double longest_s = schema["properties"]["duration_s"]["maximum"].get<double>();
  EXPECT_LE(farthest_m, kMostSpeed_m_s) << "a second";
  EXPECT_LE(farthest_m * (1.0 + longest_s), kMostDistance_m) << "at the end";
  const double most_deg_s = schema["definitions"]["vector"]["items"]["maximum"].get<double>();
  EXPECT_LE(std::sqrt(3.0) * most_deg_s * 0.0174533, kMostSpin_rad_s);
  for (const json& measure : schema["definitions"]["shape"]["properties"]) {
    if (measure.value("type", std::string()) == std::string("number")) {
      EXPECT_LE(metres_of(measure["maximum"].get<double>()), kMostSize_m);
    }
  }
}

TEST(SceneLimits, TheProgramRefusesToCheckAndToPreviewSuchAScene) {
  const TemporaryFolder folder;
  json scene = json::parse(shipped(kSceneName));
  scene["bodies"][0]["shape"]["radius_deg"] = 1e-5;
  json protocol = json::parse(shipped(kProtocolName));
  protocol["scene"] = "scene.json";
  folder.write("scene.json", scene.dump());
  folder.write("protocol.json", protocol.dump());
  const std::string sentence =
      "scene.json:/bodies/0/shape/radius_deg: expected 1e-06 m or more, seen on the screen, got "
      "9.94863e-08 m\n";
  const ProgramResult checked = run_program(folder, {"check", "protocol.json"});
  EXPECT_EQ(checked.status, 1);
  EXPECT_EQ(checked.errors, "impetus: " + sentence);
  const ProgramResult ran = run_program(folder, {"run", "protocol.json", "--db", "a.sqlite",
                                                 "--observer", "causality", "--participants", "1"});
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.errors, "impetus: " + sentence);
}

}  // namespace impetus::scene_limits_test
