// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_schedule.hpp"

#include <cmath>

#include "engine/scheduling/metrics.hpp"

namespace impetus {
namespace {

using nlohmann::json;

constexpr const char* kRegionScheduler = "region";
constexpr double kDefaultRenewal_ms = 250.0;

std::string scheduler_of(const json& engine) {
  return engine.contains("schedule") ? engine["schedule"]["scheduler"].get<std::string>() : "";
}

PriorityList list_from(const json& entry) {
  PriorityList list;
  list.share = entry.value("share", list.share);
  list.least_level = entry.value("least_level", list.least_level);
  list.greatest_level = entry.value("greatest_level", list.greatest_level);
  return list;
}

double renewal_steps(const json& engine) {
  return engine["region"].value("renewal_ms", kDefaultRenewal_ms) / 1e3 *
         engine["step_hz"].get<double>();
}

void add_list_problems(const json& engine, std::vector<SceneProblem>& problems) {
  const int deepest = engine.value("tree_depth", 0);
  const json& lists = engine["schedule"]["lists"];
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const std::string place = "/engine/schedule/lists/" + std::to_string(i);
    for (const char* key : {"least_level", "greatest_level"}) {
      if (lists[i].contains(key) && lists[i][key] > deepest) {
        problems.push_back({place + "/" + key, "expected at most " + std::to_string(deepest) +
                                                   ", the deepest level of the trees, got " +
                                                   lists[i][key].dump()});
      }
    }
    const PriorityList list = list_from(lists[i]);
    if (list.least_level > list.greatest_level) {
      problems.push_back({place + "/least_level", "expected at most greatest_level " +
                                                      std::to_string(list.greatest_level) +
                                                      ", got " + std::to_string(list.least_level)});
    }
  }
}

void add_threshold_problems(const json& engine, std::vector<SceneProblem>& problems) {
  const json& schedule = engine["schedule"];
  const std::size_t lists = schedule["lists"].size();
  const std::size_t thresholds = schedule.value("thresholds", json::array()).size();
  if (scheduler_of(engine) == kRegionScheduler) {
    if (lists != 2) {
      problems.push_back(
          {"/engine/schedule/lists",
           "expected two lists, inside and outside the region, got " + std::to_string(lists)});
    }
    if (thresholds != 0) {
      problems.push_back(
          {"/engine/schedule/thresholds",
           "expected none with the scheduler region, got " + schedule["thresholds"].dump()});
    }
    return;
  }
  if (thresholds + 1 != lists) {
    problems.push_back({"/engine/schedule/thresholds", "expected one fewer than lists, " +
                                                           std::to_string(lists - 1) + ", got " +
                                                           std::to_string(thresholds)});
    return;
  }
  const std::string message = problem_of(schedule_of(engine));
  if (!message.empty()) {
    problems.push_back({"/engine/schedule", message});
  }
}

void add_region_problems(const json& engine, std::vector<SceneProblem>& problems) {
  const bool by_region = scheduler_of(engine) == kRegionScheduler;
  if (by_region && !engine.contains("region")) {
    problems.push_back(
        {"/engine", "expected the key \"region\" for the scheduler region, which is missing"});
  }
  if (!by_region && engine.contains("region")) {
    problems.push_back(
        {"/engine/region", "expected the scheduler region with it, got " +
                               (engine.contains("schedule") ? engine["schedule"]["scheduler"].dump()
                                                            : std::string("no schedule"))});
  }
  if (by_region && engine.contains("region")) {
    const double steps = renewal_steps(engine);
    if (steps < 1.0 || std::abs(steps - std::round(steps)) > 1e-9 * steps) {
      problems.push_back(
          {"/engine/region/renewal_ms",
           "expected a whole number of steps of 1/" + engine["step_hz"].dump() + " s, got " +
               engine["region"].value("renewal_ms", json(kDefaultRenewal_ms)).dump()});
    }
  }
}

}  // namespace

Schedule schedule_of(const json& engine) {
  Schedule schedule;
  if (engine.contains("level")) {
    const int level = engine["level"].get<int>();
    schedule.lists.front().least_level = level;
    schedule.lists.front().greatest_level = level;
  }
  if (!engine.contains("schedule")) {
    return schedule;
  }
  schedule.lists.clear();
  for (const json& entry : engine["schedule"]["lists"]) {
    schedule.lists.push_back(list_from(entry));
  }
  if (scheduler_of(engine) == kRegionScheduler) {
    schedule.rule = ListRule::kRegion;
    return schedule;
  }
  schedule.metric = make_metric(scheduler_of(engine));
  schedule.thresholds = engine["schedule"].value("thresholds", std::vector<double>{});
  return schedule;
}

RegionRule region_of(const json& engine) {
  if (scheduler_of(engine) != kRegionScheduler) {
    return {};
  }
  const auto kind = engine["region"]["kind"].get<std::string>();
  const RegionKind known = kind == "all-good"  ? RegionKind::kAllGood
                           : kind == "all-bad" ? RegionKind::kAllBad
                           : kind == "tracked" ? RegionKind::kTracked
                                               : RegionKind::kRandom;
  return {known, engine["region"]["radius_deg"].get<double>(), std::llround(renewal_steps(engine))};
}

WorkBudget budget_of(const json& engine) {
  WorkBudget budget;
  const json entry = engine.value("budget", json::object());
  budget.tests_per_step = entry.value("tests_per_step", budget.tests_per_step);
  budget.ns_per_step = std::llround(entry.value("ms_per_step", 0.0) * 1e6);
  return budget;
}

bool depends_on_gaze(const json& engine) {
  return region_of(engine).kind == RegionKind::kTracked || scheduler_of(engine) == "eccentricity";
}

std::vector<SceneProblem> schedule_problems(const json& engine) {
  std::vector<SceneProblem> problems;
  if (engine.contains("level") && engine["level"] > engine.value("tree_depth", 0)) {
    problems.push_back(
        {"/engine/level", "expected at most " + std::to_string(engine.value("tree_depth", 0)) +
                              ", the deepest level of the trees, got " + engine["level"].dump()});
  }
  if (engine.contains("schedule")) {
    if (engine.contains("level")) {
      problems.push_back(
          {"/engine/level", "expected none beside a schedule, whose lists have levels, got " +
                                engine["level"].dump()});
    }
    add_list_problems(engine, problems);
    add_threshold_problems(engine, problems);
  }
  add_region_problems(engine, problems);
  return problems;
}

}  // namespace impetus
