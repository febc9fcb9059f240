// What a scene says of its looks: what becomes of it, what is refused, and that no step of the
// world looks at it. SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "experiments/files/scene_files.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/run/live_run.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::appearance_test {
namespace {

constexpr const char* kBlocks = "stimuli/two-l-blocks.json";
constexpr const char* kOnGround = "stimuli/two-balls-on-the-ground.json";

json blocks() { return json::parse(shipped(kBlocks)); }

json blocks_that_look(const json& appearance) {
  return changed(blocks(), "/appearance", appearance);
}

/// Two balls of 1°, which touch the ground at their start where its height is left out.
json two_balls() { return json::parse(shipped("stimuli/two-spheres.json")); }

std::vector<std::uint64_t> hashes_of(const StagedScene& scene) {
  LiveRun live(scene, /*seed=*/1);
  static_cast<void>(live.poses_at(scene.duration_s));
  std::vector<std::uint64_t> hashes;
  for (const StepRecord& step : live.take_steps()) {
    hashes.push_back(step.state.hash);
  }
  return hashes;
}

/// How many bodies have the colour of the body that starts nearest to them.
int alike_beside_each_other(const StagedScene& scene) {
  const auto& states = scene.world.states();
  int alike = 0;
  for (std::size_t body = 0; body < states.size(); ++body) {
    std::size_t nearest = body == 0 ? 1 : 0;
    const auto apart_m = [&](std::size_t other) {
      return (states[other].pose.position - states[body].pose.position).norm();
    };
    for (std::size_t other = 0; other < states.size(); ++other) {
      if (other != body && apart_m(other) < apart_m(nearest)) {
        nearest = other;
      }
    }
    alike += scene.looks[body].colour == scene.looks[nearest].colour ? 1 : 0;
  }
  return alike;
}

}  // namespace

// ---------------------------------------------------------------- what is said, and what is usual

TEST(Appearance, OfAShippedSceneIsNoneUnlessItSaysSo) {
  EXPECT_EQ(built(blocks()).appearance, nullptr);
  EXPECT_NE(built(json::parse(shipped(kOnGround))).appearance, nullptr);
}

TEST(Appearance, ThatSaysOnlyWhatIsUsualIsNone) {
  const json usual = json::parse(R"({
    "ground": "none", "ground_deg": -3, "ground_colour": "#123456", "check_deg": 5,
    "cast_shadows": 0, "contact_shadows": 0, "texture": "none", "gloss": 0.1,
    "smooth_below_deg": 30, "colours": "given"})");
  EXPECT_EQ(built(blocks_that_look(usual)).appearance, nullptr);
  EXPECT_EQ(built(blocks_that_look(json::object())).appearance, nullptr);
}

TEST(Appearance, EachChoiceAloneMakesOne) {
  const json choices = json::parse(R"({
    "ground": "plain", "cast_shadows": 0.5, "contact_shadows": 0.5, "texture": "marble",
    "gloss": 0, "smooth_below_deg": 75, "lights": [{"azimuth_deg": 0, "elevation_deg": 90}]})");
  for (const auto& [key, value] : choices.items()) {
    EXPECT_NE(built(blocks_that_look({{key, value}})).appearance, nullptr) << key;
  }
  EXPECT_NE(built(changed(blocks(), "/bodies/0/texture", "wood")).appearance, nullptr);
  EXPECT_EQ(built(changed(blocks(), "/bodies/0/texture", "none")).appearance, nullptr);
}

TEST(Appearance, HasAllThatTheSceneSays) {
  const StagedScene scene = built(json::parse(shipped(kOnGround)));
  const Appearance& appearance = *scene.appearance;
  EXPECT_EQ(appearance.ground, GroundPattern::kChecks);
  EXPECT_EQ(appearance.check_m, metres_of(3.0));
  EXPECT_EQ(appearance.cast_shadows, 0.85);
  EXPECT_EQ(appearance.contact_shadows, 0.8);
  EXPECT_EQ(appearance.gloss, 0.2);
  ASSERT_EQ(appearance.lights.size(), 2U);
  EXPECT_EQ(appearance.lights[1].strength, 0.35);
  EXPECT_EQ(scene.looks[0].texture, SurfaceTexture::kWood);
  EXPECT_EQ(scene.looks[1].texture, SurfaceTexture::kMarble);
}

// azimuth 90° and elevation 0: along x; elevation 90°: along y
TEST(Appearance, LightsComeFromWhereTheSceneSaysAndAreOffAtStrengthZero) {
  const StagedScene scene = built(blocks_that_look(json::parse(R"({"lights": [
    {"azimuth_deg": 90, "elevation_deg": 0, "strength": 0.5},
    {"azimuth_deg": 0, "elevation_deg": 45, "strength": 0},
    {"azimuth_deg": 30, "elevation_deg": 90}]})")));
  ASSERT_EQ(scene.appearance->lights.size(), 2U);
  EXPECT_TRUE(scene.appearance->lights[0].towards.isApprox(Vector3::UnitX(), 1e-12));
  EXPECT_TRUE(scene.appearance->lights[1].towards.isApprox(Vector3::UnitY(), 1e-12));
  EXPECT_EQ(scene.appearance->lights[1].strength, 1.0);
}

TEST(Appearance, ItsUsualLightIsFromTheViewersUpperLeftWhereverTheViewerIs) {
  for (const double azimuth_deg : {0.0, 60.0}) {
    const StagedScene scene =
        built(changed(blocks_that_look({{"cast_shadows", 1}}), "/viewer/azimuth_deg", azimuth_deg));
    ASSERT_EQ(scene.appearance->lights.size(), 1U);
    const Vector3& towards = scene.appearance->lights[0].towards;
    EXPECT_LT(towards.dot(scene.viewer.right), -0.3);
    EXPECT_GT(towards.dot(scene.viewer.up), 0.3);
    EXPECT_GT(towards.dot(scene.viewer.eye), 0.0);
  }
}

// ---------------------------------------------------------------- the ground

TEST(Appearance, ItsGroundTouchesTheLowestBodyUnlessItsHeightIsSaid) {
  const json ground = {{"ground", "plain"}};
  const auto balls = built(changed(two_balls(), "/appearance", ground));
  EXPECT_NEAR(*balls.appearance->floor_m, -metres_of(1.0), 1e-12);
  const auto said =
      built(changed(two_balls(), "/appearance", {{"ground", "plain"}, {"ground_deg", -3}}));
  EXPECT_NEAR(*said.appearance->floor_m, -metres_of(3.0), 1e-12);
  const StagedScene staged = built(blocks_that_look(ground));
  const Pose& pose = staged.world.states()[0].pose;
  double lowest_m = 1.0;
  for (const Vector3& vertex : staged.looks[0].mesh->vertices) {
    lowest_m = std::min(lowest_m, pose.transform(vertex).y());
  }
  EXPECT_NEAR(*staged.appearance->floor_m, lowest_m, 1e-12) << "the blocks mirror each other";
}

TEST(Appearance, ContactShadowsFallOnACubesFloorAndOnNoneWhereThereIsNoFloor) {
  const json contact = {{"contact_shadows", 0.5}};
  const StagedScene cube = built(changed(crowd_scene(), "/appearance", contact));
  EXPECT_NEAR(*cube.appearance->floor_m, -0.5 * metres_of(15.0), 1e-12);
  EXPECT_FALSE(built(blocks_that_look(contact)).appearance->floor_m);
}

// ---------------------------------------------------------------- colours

TEST(Appearance, ColoursApartLeaveNoNeighboursAlike) {
  json crowd = changed(crowd_scene(), "/crowd/count", 40);
  ASSERT_GT(alike_beside_each_other(built(crowd)), 0) << "as they are given, some are";
  crowd["appearance"] = {{"colours", "apart"}};
  const StagedScene scene = built(crowd);
  EXPECT_EQ(alike_beside_each_other(scene), 0);
  EXPECT_EQ(scene.appearance, nullptr) << "colours alone are painted plainly";
}

TEST(Appearance, ColoursApartAreAllDifferentWhereThereAreEnough) {
  json crowd = changed(crowd_scene(), "/crowd/count", 6);
  crowd["crowd"]["colours"] = {"#d9813b"};
  crowd["appearance"] = {{"colours", "apart"}};
  std::set<Colour> colours;
  for (const DrawnBody& look : built(crowd).looks) {
    colours.insert(look.colour);
  }
  EXPECT_EQ(colours.size(), 6U);
}

TEST(Appearance, ColoursApartKeepThoseOfTwoBodiesThatDiffer) {
  const StagedScene given = built(blocks());
  const StagedScene apart = built(blocks_that_look({{"colours", "apart"}}));
  EXPECT_EQ(apart.looks[0].colour, given.looks[0].colour);
  EXPECT_EQ(apart.looks[1].colour, given.looks[1].colour);
}

TEST(Appearance, ColoursApartGiveAllPartsOfACrowdsFigureOne) {
  JsonDocument scene = load_scene(source_folder() + "/stimuli/humanoids-in-a-cube.json");
  scene.value["figure_crowd"]["count"] = 3;
  scene.value["appearance"] = {{"colours", "apart"}};
  const StagedScene staged = built(scene.value);
  std::set<Colour> colours;
  for (const Figure& figure : staged.world.settings().figures) {
    const auto first = static_cast<std::size_t>(figure.first_part);
    for (std::size_t part = 1; part < static_cast<std::size_t>(figure.part_count); ++part) {
      EXPECT_EQ(staged.looks[first + part].colour, staged.looks[first].colour);
    }
    colours.insert(staged.looks[first].colour);
  }
  EXPECT_EQ(colours.size(), 3U);
}

// ---------------------------------------------------------------- no step looks at it

TEST(Appearance, ChangesNoStep) {
  json all = json::parse(shipped(kOnGround))["appearance"];
  all["texture"] = "wood";
  all["colours"] = "apart";
  const auto plain = hashes_of(built(blocks()));
  ASSERT_GT(plain.size(), 100U);
  EXPECT_EQ(hashes_of(built(blocks_that_look(all))), plain);
}

TEST(Appearance, IsVariedByAProtocolsFactor) {
  const std::string name = "protocols/gap.json";
  json protocol = json::parse(shipped(name));
  json& factors = protocol["design"]["factors"];
  const json varied = {{"/appearance/cast_shadows", {0, 0.8}},
                       {"/appearance/texture", {"none", "wood"}},
                       {"/appearance/ground", {"none", "checks"}}};
  for (const auto& [pointer, levels] : varied.items()) {
    const std::string factor = pointer.substr(pointer.rfind('/') + 1);
    factors.push_back({{"name", factor}, {"pointer", pointer}, {"levels", levels}});
    for (json& condition : protocol["design"]["practice"]) {
      condition[factor] = levels[0];
    }
  }
  const json scene = blocks_that_look(
      {{"cast_shadows", 0}, {"texture", "none"}, {"ground", "none"}, {"contact_shadows", 0}});
  const Protocol read =
      make_protocol(parse_json(name, protocol.dump()), parse_json(kBlocks, scene.dump()));
  const ProtocolScenes scenes(read, 0.0);
  int plain = 0;
  std::set<std::tuple<double, SurfaceTexture, GroundPattern>> looks;
  for (const Condition& cell : cells(read.design)) {
    const StagedScene staged = scenes.stage(cell, assumed_screen());
    const Appearance look = staged.appearance ? *staged.appearance : Appearance();
    plain += staged.appearance ? 0 : 1;
    looks.emplace(look.cast_shadows, look.texture, look.ground);
  }
  EXPECT_EQ(looks.size(), 8U) << "two levels of three factors";
  EXPECT_EQ(static_cast<std::size_t>(plain), cells(read.design).size() / 8)
      << "all at their first level are painted plainly";
}

// ---------------------------------------------------------------- refusals

TEST(Appearance, WhatItCannotBeIsRefusedByName) {
  const auto refused = [](const std::string& key, const json& value) {
    return scene_refusal(blocks_that_look({{key, value}}));
  };
  EXPECT_EQ(refused("cast_shadows", 2),
            "/appearance/cast_shadows: expected a number ≥ 0 and ≤ 1, got 2");
  EXPECT_EQ(refused("ground", "grass"),
            "/appearance/ground: expected one of \"none\", \"plain\", \"checks\", got \"grass\"");
  EXPECT_EQ(
      refused("texture", "brick"),
      "/appearance/texture: expected one of \"none\", \"wood\", \"marble\", \"speckles\", got "
      "\"brick\"");
  EXPECT_EQ(refused("lights", json::array()),
            "/appearance/lights: expected a list of 1 to 4 values, got []");
  EXPECT_EQ(refused("lights", {{{"azimuth_deg", 0}, {"elevation_deg", -5}}}),
            "/appearance/lights/0/elevation_deg: expected a number ≥ 0 and ≤ 90, got -5");
  EXPECT_EQ(
      refused("shadows", true),
      "/appearance: expected only the keys \"cast_shadows\", \"check_deg\", \"colours\", "
      "\"contact_shadows\", \"gloss\", \"ground\", \"ground_colour\", \"ground_deg\", \"lights\", "
      "\"smooth_below_deg\", \"texture\", got \"shadows\"");
  EXPECT_EQ(scene_refusal(changed(blocks(), "/viewer/elevation_deg", 90)),
            "/viewer/elevation_deg: expected a number ≥ 0 and ≤ 80, got 90");
}

TEST(Appearance, AGroundBesideAnEnclosureIsRefused) {
  EXPECT_EQ(scene_refusal(changed(crowd_scene(), "/appearance", {{"ground", "plain"}})),
            "/appearance/ground: expected \"none\" beside an enclosure, whose floor is the ground, "
            "got \"plain\"");
}

// ---------------------------------------------------------------- the raised eye

TEST(RaisedViewer, LooksDownAtTheOriginFromTheSameDistance) {
  const ScreenGeometry screen = assumed_screen();
  const Viewer raised = viewer_at(screen, 40.0, 25.0);
  EXPECT_NEAR(raised.eye.norm(), screen.viewing_distance_m, 1e-12);
  EXPECT_NEAR(raised.eye.y(), screen.viewing_distance_m * std::sin(25.0 * std::acos(-1.0) / 180.0),
              1e-12);
  EXPECT_TRUE(raised.right.cross(raised.up).isApprox(raised.eye.normalized(), 1e-12));
  EXPECT_EQ(raised.right, viewer_at(screen, 40.0).right);
}

TEST(RaisedViewer, AtZeroKeepsEveryBitOfALevelOne) {
  const json level = changed(blocks(), "/viewer/elevation_deg", 0);
  EXPECT_EQ(hashes_of(built(level)), hashes_of(built(blocks())));
  const Viewer viewer = viewer_at(assumed_screen(), 40.0, 0.0);
  EXPECT_EQ(viewer.up, Vector3(Vector3::UnitY()));
  EXPECT_FALSE(std::signbit(viewer.eye.y()));
}

TEST(RaisedViewer, StaysAsHighWhenItGoesRound) {
  json scene = changed(blocks(), "/viewer/elevation_deg", 30);
  scene["viewer"]["turn_deg_s"] = 20;
  const StagedScene staged = built(scene);
  const Viewer later = staged.viewer_at_time(1.5);
  EXPECT_NEAR(later.eye.y(), staged.viewer.eye.y(), 1e-12);
  EXPECT_TRUE(later.eye.isApprox(viewer_at(assumed_screen(), 30.0, 30.0).eye, 1e-12));
}

}  // namespace impetus::appearance_test
