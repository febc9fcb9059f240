// `impetus replay --with`, as a shell runs it, on the golden recordings.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/protocol/setting_changes.hpp"
#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::replay_with_test {

/// A folder with a copy of a golden recording, a.sqlite.
struct Copied {
  explicit Copied(const std::string& name) {
    std::filesystem::copy_file(source_folder() + "/tests/recordings/" + name + ".sqlite",
                               folder / "a.sqlite");
  }
  [[nodiscard]] ProgramResult replay_with(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"replay", "a.sqlite"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(folder, words);
  }
  TemporaryFolder folder;
};

json outcome_of(const Copied& study, const std::vector<std::string>& with) {
  std::vector<std::string> words{"--json", "what-if.json"};
  for (const std::string& each : with) {
    words.insert(words.end(), {"--with", each});
  }
  const ProgramResult result = study.replay_with(words);
  EXPECT_EQ(complaints_of(result), "");
  EXPECT_EQ(result.status, 0);
  return json::parse(text_of(study.folder / "what-if.json"), nullptr, false);
}

TEST(ReplayWith, TheRecordedSettingsDiffersInNothing) {
  for (const char* name : {"gaze-contingent", "response", "causality"}) {
    const Copied study(name);
    const json outcome = outcome_of(study, {"restitution=1"});
    EXPECT_EQ(outcome["parted"].get<int>(), 0) << name;
    EXPECT_EQ(outcome["matched"]["only_then"].get<int>(), 0) << name;
    EXPECT_EQ(outcome["matched"]["only_now"].get<int>(), 0) << name;
    EXPECT_GT(outcome["matched"]["both"].get<int>(), 0) << name;
    EXPECT_EQ(outcome["then"].dump(), outcome["now"].dump()) << name;
    EXPECT_FALSE(outcome["differs"].get<bool>()) << name;
  }
}

/// What is said of each collision that the other settings have.
std::vector<json> collisions_now(const json& outcome) {
  std::vector<json> collisions;
  for (const json& stimulus : outcome["stimuli"]) {
    for (const json& collision : stimulus["collisions"]) {
      if (!collision["now"].is_null()) {
        collisions.push_back(collision["now"]);
      }
    }
  }
  return collisions;
}

TEST(ReplayWith, ASmallerBudgetStopsRefinement) {
  const Copied study("gaze-contingent");
  const json outcome =
      outcome_of(study, {"scheduler=distance", "budget=40", "traversal=best-first"});
  EXPECT_TRUE(outcome["differs"].get<bool>());
  const std::vector<json> collisions = collisions_now(outcome);
  EXPECT_TRUE(std::any_of(collisions.begin(), collisions.end(), [](const json& collision) {
    return collision["stopped"].get<std::string>() == "budget";
  }));
}

TEST(ReplayWith, ATreeOfAnotherKindIsTaken) {
  const Copied study("gaze-contingent");
  const std::vector<json> collisions =
      collisions_now(outcome_of(study, {"scheduler=distance", "tree=box"}));
  ASSERT_FALSE(collisions.empty());
  EXPECT_TRUE(std::all_of(collisions.begin(), collisions.end(), [](const json& collision) {
    return collision["level"].get<int>() == 1;  // Two boxes are an L-block.
  }));
}

TEST(ReplayWith, SaysTheSameEachTimeAndLeavesTheStudyAsItIs) {
  const Copied study("gaze-contingent");
  const std::string before = text_of(study.folder / "a.sqlite");
  const std::vector<std::string> words{"--with", "scheduler=eccentricity", "--with", "budget=300"};
  const ProgramResult first = study.replay_with(words);
  EXPECT_EQ(first.status, 0);
  EXPECT_NE(first.output.find("12 stimuli; the states of "), std::string::npos) << first.output;
  EXPECT_EQ(study.replay_with(words).output, first.output);
  EXPECT_EQ(text_of(study.folder / "a.sqlite"), before);
}

TEST(ReplayWith, WritesARowForEachStimulus) {
  const Copied study("gap");
  const ProgramResult result = study.replay_with({"--with", "level=1", "--out", "rows.csv"});
  EXPECT_EQ(complaints_of(result), "");
  const std::vector<std::string> rows = lines_of(text_of(study.folder / "rows.csv"));
  ASSERT_EQ(rows.size(), 34U);  // of names, and 33 trials
  EXPECT_TRUE(rows[0].starts_with("participant,trial,slot,attempt,interval,condition,"));
  const auto commas = [](const std::string& row) {
    return std::count(row.begin(), row.end(), ',');
  };
  EXPECT_EQ(commas(rows[1]), commas(rows[0]) + 2);  // a condition of three factors, quoted
}

TEST(ReplayWith, TwoFilesOfOneNameAreRefused) {
  const Copied study("gap");
  const std::vector<std::string> ask{"replay", "a.sqlite", "--with", "level=1", "--out", "w.csv"};
  for (const std::string& other :
       {std::string("w.csv"), std::string("./w.csv"), (study.folder / "none/../w.csv").string()}) {
    std::vector<std::string> words = ask;
    words.insert(words.end(), {"--json", other});
    std::filesystem::create_directories(study.folder / "none");
    expect_refused(study.folder, words,
                   "--out and --json: expected two files, got " + other + " for both");
  }
  EXPECT_FALSE(std::filesystem::exists(study.folder / "w.csv"));
}

TEST(ReplayWith, RefusesInOneSentence) {
  const Copied study("gaze-contingent");
  study.folder.write("there.csv", "");
  const auto refused = [&](const std::string& with, const std::string& sentence) {
    expect_refused(study.folder, {"replay", "a.sqlite", "--with", with},
                   "--with " + with + ": " + sentence);
  };
  refused("scheduler", "expected KEY=VALUE, such as scheduler=distance");
  refused("colour=red",
          "expected one of the keys branching, budget, contacts, counts, depth, level, passes, "
          "persistence-ms, radius-deg, reduction, region, response, restitution, rotation, "
          "scheduler, traversal, tree, tunnelling, or a JSON Pointer below /engine, got colour");
  refused("/viewer/azimuth_deg=3",
          "expected one of the keys branching, budget, contacts, counts, depth, level, passes, "
          "persistence-ms, radius-deg, reduction, region, response, restitution, rotation, "
          "scheduler, traversal, tree, tunnelling, or a JSON Pointer below /engine, got "
          "/viewer/azimuth_deg");
  expect_refused(study.folder, {"replay", "a.sqlite", "--with", "level=2", "--with", "level=3"},
                 "--with level=3: expected each setting once, got also level=2");
  refused("/engine/step_hz=60", "expected a setting that keeps the recorded steps as they are");
  refused("traversal=sideways",
          "expected one of \"depth-first\", \"breadth-first\", \"best-first\", "
          "\"visible-first\", got \"sideways\"");
  refused("budget=-1", "expected a whole number ≥ 0 and ≤ 1000000000, got -1");
  refused("scheduler=nearest",
          "expected one of \"collision-speed\", \"distance\", \"eccentricity\", \"gap\", "
          "\"gap-bound\", \"perceived\", \"projected-centres\", \"projected-gap\", \"region\", "
          "\"size\", "
          "\"velocity\", \"visible-frequency\", \"weighted\", got \"nearest\"");
  refused("depth=2",
          "at /engine/schedule/lists/0/least_level of the scene: expected at most 2, the deepest "
          "level of the trees, got 4");
  refused("/engine/budget/ms_per_step=1",
          "expected units of work, which are the same each time, got milliseconds");
  refused("region=recorded",
          "expected a region that needs no other participant's gaze, got \"recorded\"");
  expect_refused(study.folder, {"replay", "a.sqlite", "--with", "level=0", "--truth"},
                 "--with: expected neither --view nor --truth beside it, got --truth");
  expect_refused(study.folder, {"replay", "a.sqlite", "--out", "rows.csv"},
                 "--out: expected --with beside it, which is missing");
  expect_refused(study.folder, {"replay", "a.sqlite", "--with", "level=0", "--out", "there.csv"},
                 "there.csv: exists already and is not overwritten");
  expect_refused(study.folder, {"replay", "a.sqlite", "--with", "level=0", "--json", "none/a.json"},
                 "none/a.json: cannot be written (No such file or directory)");
}

// ------------------------------------------------------------- changed scenes

json under(json scene, const std::vector<std::string>& with) {
  std::vector<SettingChange> changes;
  for (const std::string& each : with) {
    changes.push_back(setting_change(each));
  }
  return changed_scene(scene, changes)["engine"];
}

TEST(SettingChanges, AnotherSchedulerHasOneListFromTheCoarsestLevelToTheFinest) {
  const json engine = under(crowd_scene(), {"scheduler=distance"});
  EXPECT_EQ(engine["schedule"].dump(), R"({"lists":[{}],"scheduler":"distance"})");
  EXPECT_FALSE(engine.contains("region"));
}

TEST(SettingChanges, TheSceneSOwnSchedulerChangesNothing) {
  EXPECT_EQ(under(crowd_scene(), {"scheduler=region"}).dump(), crowd_scene()["engine"].dump());
}

TEST(SettingChanges, ListsBySharesOfThePairsOutliveAnotherScheduler) {
  const json scene = json::parse(shipped("stimuli/creatures-in-a-cube.json"));
  const json engine = under(scene, {"scheduler=size"});
  EXPECT_EQ(engine["schedule"]["lists"].dump(), scene["engine"]["schedule"]["lists"].dump());
  EXPECT_EQ(engine["schedule"]["pair_shares"].dump(), "[0.25]");
}

TEST(SettingChanges, ARegionIsFineInsideAndCoarseOutside) {
  const json engine = under(
      free_scene(), {R"(/engine/region={"kind":"tracked","radius_deg":5})", "scheduler=region"});
  EXPECT_EQ(engine["schedule"]["lists"].dump(),
            R"([{"greatest_level":2,"least_level":2},{"greatest_level":0,"least_level":0}])");
}

TEST(SettingChanges, ABudgetTakesThePlaceOfOneByTheClockOrOfAll) {
  json scene = free_scene();
  scene["engine"]["budget"] = json::object({{"counts", "all-phases"}, {"ms_per_step", 2}});
  EXPECT_EQ(under(scene, {"budget=70"})["budget"].dump(),
            R"({"counts":"all-phases","tests_per_step":70})");
  EXPECT_FALSE(under(scene, {"budget=unlimited"}).contains("budget"));
}

TEST(SettingChanges, AnotherKindOfTreeBringsItsOwnBranching) {
  json scene = free_scene();
  scene["engine"]["tree"] = json::object({{"kind", "voxel"}, {"branching", 27}});
  EXPECT_EQ(under(scene, {"tree=octree"})["tree"].dump(), R"({"kind":"octree"})");
  EXPECT_EQ(under(scene, {"tree=voxel"})["tree"].dump(), R"({"branching":27,"kind":"voxel"})");
}

}  // namespace impetus::replay_with_test
