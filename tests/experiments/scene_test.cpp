// Scenes and the worlds they become: crowds, free bodies, schedules, regions, budgets.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/scheduling/metrics.hpp"
#include "engine/world/starting_overlaps.hpp"
#include "experiments/run/scene_run.hpp"
#include "experiments/scenes/scene_enclosure.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::scene_test {

TEST(Scene, FreeBodiesStartWhereAndAsFastAsTheSceneSays) {
  const StagedScene scene = built(free_scene());
  ASSERT_EQ(scene.world.models().size(), 3U);
  const auto& models = scene.world.models();
  const auto& states = scene.world.states();
  EXPECT_NEAR(states[0].pose.position.x(), metres_of(-5.0), 1e-12);
  EXPECT_NEAR(velocity(models[0], states[0]).x(), metres_of(10.0), 1e-12);
  EXPECT_NEAR(angular_velocity(models[1], states[1]).y(), std::acos(-1.0) / 2.0, 1e-12);
  EXPECT_EQ(closed_cube(scene.world.settings().enclosure)->half_edge_m, 0.5 * metres_of(20.0));
  EXPECT_EQ(scene.duration_s, 2.0);
  EXPECT_NEAR(1.0 / models[1].inverse_mass, 1000.0 * 6.0 * std::pow(metres_of(1.0), 3), 1e-9);
}

TEST(Scene, ABodyThatRestsIsLaunchedByTheOneThatMeetsIt) {
  const json launching = json::parse(shipped("stimuli/launching.json"));
  for (const double gap_arcmin : {0.0, 60.0}) {
    SceneRun run(built(changed(launching, "/meeting/gap_arcmin", gap_arcmin)));
    const std::vector<BodyModel>& models = run.world().models();
    const auto speed = [&](std::size_t body) {
      return velocity(models[body], run.world().states()[body]).x();
    };
    const double start_m = run.world().states()[1].pose.position.x();
    EXPECT_EQ(speed(1), 0.0);
    EXPECT_NEAR(speed(0), metres_of(10.0), 1e-12);
    for (int step = 0; step < 240; ++step) {
      EXPECT_EQ(run.world().states()[1].pose.position.x(), start_m) << step;
      run.step({});
    }
    run.step({});
    EXPECT_NEAR(speed(0), 0.0, 1e-9);
    EXPECT_NEAR(speed(1), metres_of(10.0), 1e-9);
    const double apart_m = start_m - run.world().states()[0].pose.position.x();
    EXPECT_NEAR(apart_m, metres_of(2.0 + gap_arcmin / 60.0), 0.01 * apart_m);
  }
}

TEST(Scene, ACrowdStartsApartAndWithinItsWallsAtTheCoarsestLevel) {
  for (const int count : {2, 5, 10, 15}) {
    for (int repetition = 1; repetition <= 5; ++repetition) {
      const StagedScene scene = built(changed(crowd_scene(), "/crowd/count", count),
                                      "main/" + std::to_string(repetition));
      EXPECT_EQ(scene.world.models().size(), static_cast<std::size_t>(count));
      EXPECT_TRUE(overlapping_at_start(scene.world, 0).empty()) << count << " " << repetition;
    }
  }
}

TEST(Scene, ACrowdMovesAndTurnsAtTheSpeedsTheSceneSays) {
  const StagedScene scene = built(crowd_scene());
  const json crowd = crowd_scene()["crowd"];
  for (std::size_t body = 0; body < scene.world.models().size(); ++body) {
    const BodyModel& model = scene.world.models()[body];
    const BodyState& state = scene.world.states()[body];
    EXPECT_NEAR(velocity(model, state).norm(), metres_of(crowd["speed_deg_s"]), 1e-12);
    EXPECT_NEAR(angular_velocity(model, state).norm() * 180.0 / std::acos(-1.0),
                crowd["spin_deg_s"].get<double>(), 1e-9);
  }
}

// edge = edge_at_count (count / at)^(1/3)
TEST(Scene, TheEnclosureKeepsTheDensityOfTheCrowd) {
  for (const int count : {1, 5, 10, 15, 40}) {
    const json scene = changed(crowd_scene(), "/crowd/count", count);
    const StagedScene staged = built(scene);
    const double edge_m = 2.0 * closed_cube(staged.world.settings().enclosure)->half_edge_m;
    EXPECT_NEAR(edge_m, metres_of(15.0) * std::cbrt(count / 5.0), 1e-12);
  }
}

TEST(Scene, ACrowdsStartFollowsFromItsNameAndNumberAlone) {
  const auto hash = [](const StagedScene& scene) { return hash_state(scene.world.states()).hash; };
  const std::uint64_t first = hash(built(crowd_scene()));
  EXPECT_EQ(hash(built(crowd_scene())), first);
  EXPECT_EQ(hash(built(changed(crowd_scene(), "/engine/region/kind", "all-bad"))), first);
  EXPECT_NE(hash(built(crowd_scene(), "main/2")), first);
  EXPECT_NE(hash(built(crowd_scene(), "practice/1")), first);
  EXPECT_NE(hash(built(changed(crowd_scene(), "/crowd/start", 2))), first);
}

TEST(Scene, EverySchedulerOfTheEngineIsOneOfTheSchemas) {
  json known = scene_schema()["properties"]["engine"]["properties"]["schedule"]["properties"]
                             ["scheduler"]["enum"];
  std::vector<std::string> names{"region"};
  for (const std::string_view name : metric_names()) {
    names.emplace_back(name);
    json scene = free_scene();
    scene["engine"]["schedule"] = {{"scheduler", std::string(name)},
                                   {"lists", {{{"share", 3}}, {{"greatest_level", 1}}}},
                                   {"thresholds", {0.5}}};
    if (name == "weighted") {
      scene["engine"]["schedule"]["terms"] = {{{"metric", "size"}, {"urgent", 10}, {"relaxed", 0}}};
    }
    EXPECT_EQ(scene_refusal(scene), "accepted") << name;
    const Schedule schedule = built(scene).world.settings().schedule;
    EXPECT_EQ(schedule.lists[0].share, 3.0);
    EXPECT_EQ(schedule.lists[1].greatest_level, 1);
    EXPECT_EQ(schedule.limits, std::vector<double>{0.5});
    EXPECT_EQ(built(scene).depends_on_gaze,
              name == "eccentricity" || name == "perceived" || name == "visible-frequency");
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(known.get<std::vector<std::string>>(), names);
}

TEST(Scene, AnUnknownSchedulerIsRefusedWithTheKnownOnes) {
  EXPECT_EQ(scene_refusal(changed(crowd_scene(), "/engine/schedule/scheduler", "nearest")),
            "/engine/schedule/scheduler: expected one of \"collision-speed\", \"distance\", "
            "\"eccentricity\", \"gap\", \"gap-bound\", \"perceived\", \"projected-centres\", "
            "\"projected-gap\", "
            "\"region\", "
            "\"size\", \"velocity\", \"visible-frequency\", \"weighted\", got \"nearest\"");
}

TEST(Scene, WhoNoticesIsSaidToTheSchedulerPerceived) {
  json scene = free_scene();
  scene["engine"]["schedule"] = {
      {"scheduler", "perceived"},
      {"lists", {json::object()}},
      {"noticing", {{"threshold_arcmin", 7}, {"width_log10", 0.3}, {"miss_rate", 0}}}};
  EXPECT_EQ(scene_refusal(scene), "accepted");
  EXPECT_EQ(built(scene).metric_options.noticing.threshold_arcmin, 7.0);
  scene["engine"]["schedule"]["scheduler"] = "size";  // as where schedulers are a factor
  EXPECT_EQ(scene_refusal(scene), "accepted");
  scene["engine"]["schedule"]["noticing"]["threshold_arcmin"] = 0;
  EXPECT_EQ(scene_refusal(scene),
            "/engine/schedule/noticing/threshold_arcmin: expected a number > 0 and ≤ 10000, got 0");
}

TEST(Scene, ListsAndThresholdsMustFitTogether) {
  json scene = free_scene();
  scene["engine"]["schedule"] = {{"scheduler", "size"},
                                 {"lists", {json::object(), json::object()}}};
  EXPECT_EQ(scene_refusal(scene),
            "/engine/schedule/thresholds: expected one fewer than lists, 1, got 0");
  scene["engine"]["schedule"]["thresholds"] = {1.0};
  scene["engine"]["schedule"]["lists"][1]["least_level"] = 3;
  EXPECT_EQ(scene_refusal(scene),
            "/engine/schedule/lists/1/least_level: expected at most 2, the deepest level of the "
            "trees, got 3");
  scene["engine"]["schedule"]["lists"][1] = {{"least_level", 2}, {"greatest_level", 1}};
  EXPECT_EQ(scene_refusal(scene),
            "/engine/schedule/lists/1/least_level: expected at most greatest_level 1, got 2");
  scene["engine"]["schedule"]["lists"][1] = json::object();
  scene["engine"]["level"] = 1;
  EXPECT_EQ(scene_refusal(scene),
            "/engine/level: expected none beside a schedule, whose lists have levels, got 1");
}

TEST(Scene, ARegionAndItsSchedulerComeTogether) {
  json without = crowd_scene();
  without["engine"].erase("region");
  EXPECT_EQ(scene_refusal(without),
            "/engine: expected the key \"region\" for the scheduler region, which is missing");
  json alone = crowd_scene();
  alone["engine"].erase("schedule");
  EXPECT_EQ(scene_refusal(alone),
            "/engine/region: expected the scheduler region with it, got no schedule");
  EXPECT_EQ(scene_refusal(changed(crowd_scene(), "/engine/region/renewal_ms", 251)),
            "/engine/region/renewal_ms: expected a whole number of steps of 1/240 s, got 251");
  json three = crowd_scene();
  three["engine"]["schedule"]["lists"].push_back(json::object());
  EXPECT_EQ(scene_refusal(three),
            "/engine/schedule/lists: expected two lists, inside and outside the region, got 3");
}

/// The free scene with its box replaced.
json scene_with(const std::string& shape) {
  return changed(free_scene(), "/bodies/1/shape", json::parse(shape));
}

TEST(Scene, EveryShapeCanBeNamedWithoutAFile) {
  std::vector<std::string> kinds;
  for (const char* shape :
       {R"({"kind": "sphere", "radius_deg": 1})", R"({"kind": "disc", "radius_deg": 1})",
        R"({"kind": "box", "width_deg": 2, "height_deg": 1, "depth_deg": 3})",
        R"({"kind": "plate", "width_deg": 2, "height_deg": 1, "thickness_deg": 0.1})",
        R"({"kind": "l-block", "arm_deg": 2, "thickness_deg": 0.7})",
        R"({"kind": "torus", "radius_deg": 1, "tube_deg": 0.3, "resolution": 12})",
        R"({"kind": "knot", "radius_deg": 1, "tube_deg": 0.2, "resolution": 4})",
        R"({"kind": "creature", "length_deg": 3})",
        R"({"kind": "line-swept", "length_deg": 2, "radius_deg": 0.3, "deeper": true})",
        R"({"kind": "rectangle-swept", "width_deg": 1, "height_deg": 2, "radius_deg": 0.3,
            "resolution": 6, "coarsest": "sphere"})",
        R"({"kind": "prism", "outline_deg": [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]],
            "thickness_deg": 1})"}) {
    EXPECT_EQ(scene_refusal(scene_with(shape)), "accepted") << shape;
    EXPECT_GT(built(scene_with(shape)).world.models()[1].inverse_mass, 0.0) << shape;
    kinds.push_back(json::parse(shape)["kind"]);
  }
  kinds.emplace_back("mesh");  // the only one with a file
  EXPECT_EQ(kinds, scene_schema()["definitions"]["shape"]["properties"]["kind"]["enum"]
                       .get<std::vector<std::string>>());
}

TEST(Scene, APlaneHasPixelsOfItsOwn) {
  const json scene = json::parse(shipped("stimuli/two-balls.json"));
  EXPECT_EQ(scene_refusal(scene), "accepted");
  const StagedScene staged = built(scene);
  const double m_per_deg = metres_per_degree(screen_for_checks().viewing_distance_m);
  const Vector3& at = staged.world.states()[0].pose.position;
  EXPECT_NEAR(at.x(), m_per_deg * (830 - 400) / 40.0, 1e-12);
  EXPECT_NEAR(at.y(), m_per_deg * (550 - 300) / 40.0, 1e-12);
  EXPECT_NEAR(staged.looks[0].radius_m, m_per_deg * 30 / 40.0, 1e-12);
  json without = scene;
  without.erase("plane");
  EXPECT_EQ(scene_refusal(without),
            "/bodies/0/shape: expected no measures in pixels without a plane that has pixels");
  json both = scene;
  both["bodies"][0]["position_deg"] = {0, 0, 0};
  EXPECT_EQ(scene_refusal(both),
            "/bodies/0/position_px: expected none beside position_deg, got [830,550]");
  json mixed = scene;
  mixed["bodies"][2]["shape"] =
      json::parse(R"({"kind": "box", "width_px": 800, "height_deg": 1, "depth_px": 2})");
  EXPECT_EQ(scene_refusal(mixed),
            "/bodies/2/shape: expected all measures in degrees, or all in pixels, got both");
}

TEST(Scene, AGoalNeedsItsBodies) {
  const json scene = json::parse(shipped("stimuli/two-balls.json"));
  EXPECT_EQ(scene_refusal(changed(scene, "/goal/body", "C")),
            "/goal/body: expected the name of a body, got \"C\"");
  EXPECT_EQ(scene_refusal(changed(scene, "/goal/body", "top")),
            "/goal/body: expected a body that moves, got \"top\"");
  EXPECT_EQ(scene_refusal(changed(scene, "/goal/missed_at", {"top", "B"})),
            "/goal/missed_at/1: expected the name of another body, got \"B\"");
}

TEST(Scene, APrismHasAnOutlineThatNeverTouchesItself) {
  const auto refused = [](const char* outline) {
    return scene_refusal(scene_with(std::string(R"({"kind": "prism", "thickness_deg": 1,
                                                    "outline_deg": )") +
                                    outline + "}"));
  };
  EXPECT_EQ(refused("[[0, 0], [0, 2], [2, 0]]"), "accepted");  // either way round
  EXPECT_EQ(refused("[[0, 0], [2, 2], [2, 0], [0, 2]]"),
            "/bodies/1/shape/outline_deg: expected sides that do not touch, but those from corner "
            "1 and from corner 3 do");
  EXPECT_EQ(refused("[[0, 0], [1, 0], [2, 0], [0, 2]]"),
            "/bodies/1/shape/outline_deg: expected corners that turn, but corner 2 lies on a line "
            "with its neighbours");
}

TEST(Scene, MeasuresThatMakeNoSolidAreRefused) {
  const auto refused = [](const std::string& shape) { return scene_refusal(scene_with(shape)); };
  const std::string place = "/bodies/1/shape";
  EXPECT_EQ(refused(R"({"kind": "torus", "radius_deg": 1, "tube_deg": 1})"),
            place + "/tube_deg: expected less than radius_deg, got 1");
  EXPECT_EQ(refused(R"({"kind": "knot", "radius_deg": 1, "tube_deg": 0.26})"),
            place +
                "/tube_deg: expected at most a quarter of radius_deg, or the knot would touch "
                "itself, got 0.26");
  EXPECT_EQ(refused(R"({"kind": "plate", "width_deg": 2, "height_deg": 1, "thickness_deg": 1.5})"),
            place + "/thickness_deg: expected less than height_deg, got 1.5");
  EXPECT_EQ(refused(R"({"kind": "l-block", "arm_deg": 2, "thickness_deg": 2})"),
            place + "/thickness_deg: expected less than arm_deg, got 2");
}

TEST(Scene, AShapeHasTheMeasuresOfItsKindAlone) {
  const auto refused = [](const std::string& shape) { return scene_refusal(scene_with(shape)); };
  const std::string place = "/bodies/1/shape";
  EXPECT_EQ(refused(R"({"kind": "creature", "resolution": 4})"),
            place + ": expected the key \"length_deg\" for kind creature, which is missing");
  EXPECT_EQ(refused(R"({"kind": "knot", "radius_deg": 1, "tube_deg": 0.2, "arm_deg": 1})"),
            place + ": expected the measures of kind knot alone, radius_deg, tube_deg, got 3");
  EXPECT_EQ(refused(R"({"kind": "sphere", "radius_deg": 1, "resolution": 5})"),
            place + "/resolution: expected none for kind sphere, got 5");
  EXPECT_EQ(refused(R"({"kind": "box", "width_deg": 2, "height_deg": 1, "depth_deg": 3,
                        "deeper": true})"),
            place + "/deeper: expected none for kind box, got true");
  EXPECT_EQ(refused(R"({"kind": "creature", "length_deg": 3, "resolution": 3})"),
            place + "/resolution: expected a whole number ≥ 4 and ≤ 12, got 3");
}

TEST(Scene, BodiesThatOverlapAtTheStartAreRefusedByName) {
  EXPECT_EQ(scene_refusal(free_scene()), "accepted");
  EXPECT_EQ(scene_refusal(changed(free_scene(), "/bodies/1/position_deg", {-4.0, 0.0, 0.0})),
            "/bodies/0/position_deg: expected a place apart from all else at the start, but "
            "\"ball\" overlaps \"box\"");
  EXPECT_EQ(scene_refusal(changed(free_scene(), "/bodies/0/position_deg", {-9.5, 0.0, 0.0})),
            "/bodies/0/position_deg: expected a place apart from all else at the start, but "
            "\"ball\" overlaps the enclosure");
}

TEST(Scene, BodiesApartAtTheirFinestLevelMayNotOverlapAtTheirCoarsest) {
  // Bounding spheres of 1° and 1.87° overlap where the surfaces are apart.
  json scene = changed(free_scene(), "/bodies/1/position_deg", {-2.6, 0.0, 0.0});
  EXPECT_EQ(scene_refusal(scene), "accepted");
  scene["engine"]["level"] = 0;
  EXPECT_NE(scene_refusal(scene), "accepted");
}

TEST(Scene, ACrowdWithoutRoomIsRefused) {
  EXPECT_EQ(scene_refusal(changed(crowd_scene(), "/enclosure/edge_deg", 4)),
            "/crowd/count: expected as many bodies as the enclosure has room for, got 5");
}

TEST(Scene, ABodyMayNotHaveAWallsName) {
  EXPECT_EQ(scene_refusal(changed(free_scene(), "/bodies/0/name", "wall +x")),
            "/bodies/0/name: expected a name that is no wall's, got \"wall +x\"");
}

TEST(Scene, WhatMeetsHasNoPlaceAndWhatDoesNotHasOne) {
  json scene = free_scene();
  scene["bodies"][2].erase("position_deg");
  EXPECT_EQ(scene_refusal(scene),
            "/bodies/2: expected the key \"position_deg\" where nothing meets, which is missing");
  json timeless = free_scene();
  timeless.erase("duration_s");
  EXPECT_EQ(scene_refusal(timeless),
            "/: expected the key \"duration_s\" where nothing meets, which is missing");
  json empty = free_scene();
  empty.erase("bodies");
  EXPECT_EQ(
      scene_refusal(empty),
      "/: expected one of the keys \"bodies\", \"figures\", \"crowd\" and \"figure_crowd\", all "
      "are missing");
  json meeting = json::parse(shipped(kSceneName));
  meeting["bodies"][0]["position_deg"] = {0, 0, 0};
  EXPECT_EQ(scene_refusal(meeting), "/bodies/0/position_deg: expected none where bodies meet");
}

TEST(Scene, ABudgetIsInTestsOrInMilliseconds) {
  json scene = free_scene();
  EXPECT_EQ(built(scene).budget.tests_per_step, kUnlimitedTests);
  scene["engine"]["budget"] = {{"tests_per_step", 40}};
  EXPECT_EQ(built(scene).budget.tests_per_step, 40);
  scene["engine"]["budget"] = {{"ms_per_step", 0.25}};
  EXPECT_EQ(built(scene).budget.ns_per_step, 250'000);
  EXPECT_EQ(scene_refusal(scene), "accepted");
  scene["engine"]["budget"]["tests_per_step"] = 40;
  EXPECT_NE(scene_refusal(scene), "accepted");
}

TEST(SceneFile, ImpulsesAreFoundInTurnUnlessTogetherIsAskedFor) {
  EXPECT_EQ(built(free_scene()).world.settings().response, ResponseMethod::kInTurn);
  const json together = changed(free_scene(), "/engine/response", "together");
  EXPECT_EQ(scene_refusal(together), "accepted");
  EXPECT_EQ(built(together).world.settings().response, ResponseMethod::kTogether);
  const std::string refused = scene_refusal(changed(free_scene(), "/engine/response", "at once"));
  EXPECT_NE(refused.find("/engine/response"), std::string::npos) << refused;
  EXPECT_NE(refused.find("at once"), std::string::npos) << refused;
}

}  // namespace impetus::scene_test
