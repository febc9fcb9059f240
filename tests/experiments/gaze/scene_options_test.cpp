// What a scene may ask of the engine beyond lists and thresholds: every option has a default, and
// every wrong one is refused by name.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "experiments/gaze/region_source.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::scene_options_test {

/// The free scene with two lists by a metric.
json scheduled_scene(const std::string& scheduler = "size") {
  return changed(free_scene(), "/engine/schedule",
                 {{"scheduler", scheduler},
                  {"lists", {json::object(), json::object()}},
                  {"thresholds", {1.0}}});
}

json with_schedule(const std::string& key, json value, const std::string& scheduler = "size") {
  return changed(scheduled_scene(scheduler), "/engine/schedule/" + key, std::move(value));
}

const WorldSettings& world_settings(const StagedScene& scene) { return scene.world.settings(); }

TEST(SceneOptions, WhatASceneLeavesOutIsAsTheEngineHasIt) {
  const StagedScene scene = built(free_scene());
  const WorldSettings usual;
  const WorldSettings& settings = world_settings(scene);
  EXPECT_EQ(settings.contacts.reduction, usual.contacts.reduction);
  EXPECT_EQ(settings.contacts.most_per_pair, usual.contacts.most_per_pair);
  EXPECT_EQ(settings.tunnelling, usual.tunnelling);
  EXPECT_EQ(settings.costs, usual.costs);
  EXPECT_EQ(settings.response, usual.response);
  EXPECT_TRUE(settings.materials.empty());
  EXPECT_EQ(settings.wall_material, 0);
  EXPECT_EQ(settings.schedule.traversal, usual.schedule.traversal);
  EXPECT_EQ(settings.schedule.persistence_steps, 0);
}

TEST(SceneOptions, EveryReductionOfTheEngineIsOneOfTheSchemas) {
  const json known = scene_schema()["properties"]["engine"]["properties"]["contacts"]["properties"]
                                   ["reduction"]["enum"];
  std::vector<std::string> names;
  for (const std::string_view name : reduction_names()) {
    names.emplace_back(name);
    const json scene = changed(free_scene(), "/engine/contacts",
                               {{"reduction", names.back()}, {"most_per_pair", 7}});
    EXPECT_EQ(scene_refusal(scene), "accepted") << name;
    EXPECT_EQ(world_settings(built(scene)).contacts.most_per_pair, 7);
  }
  EXPECT_EQ(known.get<std::vector<std::string>>(), names);
  EXPECT_EQ(
      scene_refusal(changed(free_scene(), "/engine/contacts", {{"reduction", "mean"}})),
      "/engine/contacts/reduction: expected one of \"none\", \"first\", \"average\", \"groups\", "
      "\"density\", \"weighted\", got \"mean\"");
  EXPECT_EQ(scene_refusal(changed(free_scene(), "/engine/contacts", {{"most_per_pair", 0}})),
            "/engine/contacts/most_per_pair: expected a whole number ≥ 1 and ≤ 64, got 0");
}

TEST(SceneOptions, WhatBecomesOfFastBodiesIsAskedForByName) {
  const auto asked = [](const char* name) {
    return world_settings(built(changed(free_scene(), "/engine/tunnelling", name))).tunnelling;
  };
  EXPECT_EQ(asked("ignored"), Tunnelling::kIgnored);
  EXPECT_EQ(asked("capped"), Tunnelling::kCapped);
  EXPECT_EQ(asked("stop-at-entry"), Tunnelling::kStopAtEntry);
  EXPECT_EQ(scene_refusal(changed(free_scene(), "/engine/tunnelling", "substeps")),
            "/engine/tunnelling: expected one of \"ignored\", \"capped\", \"stop-at-entry\", got "
            "\"substeps\"");
}

TEST(SceneOptions, TestsAlongTheWaysOfFastBodiesAreLimitedWhereASceneSays) {
  const auto with = [](const json& tests) {
    return changed(free_scene(), "/engine/most_entry_tests", tests);
  };
  EXPECT_EQ(world_settings(built(free_scene())).most_entry_tests, kUnlimitedTests);
  EXPECT_EQ(world_settings(built(with(0))).most_entry_tests, 0);
  EXPECT_EQ(world_settings(built(with(250'000))).most_entry_tests, 250'000);
  EXPECT_EQ(scene_refusal(with(-1)),
            "/engine/most_entry_tests: expected a whole number ≥ 0 and ≤ 1000000000, got -1");
  EXPECT_EQ(scene_refusal(with("few")),
            "/engine/most_entry_tests: expected a whole number ≥ 0 and ≤ 1000000000, got \"few\"");
}

TEST(SceneOptions, HowRotationIsSteppedIsAskedForByName) {
  const auto asked = [](const char* name) {
    return world_settings(built(changed(free_scene(), "/engine/rotation", name))).rotation;
  };
  EXPECT_EQ(world_settings(built(free_scene())).rotation, WorldSettings{}.rotation);
  EXPECT_EQ(asked("midpoint"), Rotation::kMidpoint);
  EXPECT_EQ(asked("energy-kept"), Rotation::kEnergyKept);
  EXPECT_EQ(scene_refusal(changed(free_scene(), "/engine/rotation", "euler")),
            "/engine/rotation: expected one of \"midpoint\", \"energy-kept\", got \"euler\"");
}

TEST(SceneOptions, GravityIsThreeNumbersAndNoneWhenLeftOut) {
  const auto with = [](const json& gravity) {
    return changed(free_scene(), "/engine/gravity_m_s2", gravity);
  };
  EXPECT_EQ(world_settings(built(free_scene())).gravity_m_s2, Vector3(0.0, 0.0, 0.0));
  EXPECT_EQ(world_settings(built(with({0, -9.81, 0.5}))).gravity_m_s2, Vector3(0.0, -9.81, 0.5));
  EXPECT_EQ(scene_refusal(with({0, -9.81})),
            "/engine/gravity_m_s2: expected a list of 3 values, got [0,-9.81]");
  EXPECT_EQ(scene_refusal(with({0, -1001, 0})),
            "/engine/gravity_m_s2/1: expected a number ≥ -1000 and ≤ 1000, got -1001");
}

TEST(SceneOptions, PassesOfTheResponseAreUnlimitedWhenLeftOut) {
  const auto with = [](int passes) {
    return changed(free_scene(), "/engine/response_passes", passes);
  };
  EXPECT_EQ(world_settings(built(free_scene())).most_response_passes, kUnlimitedPasses);
  EXPECT_EQ(world_settings(built(with(10))).most_response_passes, 10);
  EXPECT_EQ(scene_refusal(with(0)),
            "/engine/response_passes: expected a whole number ≥ 1 and ≤ 1000, got 0");
}

TEST(SceneOptions, TheOrderWithinAListIsAskedForByName) {
  const auto asked = [](const char* name) {
    return world_settings(built(with_schedule("traversal", name))).schedule.traversal;
  };
  EXPECT_EQ(asked("depth-first"), make_traversal("depth-first"));
  EXPECT_EQ(asked("breadth-first"), make_traversal("breadth-first"));
  EXPECT_EQ(asked("best-first"), make_traversal("best-first"));
  EXPECT_EQ(asked("visible-first"), make_traversal("visible-first"));
  EXPECT_TRUE(built(with_schedule("traversal", "visible-first")).depends_on_gaze);
  EXPECT_EQ(scene_refusal(with_schedule("traversal", "random")),
            "/engine/schedule/traversal: expected one of \"depth-first\", \"breadth-first\", "
            "\"best-first\", \"visible-first\", got \"random\"");
}

TEST(SceneOptions, PersistenceIsAWholeNumberOfSteps) {
  const json scene = with_schedule("persistence_ms", 100);
  EXPECT_EQ(scene_refusal(scene), "accepted");
  EXPECT_EQ(world_settings(built(scene)).schedule.persistence_steps, 24);
  EXPECT_EQ(
      scene_refusal(with_schedule("persistence_ms", 101)),
      "/engine/schedule/persistence_ms: expected a whole number of steps of 1/240 s, got 101");
}

TEST(SceneOptions, ListsTakeSharesOfThePairsInPlaceOfThresholds) {
  json scene = with_schedule("pair_shares", {0.25});
  EXPECT_EQ(scene_refusal(scene),
            "/engine/schedule/thresholds: expected none beside pair_shares, got [1.0]");
  scene["engine"]["schedule"].erase("thresholds");
  EXPECT_EQ(scene_refusal(scene), "accepted");
  EXPECT_EQ(world_settings(built(scene)).schedule.rule, make_list_rule("pair_shares"));
  EXPECT_EQ(world_settings(built(scene)).schedule.limits, std::vector<double>{0.25});
  scene["engine"]["schedule"]["pair_shares"] = {0.25, 0.25};
  EXPECT_EQ(scene_refusal(scene),
            "/engine/schedule/pair_shares: expected one fewer than lists, 1, got 2");
  EXPECT_EQ(scene_refusal(changed(crowd_scene(), "/engine/schedule/pair_shares", {0.5})),
            "/engine/schedule/pair_shares: expected none with the scheduler region, got [0.5]");
}

TEST(SceneOptions, EccentricityFromAPointDoesNotDependOnGaze) {
  const json scene = with_schedule("point_deg", {2, -1}, "eccentricity");
  EXPECT_EQ(scene_refusal(scene), "accepted");
  EXPECT_TRUE(built(scheduled_scene("eccentricity")).depends_on_gaze);
  const StagedScene staged = built(scene);
  EXPECT_FALSE(staged.depends_on_gaze);
  // A body where the point is has no eccentricity, wherever the viewer looks.
  PairBounds there;
  there.a.centre = there.b.centre = on_screen(staged.viewer, {metres_of(2.0), metres_of(-1.0)});
  const PriorityMetric& metric = *world_settings(staged).schedule.metric;
  EXPECT_NEAR(metric.measure(there, staged.viewer, ScreenPoint{0.1, 0.1}), 0.0, 1e-6);
  EXPECT_EQ(scene_refusal(with_schedule("point_deg", {2, -1})),
            "/engine/schedule/point_deg: expected none with the scheduler size, got [2,-1]");
}

TEST(SceneOptions, AWeightedSumHasTerms) {
  EXPECT_EQ(scene_refusal(scheduled_scene("weighted")),
            "/engine/schedule: expected the key \"terms\" for the scheduler weighted, which is "
            "missing");
  const json terms = {{{"metric", "eccentricity"}, {"urgent", 0}, {"relaxed", 10}, {"weight", 2}},
                      {{"metric", "velocity"}, {"urgent", 0}, {"relaxed", 60}}};
  EXPECT_EQ(scene_refusal(with_schedule("terms", terms, "weighted")), "accepted");
  EXPECT_TRUE(built(with_schedule("terms", terms, "weighted")).depends_on_gaze);
  EXPECT_EQ(scene_refusal(with_schedule("terms", json::array({terms[1]}))),
            "/engine/schedule/terms: expected none with the scheduler size, got "
            "[{\"metric\":\"velocity\",\"relaxed\":60,\"urgent\":0}]");
  json flat = json::array({terms[1]});
  flat[0]["relaxed"] = 0;
  const std::string refused = scene_refusal(with_schedule("terms", flat, "weighted"));
  EXPECT_TRUE(refused.starts_with("/engine/schedule: ")) << refused;
}

TEST(SceneOptions, AFixedRegionHasItsPoint) {
  json scene = changed(crowd_scene(), "/engine/region/kind", "fixed");
  EXPECT_EQ(scene_refusal(scene),
            "/engine/region: expected the key \"point_deg\" for kind fixed, which is missing");
  scene["engine"]["region"]["point_deg"] = {3, 1};
  EXPECT_EQ(scene_refusal(scene), "accepted");
  RegionSource regions(built(scene), /*seed=*/1);
  for (std::int64_t step = 1; step <= 100; ++step) {
    const auto region = regions.at(step, ScreenPoint{0.05, 0.05});
    ASSERT_TRUE(region);
    EXPECT_EQ(region->centre, (ScreenPoint{metres_of(3.0), metres_of(1.0)}));
    EXPECT_EQ(region->radius_deg, 5.0);
  }
  scene["engine"]["region"]["kind"] = "tracked";
  EXPECT_EQ(scene_refusal(scene),
            "/engine/region/point_deg: expected none for kind tracked, got [3,1]");
}

TEST(SceneOptions, ABudgetHasOneLimitAndCountsWhatItSays) {
  const auto budget = [](json value) { return changed(free_scene(), "/engine/budget", value); };
  EXPECT_EQ(world_settings(built(budget({{"tests_per_step", 9}}))).costs, WorkCosts{});
  const json all = budget({{"ms_per_step", 1}, {"counts", "all-phases"}});
  EXPECT_EQ(scene_refusal(all), "accepted");
  EXPECT_EQ(world_settings(built(all)).costs, kAllPhases);
  const std::string place =
      "/engine/budget: expected one of the keys \"tests_per_step\" and "
      "\"ms_per_step\", got ";
  EXPECT_EQ(scene_refusal(budget({{"counts", "tests"}})), place + "none");
  EXPECT_EQ(scene_refusal(budget({{"tests_per_step", 9}, {"ms_per_step", 1}})), place + "both");
  EXPECT_EQ(scene_refusal(budget({{"tests_per_step", 9}, {"counts", "time"}})),
            "/engine/budget/counts: expected one of \"tests\", \"all-phases\", got \"time\"");
}

/// The free scene whose ball is of steel and whose box and walls are of rubber.
json material_scene() {
  json scene = free_scene();
  scene["bodies"][0]["material"] = "steel";
  scene["bodies"][1]["material"] = "rubber";
  scene["enclosure"]["material"] = "rubber";
  scene["engine"]["materials"] =
      json::parse(R"([{"pair": ["steel", "rubber"], "restitution": 0.25}])");
  return scene;
}

TEST(SceneOptions, MaterialsAreNumberedByNameForBodiesAndWallsAlike) {
  EXPECT_EQ(scene_refusal(material_scene()), "accepted");
  const StagedScene scene = built(material_scene());
  const auto& models = scene.world.models();
  EXPECT_EQ(models[1].material, world_settings(scene).wall_material);
  EXPECT_NE(models[0].material, models[1].material);
  EXPECT_EQ(models[2].material, 0);
  ASSERT_EQ(world_settings(scene).materials.size(), 1U);
  const PairRestitution& pair = world_settings(scene).materials[0];
  EXPECT_EQ(pair.material, models[0].material);
  EXPECT_EQ(pair.other, models[1].material);
  EXPECT_EQ(pair.restitution, 0.25);
}

TEST(SceneOptions, AMaterialThatNothingHasAndAPairStatedTwiceAreRefused) {
  EXPECT_EQ(scene_refusal(changed(material_scene(), "/engine/materials/0/pair/1", "wood")),
            "/engine/materials/0/pair/1: expected a material that a body, the crowd or the "
            "enclosure has, got \"wood\"");
  json twice = material_scene();
  twice["engine"]["materials"].push_back({{"pair", {"rubber", "steel"}}, {"restitution", 0.5}});
  EXPECT_EQ(scene_refusal(twice),
            "/engine/materials/1/pair: expected a pair of its own, got [\"rubber\",\"steel\"] "
            "again");
}

TEST(SceneOptions, AFixedBodyStaysAndWhatMeetsItComesBack) {
  json scene = changed(free_scene(), "/bodies/1/fixed", true);
  EXPECT_EQ(scene_refusal(scene),
            "/bodies/1/spin_deg_s: expected none for a body that is fixed, got [0,90,0]");
  scene["bodies"][1].erase("spin_deg_s");
  EXPECT_EQ(scene_refusal(scene), "accepted");
  StagedScene staged = built(scene);
  const Vector3 place = staged.world.states()[1].pose.position;
  FixedWork meter(kUnlimitedTests);
  for (int step = 0; step < 300; ++step) {
    static_cast<void>(staged.world.step({1.0 / 240.0, staged.viewer}, meter));
  }
  EXPECT_EQ(staged.world.states()[1].pose.position, place);
  EXPECT_EQ(staged.world.states()[1].angular_momentum, Vector3::Zero());
  EXPECT_LT(velocity(staged.world.models()[0], staged.world.states()[0]).x(), 0.0);
}

TEST(SceneOptions, BodiesThatAreFixedMayOverlapEachOtherAndTheWalls) {
  json scene = free_scene();
  for (json& body : scene["bodies"]) {
    body.erase("velocity_deg_s");
    body.erase("spin_deg_s");
    body["position_deg"] = {9.5, 0, 0};
    body["fixed"] = true;
  }
  EXPECT_EQ(scene_refusal(scene), "accepted");
  scene["bodies"][0]["fixed"] = false;
  EXPECT_NE(scene_refusal(scene), "accepted");
}

TEST(SceneOptions, WhatMeetsIsNotFixed) {
  json meeting = json::parse(shipped(kSceneName));
  meeting["bodies"][0]["fixed"] = true;
  EXPECT_EQ(scene_refusal(meeting), "/bodies/0/fixed: expected none where bodies meet");
}

TEST(SceneOptions, AProtocolsFactorMaySetThem) {
  const auto study = [](const json& levels) {
    return Study()
        .scene_with("/engine/tunnelling", "ignored")
        .with("/design/factors/0/pointer", "/engine/tunnelling")
        .with("/design/factors/0/levels", levels)
        .with("/design/practice",
              json::parse(R"([{"delay_ms": "capped", "speed_deg_s": 10, "viewpoint_deg": 0}])"));
  };
  const std::string place = std::string(kProtocolName) + ":/design/factors/0/levels/1: ";
  EXPECT_EQ(study({"capped", "ignored"}).refused(), "accepted");
  EXPECT_EQ(study({"capped", "often"}).refused(),
            place + "expected one of \"ignored\", \"capped\", \"stop-at-entry\", got \"often\"");
}

/// The words that the schema allows at a place of a schedule.
std::set<std::string> words_at(const char* pointer) {
  const json schema = json::parse(shipped("stimuli/scene.schema.json"));
  const json& schedule =
      schema.at(json::json_pointer("/properties/engine/properties/schedule/properties"));
  return schedule.at(json::json_pointer(pointer)).get<std::set<std::string>>();
}

TEST(SceneSchema, KnowsEverySchedulerOfTheEngineByItsNameAndNoOther) {
  std::set<std::string> terms;
  std::set<std::string> schedulers{"region"};
  for (const std::string_view name : metric_names()) {
    schedulers.emplace(name);
    if (!needs_terms(name)) {
      terms.emplace(name);
    }
  }
  EXPECT_EQ(words_at("/scheduler/enum"), schedulers);
  EXPECT_EQ(words_at("/terms/items/properties/metric/enum"), terms);
  const auto traversals = traversal_names();
  EXPECT_EQ(words_at("/traversal/enum"),
            std::set<std::string>(traversals.begin(), traversals.end()));
  const json schema = json::parse(shipped("stimuli/scene.schema.json"));
  for (const std::string& key : limited_list_rule_names()) {
    EXPECT_TRUE(schema.contains(
        json::json_pointer("/properties/engine/properties/schedule/properties/" + key)))
        << key;
  }
}

}  // namespace impetus::scene_options_test
