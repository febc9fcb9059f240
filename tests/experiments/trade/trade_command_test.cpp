// `impetus trade` as a researcher meets it: files, sentences, settings to paste back.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "experiments/files/scene_files.hpp"
#include "experiments/protocol/checked_scene.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/tables/text_table.hpp"
#include "experiments/trade/impacts/scene_pairs.hpp"
#include "experiments/trade/scene_demand.hpp"
#include "experiments/trade/trade_choice.hpp"
#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/program.hpp"
#include "tests/experiments/test_scenes.hpp"
#include "tests/places/places.hpp"

namespace impetus::trade_command_test {

std::string stimulus(const std::string& name) {
  return source_folder() + "/stimuli/" + name + ".json";
}

/// A quick run; R is out of reach.
ProgramResult trade(const TemporaryFolder& folder, const std::string& scene,
                    std::vector<std::string> more) {
  std::vector<std::string> words{"trade",     scene,        "--out",        "out",
                                 "--kinds",   "octree,box", "--levels",     "0,1",
                                 "--impacts", "20",         "--reductions", "groups"};
  words.insert(words.end(), more.begin(), more.end());
  return run_program(folder, words, [] { setenv("PATH", "/nowhere", 1); });
}

// ---------------------------------------------------------------- the command

TEST(TradeCommand, WritesTheTableTheChoicesAndASentenceOfAdvice) {
  const TemporaryFolder folder;
  const ProgramResult result = trade(folder, stimulus("two-l-blocks"), {"--budgets-ms", "4,1"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(
      result.output.find("a step refines 1 pair of bodies (95th percentile)\n"
                         "within 1 ms, oriented boxes to level 1 with grouped averages: "
                         "median normal error below 0.1°, 95 % of gaps below 0.1 minutes of "
                         "arc.\n"
                         "written to out: trade.csv, choices.md, choices.csv, choices.json\n"),
      std::string::npos)
      << result.output;
  EXPECT_NE(result.output.find("no figure: Rscript is missing; with R and ggplot2 (apt-get install "
                               "r-cran-ggplot2), Rscript out/trade.R out/trade.csv draws it\n"),
            std::string::npos)
      << result.output;
  EXPECT_TRUE(text_of(folder / "out/trade.csv").starts_with("part,subject,kind,level,"));
  EXPECT_NE(text_of(folder / "out/choices.md").find("| 1 | box | 1 | groups |"), std::string::npos);
  EXPECT_NE(text_of(folder / "out/choices.csv").find("\n4,true,box,1,groups,"), std::string::npos);
}

TEST(TradeCommand, TheSameSeedWritesTheSameTableButForTimes) {
  const TemporaryFolder folder;
  const auto table_of = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"--force"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(trade(folder, stimulus("two-l-blocks"), words).status, 0);
    std::istringstream lines(text_of(folder / "out/trade.csv"));
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
      kept += line.ends_with(",true") ? "" : line + "\n";
    }
    return kept;
  };
  const std::string first = table_of({"--seed", "3"});
  EXPECT_EQ(first, table_of({"--seed", "3"}));
  EXPECT_NE(first, table_of({"--seed", "4"}));
}

TEST(TradeCommand, RefusesInOneSentenceWhatItCannotDo) {
  const TemporaryFolder folder;
  const std::string scene = stimulus("two-l-blocks");
  struct Refusal {
    std::vector<std::string> more;
    std::string sentence;
  };
  for (const Refusal& each : std::vector<Refusal>{
           {{"--kinds", "sphere"},
            "--kinds: expected some of octree, medial, voxel, box, swept, heterogeneous, got "
            "sphere"},
           {{"--reductions", "some"},
            "--reductions: expected some of none, first, average, groups, density, weighted, got "
            "some"},
           {{"--levels", "9"}, "--levels: expected from 0 to 6, got 9"},
           {{"--depth", "7"}, "--depth: expected from 0 to 6, got 7"},
           {{"--impacts", "3"}, "--impacts: expected from 10 to 100000, got 3"},
           {{"--budgets-ms", "0"}, "--budgets-ms: expected milliseconds above 0, got 0"}}) {
    const ProgramResult result = run_program(folder, [&] {
      std::vector<std::string> words{"trade", scene};
      words.insert(words.end(), each.more.begin(), each.more.end());
      return words;
    }());
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.errors, "impetus: " + each.sentence + "\n");
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "trade"));
}

TEST(TradeCommand, DoesNotOverwriteAResultUnlessAsked) {
  const TemporaryFolder folder;
  const std::string scene = stimulus("two-l-blocks");
  std::filesystem::create_directory(folder / "out");
  const auto refused = [&](const std::string& out, const std::string& sentence) {
    EXPECT_EQ(run_program(folder, {"trade", scene, "--out", out}).errors,
              kAssumedScreen + "impetus: " + sentence + "\n");
  };
  for (const std::string file : {"out/trade.csv", "out/trade.R", "out/choices.json"}) {
    folder.write(file, "mine");
    refused("out", file + ": exists already and is not overwritten without --force");
    EXPECT_EQ(text_of(folder / file), "mine");
    std::filesystem::remove(folder / file);
  }
  folder.write("file", "mine");
  refused("file", "--out: expected a folder, but file is a file");
  refused("file/below", "--out: expected a folder to write to, got file/below");
}

// ---------------------------------------------------------------- settings to paste

/// Whether the scene is valid with the option's settings pasted in, and without schedule and
/// budget.
void expect_valid_with(const JsonDocument& scene, const TradeOption& option, int depth) {
  JsonDocument pasted = scene;
  pasted.value["engine"] = engine_with(scene.value, option, depth);
  EXPECT_NO_THROW(require_scene(pasted)) << name_of(option.kind) << option.level;
  JsonDocument run = scene;
  run.value = scene_with(scene.value, option, depth);
  EXPECT_NO_THROW(require_scene(run)) << name_of(option.kind) << option.level;
}

TradeOption option_of(TreeKind kind, int level, std::string_view reduction) {
  TradeOption option;
  option.kind = kind;
  option.level = level;
  option.reduction = reduction;
  return option;
}

TEST(ChosenSettings, OfEveryKindLevelAndReductionMakeAValidScene) {
  const JsonDocument scene = load_scene(stimulus("two-l-blocks"));
  for (const std::string& kind : tree_kind_names()) {
    for (const int level : {0, 1}) {
      expect_valid_with(scene, option_of(tree_kind(kind), level, "groups"), /*depth=*/1);
    }
  }
  for (const std::string_view reduction : reduction_names()) {
    expect_valid_with(scene, option_of(TreeKind::kOctree, 2, reduction), /*depth=*/3);
  }
}

TEST(ChosenSettings, OfACrowdsOwnKindMakeAValidScene) {
  expect_valid_with(load_scene(stimulus("l-blocks-in-a-cube")),
                    option_of(TreeKind::kOctree, 2, "groups"), /*depth=*/4);
}

TEST(ChosenSettings, KeepTheScheduleAndDeepenItsFinestListAlone) {
  const JsonDocument scene = load_scene(stimulus("creatures-in-a-cube"));
  TradeOption option;
  option.kind = TreeKind::kMedial;
  option.level = 2;
  option.reduction = "weighted";
  const json engine = engine_with(scene.value, option, /*depth=*/3);
  EXPECT_EQ(engine["tree_depth"].get<int>(), 3);
  EXPECT_EQ(engine["schedule"]["lists"][0]["greatest_level"].get<int>(), 2);
  EXPECT_EQ(engine["schedule"]["lists"][1]["greatest_level"].get<int>(), 1);
  EXPECT_EQ(engine["contacts"].dump(), R"({"most_per_pair":4,"reduction":"weighted"})");
  EXPECT_EQ(engine["budget"], scene.value["engine"]["budget"]);
}

TEST(ChosenSettings, BuildTheTreesThatWereChosen) {
  const JsonDocument scene = load_scene(stimulus("two-l-blocks"));
  TradeOption option;
  option.kind = TreeKind::kBox;
  option.level = 1;
  option.reduction = "first";
  JsonDocument pasted = scene;
  pasted.value["engine"] = engine_with(scene.value, option, /*depth=*/3);
  ShapeLibrary shapes{TreeCache()};
  const StagedScene staged = build_scene(pasted.value, assumed_screen(), 0.0, shapes);
  const VolumeTree& tree = *staged.world.models()[0].tree;
  EXPECT_EQ(tree.level_count(), 2);
  EXPECT_EQ(staged.world.settings().schedule.lists.at(0).greatest_level, 1);
  EXPECT_TRUE(std::holds_alternative<Box>(tree.volume(0)));
}

// ---------------------------------------------------------------- choices

TradeOption option_of(double mean_us, double error) {
  TradeOption option;
  option.level = static_cast<int>(mean_us);
  option.reduction = "groups";
  option.mean_us = option.p99_us = mean_us;
  option.normal_deg.value = option.gap_arcmin.value = error;
  return option;
}

TEST(TradeChoices, AreTheBestWhoseRunKeepsToTheBudget) {
  const std::vector<TradeOption> options{option_of(100, 1), option_of(10, 4), option_of(1, 9)};
  // Steps take five times what their ten pairs do.
  const auto run = [](const TradeOption& option) { return 5.0 * option.step_ms(10.0); };
  const auto choices = choices_for({0.01, 0.06, 2.0, 10.0}, options, 10.0, run);
  EXPECT_FALSE(choices[0].keeps);
  EXPECT_EQ(choices[0].option.mean_us, 1.0);
  EXPECT_TRUE(choices[1].keeps);
  EXPECT_EQ(choices[1].option.mean_us, 1.0);
  EXPECT_EQ(choices[2].option.mean_us, 10.0);
  EXPECT_EQ(choices[3].option.mean_us, 100.0);
}

TEST(TradeChoices, AreToldInTheWordsOfTheAdvice) {
  TradeChoice choice;
  choice.budget_ms = 4.0;
  choice.option.kind = TreeKind::kBox;
  choice.option.level = 3;
  choice.option.reduction = "groups";
  choice.option.normal_deg.value = 6.04;
  choice.option.gap_arcmin.value = 9.0;
  EXPECT_EQ(advice(choice),
            "within 4 ms, oriented boxes to level 3 with grouped averages: median normal error 6°, "
            "95 % of gaps below 9 minutes of arc.");
  choice.keeps = false;
  EXPECT_TRUE(advice(choice).starts_with("nothing keeps within 4 ms; the quickest are oriented"));
}

TEST(TradeWords, NumbersHaveTwoDigitsAndNoMoreZerosThanTheyNeed) {
  const std::vector<std::pair<double, std::string>> cases{
      {0.0, "0"},    {1.0, "1"},     {16.0, "16"}, {0.0123, "0.012"}, {6.04, "6"},
      {6.26, "6.3"}, {1234, "1200"}, {9.96, "10"}, {0.5, "0.5"}};
  for (const auto& [value, words] : cases) {
    EXPECT_EQ(two_digits(value), words);
  }
  EXPECT_EQ(two_digits_from(0.1, 0.05), "< 0.1");
}

// ---------------------------------------------------------------- what a scene asks

TEST(SceneDemand, OfTwoThatMeetIsOnePairAtTheirSpeed) {
  ShapeLibrary shapes{TreeCache()};
  const JsonDocument scene = load_scene(stimulus("two-l-blocks"));
  const StagedScene staged = build_scene(scene.value, assumed_screen(), 0.0, shapes);
  const SceneDemand demand = demand_of(staged);
  ASSERT_FALSE(demand.meetings.empty());
  EXPECT_EQ(pairs_per_step(demand), 1.0);
  EXPECT_EQ(demand.touching_most, 1);
  // Each comes at 10° a second.
  const double speed_m_s = 20.0 * metres_of(1.0);
  EXPECT_NEAR(demand.meetings.front().motion.approach_m_s, speed_m_s, 1e-9);
  const TradeBodies bodies =
      trade_bodies(scene.value, metres_of(1.0), {TreeKind::kOctree}, 1, shapes);
  EXPECT_EQ(bodies.alike.size(), 1U) << "both are one L-block";
  const auto pairs = scene_pairs(bodies, demand, staged, 6);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].pair.name(), "l-block x l-block");
}

TEST(SceneDemand, WhereNobodyMeetsAllWhoCouldAreMeasured) {
  ShapeLibrary shapes{TreeCache()};
  const JsonDocument scene = load_scene(stimulus("two-l-blocks"));
  const StagedScene staged = build_scene(scene.value, assumed_screen(), 0.0, shapes);
  const TradeBodies bodies =
      trade_bodies(scene.value, metres_of(1.0), {TreeKind::kOctree}, 1, shapes);
  const auto pairs = scene_pairs(bodies, {}, staged, 6);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_GT(pairs[0].pair.motions.at(0).approach_m_s, 0.0);
}

}  // namespace impetus::trade_command_test
