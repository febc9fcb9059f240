// SPDX-License-Identifier: MIT
#include "experiments/trade/trade_choice.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "experiments/tables/csv_line.hpp"
#include "experiments/tables/text_table.hpp"
#include "experiments/trade/impacts/scene_pairs.hpp"

namespace impetus::inline trade {

using nlohmann::json;

namespace {

/// A list that went to the finest level goes to `level`, others no deeper.
void limit(json& list, int depth_before, int level) {
  const int greatest = list.value("greatest_level", depth_before);
  list["greatest_level"] = greatest == depth_before ? level : std::min(greatest, level);
  if (list.contains("least_level")) {
    list["least_level"] = std::min(list["least_level"].get<int>(), level);
  }
}

}  // namespace

json engine_with(const json& scene, const TradeOption& option, int depth) {
  const int depth_before = scene["engine"].value("tree_depth", 0);
  json engine = with_trees(scene, option.kind, depth)["engine"];
  engine["contacts"]["reduction"] = option.reduction;
  if (!engine.contains("schedule")) {
    engine["level"] = option.level;
    return engine;
  }
  for (json& list : engine["schedule"]["lists"]) {
    limit(list, depth_before, option.level);
  }
  return engine;
}

json scene_with(json scene, const TradeOption& option, int depth) {
  for (const char* key : {"schedule", "budget", "region"}) {
    scene["engine"].erase(key);
  }
  scene["engine"] = engine_with(scene, option, depth);
  return scene;
}

namespace {

std::string kind_words(TreeKind kind) {
  switch (kind) {
    case TreeKind::kOctree:
      return "an octree's spheres";
    case TreeKind::kMedial:
      return "medial spheres";
    case TreeKind::kVoxel:
      return "voxels";
    case TreeKind::kBox:
      return "oriented boxes";
    case TreeKind::kSwept:
      return "swept spheres";
    case TreeKind::kHeterogeneous:
      return "volumes of mixed kinds";
  }
  return name_of(kind);
}

std::string reduction_words(const std::string& reduction) {
  static const std::map<std::string, std::string> words{
      {"none", "all contacts"},       {"first", "the first contact"},
      {"average", "one average"},     {"groups", "grouped averages"},
      {"density", "density normals"}, {"weighted", "weighted averages"}};
  const auto known = words.find(reduction);
  return known == words.end() ? reduction : known->second;
}

}  // namespace

std::string words_for(const TradeOption& option) {
  return kind_words(option.kind) + " to level " + std::to_string(option.level) + " with " +
         reduction_words(option.reduction);
}

std::string error_words(const TradeOption& option) {
  const double normal_deg = option.normal_deg.value;
  return "median normal error " +
         (normal_deg < kLeastNormal_deg ? "below " + two_digits(kLeastNormal_deg)
                                        : two_digits(normal_deg)) +
         "°, 95 % of gaps below " +
         two_digits(std::max(kLeastGap_arcmin, option.gap_arcmin.value)) + " minutes of arc";
}

namespace {

TradeChoice choice_of(const TradeOption& option, double budget_ms, double pairs,
                      const RunScene& run_scene) {
  TradeChoice choice;
  choice.budget_ms = budget_ms;
  choice.option = option;
  choice.pairs_ms = option.step_ms(pairs);
  choice.step_ms = run_scene(option);
  choice.keeps = choice.pairs_ms <= budget_ms && !(choice.step_ms > budget_ms);
  return choice;
}

/// Runs are not for free: where a level of a kind is too slow, no other reduction is tried.
TradeChoice choice_for(double budget_ms, const std::vector<TradeOption>& options, double pairs,
                       const RunScene& run_scene) {
  std::set<std::pair<TreeKind, int>> too_slow;
  for (const TradeOption& option : ranked(options, pairs, budget_ms)) {
    const std::pair<TreeKind, int> bounds{option.kind, option.level};
    if (too_slow.contains(bounds)) {
      continue;
    }
    TradeChoice choice = choice_of(option, budget_ms, pairs, run_scene);
    if (choice.keeps) {
      return choice;
    }
    too_slow.insert(bounds);
  }
  const auto quickest = std::min_element(
      options.begin(), options.end(),
      [](const TradeOption& x, const TradeOption& y) { return x.mean_us < y.mean_us; });
  return choice_of(*quickest, budget_ms, pairs, run_scene);
}

/// With its interval where it has both ends and is no less than what matters.
std::string with_interval(const Estimate& estimate, double least) {
  std::string text = two_digits_from(least, estimate.value);
  if (std::isfinite(estimate.low) && std::isfinite(estimate.high) && estimate.value >= least) {
    text += " (" + two_digits(estimate.low) + "–" + two_digits(estimate.high) + ")";
  }
  return text;
}

constexpr double kLeastVelocity = 1e-3;  // a share of the approach

std::string table_line(const TradeChoice& choice) {
  const TradeOption& option = choice.option;
  return "| " + two_digits(choice.budget_ms) + (choice.keeps ? "" : ", not kept") + " | " +
         name_of(option.kind) + " | " + std::to_string(option.level) + " | " + option.reduction +
         " | " + two_digits(option.mean_us) + " | " + two_digits(choice.pairs_ms) + " | " +
         two_digits(choice.step_ms) + " | " + with_interval(option.normal_deg, kLeastNormal_deg) +
         " | " + with_interval(option.gap_arcmin, kLeastGap_arcmin) + " | " +
         with_interval(option.linear, kLeastVelocity) + " |\n";
}

}  // namespace

std::vector<TradeChoice> choices_for(const std::vector<double>& budgets_ms,
                                     const std::vector<TradeOption>& options, double pairs,
                                     const RunScene& run_scene) {
  std::vector<TradeChoice> choices;
  choices.reserve(budgets_ms.size());
  for (const double budget_ms : budgets_ms) {
    choices.push_back(choice_for(budget_ms, options, pairs, run_scene));
  }
  return choices;
}

std::string advice(const TradeChoice& choice) {
  const std::string begin = choice.keeps ? "within " + two_digits(choice.budget_ms) + " ms, "
                                         : "nothing keeps within " + two_digits(choice.budget_ms) +
                                               " ms; the quickest are ";
  return begin + words_for(choice.option) + ": " + error_words(choice.option) + ".";
}

std::string choices_page(const std::vector<TradeChoice>& choices, const std::string& title,
                         double pairs) {
  std::string text = "# What to choose: " + title + "\n\n";
  for (const TradeChoice& choice : choices) {
    text += "- " + advice(choice) + "\n";
  }
  text +=
      "\n| budget, ms | tree | level | reduction | µs a pair | ms a step, pairs | ms a step, run | "
      "normal error, ° | 95 % of gaps below, ′ | velocity error "
      "|\n|---|---|---|---|---|---|---|---|"
      "---|---|\n";
  for (const TradeChoice& choice : choices) {
    text += table_line(choice);
  }
  text +=
      "\nA step refines " + two_digits(pairs) + (pairs == 1.0 ? " pair" : " pairs") +
      " of bodies (95th percentile of the steps that have any). \"Pairs\" is what they "
      "take at what one took by itself; \"run\" the 95th percentile of the steps of this scene, "
      "run with the choice, without schedule and budget; both in the time of this thread on this "
      "machine. Errors are medians against the exact "
      "meshes at first touch; in brackets 95 % intervals. Gaps are between the surfaces where "
      "the bounds first touch, seen at the screen's centre with nothing hidden. The velocity "
      "error is a share of the speed of approach. `choices.json` holds each choice as the "
      "scene's \"engine\".\n";
  return text;
}

std::string choices_csv(const std::vector<TradeChoice>& choices) {
  std::string text =
      csv_line({"budget_ms", "keeps", "kind", "level", "reduction", "pair_us", "pairs_ms",
                "step_ms", "normal_error_deg", "normal_error_low", "normal_error_high",
                "gap_p95_arcmin", "gap_p95_low", "gap_p95_high", "linear_error", "angular_error"});
  for (const TradeChoice& choice : choices) {
    const TradeOption& option = choice.option;
    text += csv_line({csv_number(choice.budget_ms), choice.keeps ? "true" : "false",
                      name_of(option.kind), std::to_string(option.level), option.reduction,
                      csv_number(option.mean_us), csv_number(choice.pairs_ms),
                      csv_number(choice.step_ms), csv_number(option.normal_deg.value),
                      csv_number(option.normal_deg.low), csv_number(option.normal_deg.high),
                      csv_number(option.gap_arcmin.value), csv_number(option.gap_arcmin.low),
                      csv_number(option.gap_arcmin.high), csv_number(option.linear.value),
                      csv_number(option.angular.value)});
  }
  return text;
}

}  // namespace impetus::inline trade
