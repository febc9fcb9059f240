// What of figures is refused, each in one sentence that names the place.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "experiments/files/scene_files.hpp"
#include "tests/experiments/figure_scenes.hpp"

namespace impetus::figure_refusals_test {

/// The sentence for the doll's scene with one value changed.
std::string refused(const std::string& pointer, json value) {
  return scene_refusal(changed(doll_scene(), pointer, std::move(value)));
}

/// The same for a value of the doll itself; the place is named from its content on.
std::string doll_refused(const std::string& pointer, json value) {
  const std::string sentence = refused(kDollPlace + pointer, std::move(value));
  const std::string place = kDollPlace;
  return sentence.starts_with(place) ? sentence.substr(place.size()) : sentence;
}

TEST(FigureRefusals, TheDollItselfIsAccepted) {
  EXPECT_EQ(scene_refusal(doll_scene()), "accepted");
}

TEST(FigureRefusals, UnknownJointsAndAnglesOutOfLimitsAreNamed) {
  EXPECT_EQ(refused("/figures/0/angles_deg", {{"knee", 3}}),
            "/figures/0/angles_deg/knee: expected the name of a joint of the figure, got \"knee\"");
  EXPECT_EQ(refused("/figures/0/angles_deg", {{"shoulder", 171}}),
            "/figures/0/angles_deg/shoulder: expected an angle within the limits of the joint "
            "\"shoulder\", -10.0 to 170.0 degrees, got 171.0");
  EXPECT_EQ(refused("/figures/0/angles_deg", {{"elbow", 179}}), "accepted") << "it has no limits";
}

TEST(FigureRefusals, AMotionIsOneOfTheFiguresAndLeavesNothingElseToSay) {
  EXPECT_EQ(refused("/figures/0/motion", "dance"),
            "/figures/0/motion: expected a motion of the figure, which has \"flap\", \"recorded\", "
            "got \"dance\"");
  json scene = changed(doll_scene(), "/figures/0/motion", "flap");
  EXPECT_EQ(scene_refusal(changed(scene, "/figures/0/velocity_deg_s", {1, 0, 0})),
            "/figures/0/velocity_deg_s: expected none beside motion; path_deg_s says where the "
            "figure goes");
  EXPECT_EQ(scene_refusal(changed(scene, "/figures/0/angles_deg", {{"shoulder", 0}})),
            "/figures/0/angles_deg/shoulder: expected none for a joint that the motion \"flap\" "
            "moves");
  EXPECT_EQ(refused("/figures/0/path_deg_s", {1, 0, 0}),
            "/figures/0/path_deg_s: expected none without motion");
}

TEST(FigureRefusals, PartsThatOverlapAtTheStartAreNamedUnlessAHingeJoinsThem) {
  // The forearm's ball reaches into the trunk when the arm hangs beside it and folds inwards.
  json scene = doll_scene();
  scene["figure_files"]["doll.json"]["parts"][2]["hinge"]["axis"] = {0, 0, 1};
  scene["figures"][0]["angles_deg"] = {{"shoulder", 0}, {"elbow", -70}};
  scene["figure_files"]["doll.json"]["parts"][2]["hinge"]["on_part"] = {0, 0.12, 0};
  EXPECT_EQ(scene_refusal(scene),
            "/figures/0/angles_deg: expected parts apart from each other at the start, but "
            "\"anna/trunk\" overlaps \"anna/forearm\"");
  scene["figures"][0]["self_collision"] = {{"others", false}};
  EXPECT_EQ(scene_refusal(scene), "accepted");
}

TEST(FigureRefusals, APartFoldedOntoItsNeighbourAtTheStartIsNamed) {
  // Cores both down: the opening is the shoulder's angle, at rest 30 degrees; folded below -10.
  json scene = doll_scene();
  scene["figure_files"]["doll.json"]["parts"][1]["hinge"]["fold_deg"] = 20;
  scene["figures"][0]["angles_deg"] = {{"shoulder", 5}};
  EXPECT_EQ(scene_refusal(scene),
            "/figures/0/angles_deg: expected no part folded onto its neighbour at the start, but "
            "\"anna/arm\" is");
  scene["figures"][0]["self_collision"] = {{"neighbours", false}};
  EXPECT_EQ(scene_refusal(scene), "accepted");
}

TEST(FigureRefusals, FiguresAndBodiesStartApart) {
  json scene = doll_scene();
  scene["bodies"] = json::array({free_scene()["bodies"][0]});
  scene["bodies"][0]["position_deg"] = {1, 2, 3};
  EXPECT_EQ(scene_refusal(scene),
            "/bodies/0/position_deg: expected a place apart from all else at the start, but "
            "\"ball\" overlaps \"anna/trunk\"");
  json two = doll_scene();
  two["figures"].push_back(two["figures"][0]);
  two["figures"][1]["name"] = "ben";
  two["figures"][1]["position_deg"] = {1, 9.5, 3};
  EXPECT_EQ(scene_refusal(two), "accepted");
  two["figures"][1]["position_deg"] = {1, 7.5, 3};
  EXPECT_EQ(scene_refusal(two),
            "/figures/0/position_deg: expected a place apart from all else at the start, but "
            "\"anna/trunk\" overlaps \"ben/trunk\"");
}

TEST(FigureRefusals, NamesAreTheirOwn) {
  json two = doll_scene();
  two["figures"].push_back(two["figures"][0]);
  EXPECT_TRUE(scene_refusal(two).starts_with(
      "/figures/1/name: expected a name that gives its parts names of their own"))
      << scene_refusal(two);
  EXPECT_EQ(refused("/figures/0/name", "wall 1"),
            "/figures/0/name: expected a name that is no wall's, got \"wall 1\"");
  EXPECT_EQ(doll_refused("/parts/1/name", "trunk"),
            "/parts/1/name: expected a name of its own, got \"trunk\" again");
  EXPECT_EQ(doll_refused("/parts/2/hinge/name", "shoulder"),
            "/parts/2/hinge/name: expected a name of its own, got \"shoulder\" again");
}

TEST(FigureRefusals, EachPartButTheRootHangsFromAnEarlierOne) {
  EXPECT_EQ(doll_refused("/parts/1/hinge/parent", "forearm"),
            "/parts/1/hinge/parent: expected the name of an earlier part, got \"forearm\"");
  json scene = doll_scene();
  erase(scene, std::string(kDollPlace) + "/parts/1/hinge");
  EXPECT_EQ(scene_refusal(scene), std::string(kDollPlace) +
                                      "/parts/1: expected the key \"hinge\" for a part that is not "
                                      "the root, which is missing");
  EXPECT_EQ(doll_refused("/parts/0/hinge", doll()["parts"][1]["hinge"]),
            "/parts/0/hinge: expected none for the root");
}

TEST(FigureRefusals, HingesThatCannotBeAreRefused) {
  EXPECT_EQ(doll_refused("/parts/1/hinge/axis", {0, 0, 0}),
            "/parts/1/hinge/axis: expected a direction, got [0,0,0]");
  EXPECT_EQ(
      doll_refused("/parts/1/hinge/on_part", {0, 0, 0}),
      "/parts/1/hinge: expected the key \"core_of_part\" where on_part is the centre, which is "
      "missing");
  EXPECT_EQ(doll_refused("/parts/1/hinge/most_deg", -20),
            "/parts/1/hinge: expected limits that rise within -180 to 180 degrees, got -10.000000 "
            "and -20.000000");
  EXPECT_EQ(doll_refused("/parts/2/hinge/most_deg", 20),
            "/parts/2/hinge: expected least_deg and most_deg, or neither, got one");
}

TEST(FigureRefusals, ShapesAreToldInTheFiguresOwnMeasures) {
  json scene = doll_scene();
  erase(scene, std::string(kDollPlace) + "/parts/1/shape/radius_share");
  EXPECT_EQ(scene_refusal(scene), std::string(kDollPlace) +
                                      "/parts/1/shape: expected the key \"radius_share\" for kind "
                                      "line-swept, which is missing");
  EXPECT_EQ(doll_refused("/parts/1/tree", {{"kind", "octree"}, {"branching", 4}}),
            "/parts/1/tree: expected a branching of 8 for an octree, got 4");
}

TEST(FigureRefusals, MotionsKeepToJointsAndLimits) {
  const json wave = {{"middle_deg", 10}, {"amplitude_deg", 30}};
  EXPECT_EQ(doll_refused("/motions/flap/waves/knee", wave),
            "/motions/flap/waves/knee: expected the name of a joint of the figure, got \"knee\"");
  EXPECT_EQ(doll_refused("/motions/flap/waves/shoulder", wave),
            "/motions/flap/waves/shoulder: expected an angle within the limits of the joint "
            "\"shoulder\", -10.0 to 170.0 degrees, got -20.0");
  EXPECT_EQ(doll_refused("/motions/recorded/keys/1/angles_deg/shoulder", 175),
            "/motions/recorded/keys/1/angles_deg/shoulder: expected an angle within the limits of "
            "the joint \"shoulder\", -10.0 to 170.0 degrees, got 175.0");
  EXPECT_EQ(doll_refused("/motions/recorded/keys/2/angles_deg/shoulder", 20),
            "/motions/recorded: expected the last key of a motion that repeats to equal its first");
  EXPECT_EQ(doll_refused("/motions/recorded/keys/1/time_s", 3),
            "/motions/recorded: expected keys at rising times, got 2.000000 s after 3.000000 s");
  EXPECT_EQ(doll_refused("/motions/recorded/waves", {{"elbow", wave}}),
            "/motions/recorded: expected waves or keys, got both");
}

TEST(FigureRefusals, AnglesThatSwingBeyondALimitBetweenKeysAreRefused) {
  json scene = doll_scene();
  json& keys = scene["figure_files"]["doll.json"]["motions"]["recorded"]["keys"];
  keys = json::parse(R"([{"time_s": 0, "angles_deg": {"shoulder": 60}},
                         {"time_s": 1, "angles_deg": {"shoulder": 168}},
                         {"time_s": 2, "angles_deg": {"shoulder": 168}},
                         {"time_s": 3, "angles_deg": {"shoulder": 60}}])");
  const std::string sentence = scene_refusal(scene);
  EXPECT_TRUE(sentence.starts_with(
      "/figure_files/doll.json/motions/recorded/keys/1: from here to the next key the joint "
      "\"shoulder\" swings too far: expected an angle within the limits"))
      << sentence;
}

TEST(FigureRefusals, FilesAreFiguresWithinTheFolder) {
  json scene = doll_scene();
  scene.erase("figure_files");
  TemporaryFolder folder;
  const auto with = [&](const char* file) {
    scene["figures"][0]["figure"] = file;
    std::string sentence = refusal([&] { load_scene(folder.write("scene.json", scene.dump())); });
    const std::string path = folder.path().string();
    for (auto at = sentence.find(path); at != std::string::npos; at = sentence.find(path)) {
      sentence.replace(at, path.size(), "FOLDER");
    }
    return sentence;
  };
  EXPECT_EQ(with("none.json"),
            "FOLDER/scene.json:/figures/0/figure: expected a figure file, but FOLDER/none.json: "
            "there is no such file");
  EXPECT_EQ(with("/etc/passwd"),
            "FOLDER/scene.json:/figures/0/figure: expected a path within the scene's folder, got "
            "\"/etc/passwd\"");
  EXPECT_EQ(with("../doll.json"),
            "FOLDER/scene.json:/figures/0/figure: expected a path within the scene's folder, got "
            "\"../doll.json\"");
  folder.write("bad.json", R"({"schema_version": 1, "title": "none", "parts": []})");
  EXPECT_EQ(with("bad.json"), "FOLDER/bad.json:/parts: expected a list of 1 to 64 values, got []");
}

TEST(FigureRefusals, ContentThatBreaksTheFiguresSchemaIsRefusedInAStoredScene) {
  EXPECT_EQ(doll_refused("/parts/0/colour", -1),
            "/parts/0/colour: expected a whole number ≥ 0 and ≤ 1000, got -1");
  json scene = doll_scene();
  scene["figure_files"] = {{"other.json", doll()}};
  TemporaryFolder folder;
  EXPECT_TRUE(scene_refusal(scene).find("/figures/0/figure: expected a figure") !=
              std::string::npos)
      << scene_refusal(scene);
}

TEST(FigureRefusals, NothingIsImposedOnFiguresAndNoneMeet) {
  EXPECT_EQ(refused("/imposed", {{"contact_hold_ms", 0}}),
            "/imposed/contact_hold_ms: expected none with figures");
  EXPECT_EQ(refused("/engine/response", "together"),
            "/engine/response: expected \"in-turn\" where there are figures, got \"together\"");
  EXPECT_EQ(refused("/imposed", {{"no_spin", true}}),
            "/imposed/no_spin: expected none with figures");
  json meeting = json::parse(shipped("stimuli/two-l-blocks.json"));
  meeting["imposed"].erase("no_spin");
  meeting["figures"] = doll_scene()["figures"];
  meeting["figure_files"] = doll_scene()["figure_files"];
  EXPECT_NE(scene_refusal(meeting).find("expected none"), std::string::npos)
      << scene_refusal(meeting);
  EXPECT_EQ(scene_refusal(changed(doll_scene(), "/meeting",
                                  {{"speed_deg_s", 1}, {"lead_s", 1}, {"follow_s", 1}})),
            "/meeting: expected none without bodies");
}

TEST(FigureRefusals, CrowdsOfFiguresStandAloneAndNeedRoom) {
  EXPECT_EQ(scene_refusal(humanoid_crowd(3, 20.0)), "accepted");
  EXPECT_EQ(scene_refusal(humanoid_crowd(20, 6.0)),
            "/figure_crowd/count: expected as many figures as the enclosure has room for, got 20");
  json round = humanoid_crowd(1, 20.0);  // whose parts, as spheres, overlap in any posture
  round["figure_crowd"]["coarsest"] = "sphere";
  EXPECT_EQ(scene_refusal(round).find("/figure_crowd/figure: expected parts that can be apart"), 0U)
      << scene_refusal(round);
  round["figure_crowd"]["self_collision"] = {{"others", false}};
  EXPECT_EQ(scene_refusal(round), "accepted");
  EXPECT_EQ(scene_refusal(humanoid_crowd(70, 60.0)),
            "/figure_crowd/count: expected at most 1000 bodies and parts together, got 1120");
  json both = humanoid_crowd(3, 20.0);
  both["bodies"] = json::array({free_scene()["bodies"][0]});
  EXPECT_EQ(scene_refusal(both), "/bodies: expected none beside a crowd");
  json walls = humanoid_crowd(3, 20.0);
  walls.erase("enclosure");
  EXPECT_EQ(scene_refusal(walls),
            "/: expected the key \"enclosure\" for a crowd, which is missing");
}

}  // namespace impetus::figure_refusals_test
