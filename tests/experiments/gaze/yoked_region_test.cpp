// Regions that follow another participant's recorded gaze, from the protocol to the replay.
// SPDX-License-Identifier: MIT
#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include <fstream>

#include "experiments/gaze/region_source.hpp"
#include "tests/experiments/calibration_lab.hpp"
#include "tests/experiments/program.hpp"

namespace impetus::yoked_region_test {

// ---------------------------------------------------------------- the path

TEST(GazePath, ItIsTheSameInDegreesFromAnyDistance) {
  const GazePath path{0.5, {Fixation({0.01, -0.02}), std::nullopt}};
  const GazePath near = path.seen_from(0.25);
  EXPECT_EQ(near.viewing_distance_m, 0.25);
  EXPECT_EQ(near.fixations[0], Fixation({0.005, -0.01}));
  EXPECT_EQ(near.fixations[1], std::nullopt);
  EXPECT_EQ(path.seen_from(0.5).fixations, path.fixations);
}

TEST(GazePath, TheRegionIsWhereTheGazeWasStepByStep) {
  const Protocol study = short_gaze_study();
  const ProtocolScenes scenes(study, 0.0);
  StagedScene scene = scenes.stage(
      study.design.practice.empty() ? cells(study.design).front() : study.design.practice.front(),
      assumed_screen());
  scene.region.kind = RegionKind::kRecorded;
  EXPECT_EQ(RegionSource(scene, 1).at(1, ScreenPoint{}), std::nullopt);
  scene.recorded_gaze = std::make_shared<const GazePath>(
      GazePath{0.57, {std::nullopt, Fixation({0.1, 0.2}), std::nullopt, Fixation({0.3, 0.4})}});
  RegionSource regions(scene, 1);
  const ScreenPoint own{-0.1, -0.1};
  EXPECT_EQ(regions.at(1, own)->centre, (ScreenPoint{0.1, 0.2}));
  EXPECT_EQ(regions.at(1, own)->radius_deg, 5.0);
  EXPECT_EQ(regions.at(2, own), std::nullopt);
  EXPECT_EQ(regions.at(3, own)->centre, (ScreenPoint{0.3, 0.4}));
  EXPECT_EQ(regions.at(9, own)->centre, (ScreenPoint{0.3, 0.4}));
}

// ---------------------------------------------------------------- the protocol

std::string yoke_refusal(const std::function<void(json& protocol, json& scene)>& change) {
  return refusal([&] {
    json protocol = json::parse(shipped("protocols/gaze-contingent-yoked.json"));
    json scene = json::parse(shipped("stimuli/l-blocks-in-a-cube.json"));
    change(protocol, scene);
    make_protocol(parse_json("yoked.json", protocol.dump()), parse_json("cube.json", scene.dump()));
  });
}

TEST(YokedProtocol, RecordedRegionsAndWhoseTheyAreComeTogether) {
  EXPECT_EQ(yoke_refusal([](json&, json&) {}), "accepted");
  EXPECT_EQ(
      yoke_refusal([](json& protocol, json&) {
        protocol["two_interval"] = {{"question", "Which?"},
                                    {"standard", {{"scheduling", "tracked"}}}};
      }),
      "yoked.json:/two_interval: expected trials of one stimulus where /gaze/yoked_to follows "
      "a gaze, got trials of two");
  EXPECT_EQ(yoke_refusal([](json& protocol, json&) { protocol["gaze"].erase("yoked_to"); }),
            "yoked.json:/gaze: expected the key \"yoked_to\", because regions follow a recorded "
            "gaze under \"scheduling\": \"recorded\", but it is missing");
  EXPECT_EQ(yoke_refusal([](json& protocol, json&) {
              protocol["design"]["factors"][0]["levels"] = {"tracked", "random"};
            }),
            "yoked.json:/gaze/yoked_to: expected a factor over /engine/region/kind with the level "
            "\"recorded\", but there is none");
  EXPECT_EQ(yoke_refusal([](json& protocol, json&) {
              protocol["gaze"]["yoked_to"].erase("protocol");
              protocol["design"]["factors"][0]["levels"] = {"recorded", "random"};
              protocol["design"].erase("practice");
            }),
            "yoked.json:/design/factors/0/levels: expected the level \"tracked\", whose gaze "
            "\"recorded\" follows, or another protocol in /gaze/yoked_to");
  EXPECT_EQ(
      yoke_refusal([](json&, json& scene) { scene["engine"]["region"]["kind"] = "recorded"; }),
      "cube.json:/engine/region/kind: expected \"recorded\" only as a level of a protocol's "
      "factor, where /gaze/yoked_to says whose");
  EXPECT_EQ(yoke_refusal([](json& protocol, json&) {
              protocol["session"]["demonstrations"][0]["set"]["/engine/region/kind"] = "recorded";
            }),
            "yoked.json:/session/demonstrations: expected regions that follow nobody, but "
            "good_collisions follows a recorded gaze");
}

// ---------------------------------------------------------------- the program

/// Both studies, tiny: one repetition, five bodies, half a second, no practice, no demonstrations.
struct YokedStudy {
  explicit YokedStudy(const std::function<void(json& protocol)>& change = {}) {
    json scene = json::parse(shipped("stimuli/l-blocks-in-a-cube.json"));
    scene["duration_s"] = 0.5;
    write("scene.json", scene);
    write("first.json", shortened("gaze-contingent"));
    json yoked = shortened("gaze-contingent-yoked");
    if (change) {
      change(yoked);
    }
    write("yoked.json", yoked);
  }

  void write(const std::string& name, const json& document) const {
    std::ofstream(folder / name) << document.dump();
  }
  static json shortened(const std::string& name) {
    json protocol = json::parse(shipped("protocols/" + name + ".json"));
    protocol["scene"] = "scene.json";
    protocol["design"]["repetitions"] = 1;
    protocol["design"]["factors"][1]["levels"] = {5};
    for (const char* key : {"practice", "practice_until"}) {
      protocol["design"].erase(key);
    }
    protocol["session"].erase("demonstrations");
    protocol["gaze"]["calibration"]["point_ms"] = 1000;
    return protocol;
  }
  [[nodiscard]] ProgramResult run(const std::string& protocol,
                                  const std::vector<std::string>& whom) const {
    std::vector<std::string> words{
        "run",        protocol,
        "--db",       "a.sqlite",
        "--observer", source_file("experiments/observers/gaze-contingent.json").string()};
    words.insert(words.end(), whom.begin(), whom.end());
    return run_program(folder, words);
  }
  [[nodiscard]] std::string asked(const std::string& sql) const {
    SQLite::Database database((folder / "a.sqlite").string(), SQLite::OPEN_READONLY);
    return database.execAndGet(sql).getString();
  }
  /// What the program says of the yoked study for one participant.
  [[nodiscard]] std::string refused() const {
    const ProgramResult result = run("yoked.json", {"--participant", "S09"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(asked("SELECT count(*) FROM participant WHERE pseudonym = 'S09'"), "0");
    return result.errors;
  }

  TemporaryFolder folder;
};

TEST(YokedStudy, EachFollowsAnotherStepByStepAndReplays) {
  const YokedStudy study;
  ASSERT_EQ(study.run("first.json", {"--participants", "2"}).status, 0);
  const ProgramResult yoked = study.run("yoked.json", {"--participants", "2"});
  ASSERT_EQ(yoked.status, 0) << yoked.errors;
  // Whom each follows: never themselves, and each is followed once.
  EXPECT_EQ(study.asked("SELECT group_concat(pair, '; ') FROM (SELECT one.pseudonym || ' follows ' "
                        "|| other.pseudonym || ', ' || followed.condition AS pair FROM trial "
                        "JOIN trial AS followed ON followed.id = trial.yoked_trial_id "
                        "JOIN enrolment AS e ON e.id = trial.enrolment_id "
                        "JOIN participant AS one ON one.id = e.participant_id "
                        "JOIN enrolment AS f ON f.id = followed.enrolment_id "
                        "JOIN participant AS other ON other.id = f.participant_id "
                        "ORDER BY one.pseudonym)"),
            "S01 follows S02, {\"bodies\":5,\"scheduling\":\"tracked\"}; "
            "S02 follows S01, {\"bodies\":5,\"scheduling\":\"tracked\"}");
  // Steps of yoked trials, and of those the ones whose region is not where the other looked then.
  const std::string steps =
      "FROM trial JOIN attempt ON attempt.trial_id = trial.id "
      "JOIN step ON step.attempt_id = attempt.id "
      "JOIN attempt AS followed ON followed.trial_id = trial.yoked_trial_id "
      "JOIN step AS source ON source.attempt_id = followed.id AND source.step = step.step "
      "WHERE step.step > 0 ";
  EXPECT_EQ(study.asked("SELECT count(*) " + steps), "240");
  EXPECT_EQ(study.asked("SELECT count(*) " + steps +
                        "AND (step.region_x_m IS NOT source.fixation_x_m "
                        "OR step.region_y_m IS NOT source.fixation_y_m)"),
            "0");
  EXPECT_NE(study.asked("SELECT count(*) " + steps + "AND step.region_x_m <> step.fixation_x_m"),
            "0");
  const ProgramResult replayed = run_program(study.folder, {"replay", "a.sqlite"});
  EXPECT_EQ(replayed.status, 0);
  EXPECT_NE(replayed.output.find(", 0 divergent\n"), std::string::npos) << replayed.output;
}

TEST(YokedStudy, CalibrationsAreInTheFile) {
  const YokedStudy study;
  ASSERT_EQ(study.run("first.json", {"--participant", "S01"}).status, 0);
  EXPECT_EQ(study.asked("SELECT group_concat(kind || ' ' || passed) FROM gaze_calibration"),
            "calibration 1,validation 1");
  EXPECT_EQ(study.asked("SELECT count(*) FROM calibration_point WHERE samples > 100"), "18");
  // The steps used what the view says is corrected, and it is not what was sampled.
  EXPECT_EQ(study.asked("SELECT count(*) FROM step JOIN attempt ON attempt.id = attempt_id "
                        "JOIN gaze_sample ON gaze_sample.trial = trial_id AND "
                        "abs((fixation_taken_ns - onset_ns) / 1e9 - time_s) < 1e-9 "
                        "WHERE abs(fixation_x_m - corrected_x_m) > 1e-12 "
                        "OR abs(fixation_y_m - corrected_y_m) > 1e-12"),
            "0");
  EXPECT_NE(study.asked("SELECT count(*) FROM gaze_sample WHERE abs(x_m - corrected_x_m) > 1e-4"),
            "0");
}

TEST(YokedStudy, WhoeverCannotBeFollowedIsRefusedByName) {
  const YokedStudy nobody;
  ASSERT_EQ(nobody.run("first.json", {"--participant", "S09"}).status, 0);
  const ProgramResult alone = nobody.run("yoked.json", {"--participant", "S09"});
  EXPECT_EQ(alone.errors,
            "impetus: yoked.json:/gaze/yoked_to/participant: expected another simulated "
            "participant who has finished gaze-contingent in a.sqlite, but there is none yet; run "
            "gaze-contingent first\n");
  EXPECT_EQ(nobody.asked("SELECT count(*) FROM enrolment"), "1");

  const YokedStudy unknown(
      [](json& protocol) { protocol["gaze"]["yoked_to"]["participant"] = "P77"; });
  ASSERT_EQ(unknown.run("first.json", {"--participant", "S01"}).status, 0);
  EXPECT_EQ(unknown.refused(),
            "impetus: yoked.json:/gaze/yoked_to/participant: expected a participant of a.sqlite, "
            "got \"P77\"\n");

  const YokedStudy own([](json& protocol) {
    protocol["gaze"]["yoked_to"] = {{"participant", "previous"}};
  });
  ASSERT_EQ(own.run("first.json", {"--participant", "S01"}).status, 0);
  EXPECT_EQ(own.refused(),
            "impetus: yoked.json:/gaze/yoked_to: expected the name of another protocol, run "
            "before, or nobody could be the first, since everybody has recorded regions "
            "(\"scheduling\" is no factor between participants)\n");

  const YokedStudy between([](json& protocol) {
    protocol["gaze"]["yoked_to"] = {{"participant", "least-followed"}};
    json& scheduling = protocol["design"]["factors"][0];
    scheduling["between"] = true;
    scheduling["levels"] = {"tracked", "recorded"};
    protocol["design"]["practice"] = {{{"bodies", 5}}};
  });
  EXPECT_EQ(between.run("yoked.json", {"--participants", "6", "--seed", "1"}).status, 0)
      << "whoever is recorded follows somebody who was tracked";

  const YokedStudy unfinished([](json& protocol) {
    protocol["gaze"]["yoked_to"] = {{"participant", "S01"}, {"protocol", "causality"}};
  });
  ASSERT_EQ(unfinished.run("first.json", {"--participant", "S01"}).status, 0);
  EXPECT_EQ(unfinished.refused(),
            "impetus: yoked.json:/gaze/yoked_to/participant: expected another participant who has "
            "finished causality in a.sqlite, got \"S01\"\n");
}

TEST(YokedStudy, ATrialThatCannotBeFollowedIsRefusedByName) {
  const YokedStudy more([](json& protocol) {
    protocol["design"]["factors"][1]["levels"] = {5, 10};
  });
  ASSERT_EQ(more.run("first.json", {"--participant", "S01"}).status, 0);
  EXPECT_EQ(more.refused(),
            "impetus: yoked.json:/gaze/yoked_to: expected a completed trial of S01 in "
            "gaze-contingent to follow, under {\"bodies\":10,\"scheduling\":\"tracked\"} in "
            "repetition 1, but there is none\n");

  const YokedStudy other([](json& protocol) { protocol["scene"] = "other.json"; });
  json scene = json::parse(text_of(other.folder / "scene.json"));
  scene["crowd"]["speed_deg_s"] = 6;
  other.write("other.json", scene);
  ASSERT_EQ(other.run("first.json", {"--participant", "S01"}).status, 0);
  const std::string slot = other.asked("SELECT slot FROM trial WHERE condition LIKE '%tracked%'");
  EXPECT_EQ(other.refused(),
            "impetus: yoked.json:/gaze/yoked_to: expected the same scene in what is followed, but "
            "/crowd/speed_deg_s is 5 in S01's trial " +
                slot + " of gaze-contingent, not 6\n");

  const YokedStudy blind;
  ASSERT_EQ(blind.run("first.json", {"--participant", "S01"}).status, 0);
  SQLite::Database((blind.folder / "a.sqlite").string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE step SET fixation_x_m = NULL, fixation_y_m = NULL");
  EXPECT_EQ(blind.refused(),
            "impetus: yoked.json:/gaze/yoked_to: expected a recorded gaze to follow, but S01's "
            "trial " +
                slot + " of gaze-contingent has no valid sample\n");
}

TEST(YokedStudy, AnotherBodyCountIsAnotherScene) {
  const YokedStudy study([](json& protocol) {
    protocol["scene"] = "more.json";
    protocol["design"]["factors"].erase(1);
  });
  json first = YokedStudy::shortened("gaze-contingent");
  first["design"]["factors"].erase(1);
  study.write("first.json", first);
  json scene = json::parse(text_of(study.folder / "scene.json"));
  scene["crowd"]["count"] = 10;
  study.write("more.json", scene);
  ASSERT_EQ(study.run("first.json", {"--participant", "S01"}).status, 0);
  const std::string slot = study.asked("SELECT slot FROM trial WHERE condition LIKE '%tracked%'");
  EXPECT_EQ(study.refused(),
            "impetus: yoked.json:/gaze/yoked_to: expected the same scene in what is followed, but "
            "/crowd/count is 5 in S01's trial " +
                slot + " of gaze-contingent, not 10\n");
}

}  // namespace impetus::yoked_region_test
