// SPDX-License-Identifier: MIT
#include "experiments/scenes/schedule_checks.hpp"

#include <limits>

#include "engine/scheduling/metrics.hpp"
#include "experiments/scenes/scene_region.hpp"
#include "experiments/scenes/scene_schedule.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;
using Problems = std::vector<SceneProblem>;

constexpr const char* kPlace = "/engine/schedule";

void add_list_problems(const json& engine, Problems& problems) {
  const int deepest = engine.value("tree_depth", 0);
  const json& lists = engine["schedule"]["lists"];
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const std::string place = std::string(kPlace) + "/lists/" + std::to_string(i);
    for (const char* key : {"least_level", "greatest_level"}) {
      if (lists[i].contains(key) && lists[i][key] > deepest) {
        problems.push_back({place + "/" + key, "expected at most " + std::to_string(deepest) +
                                                   ", the deepest level of the trees, got " +
                                                   lists[i][key].dump()});
      }
    }
    const int least = lists[i].value("least_level", 0);
    const int greatest = lists[i].value("greatest_level", std::numeric_limits<int>::max());
    if (least > greatest) {
      problems.push_back({place + "/least_level", "expected at most greatest_level " +
                                                      std::to_string(greatest) + ", got " +
                                                      std::to_string(least)});
    }
  }
}

void refuse_schedule_key(const json& schedule, const std::string& key, const std::string& why,
                         Problems& problems) {
  if (schedule.contains(key)) {
    problems.push_back({std::string(kPlace) + "/" + key,
                        "expected none " + why + ", got " + schedule[key].dump()});
  }
}

void add_region_rule_problems(const json& schedule, Problems& problems) {
  const std::size_t lists = schedule["lists"].size();
  if (lists != 2) {
    problems.push_back(
        {std::string(kPlace) + "/lists",
         "expected two lists, inside and outside the region, got " + std::to_string(lists)});
  }
  for (const std::string& key : limits_keys()) {
    if (!schedule.value(key, json::array()).empty()) {
      refuse_schedule_key(schedule, key, "with the scheduler region", problems);
    }
  }
}

void add_metric_rule_problems(const json& schedule, Problems& problems) {
  const std::string key = limits_key(schedule);
  for (const std::string& other : limits_keys()) {
    if (other != key) {
      refuse_schedule_key(schedule, other, "beside " + key, problems);
    }
  }
  const std::size_t needed = schedule["lists"].size() - 1;
  const std::size_t given = schedule.value(key, json::array()).size();
  if (given != needed) {
    problems.push_back({std::string(kPlace) + "/" + key, "expected one fewer than lists, " +
                                                             std::to_string(needed) + ", got " +
                                                             std::to_string(given)});
  }
}

void add_metric_option_problems(const json& schedule, Problems& problems) {
  const auto scheduler = schedule["scheduler"].get<std::string>();
  if (scheduler != "weighted") {
    refuse_schedule_key(schedule, "terms", "with the scheduler " + scheduler, problems);
  } else if (!schedule.contains("terms")) {
    problems.push_back(
        {kPlace, "expected the key \"terms\" for the scheduler weighted, which is missing"});
  }
  if (!takes_point(scheduler)) {
    refuse_schedule_key(schedule, "point_deg", "with the scheduler " + scheduler, problems);
  }
}

void add_persistence_problems(const json& engine, Problems& problems) {
  const json persistence_ms = engine["schedule"].value("persistence_ms", json(0));
  if (!is_whole(steps_of(persistence_ms.get<double>(), engine))) {
    problems.push_back({std::string(kPlace) + "/persistence_ms",
                        "expected a whole number of steps of 1/" + engine["step_hz"].dump() +
                            " s, got " + persistence_ms.dump()});
  }
}

}  // namespace

void add_level_problems(const json& engine, Problems& problems) {
  const int deepest = engine.value("tree_depth", 0);
  if (engine.contains("level") && engine["level"] > deepest) {
    problems.push_back({"/engine/level", "expected at most " + std::to_string(deepest) +
                                             ", the deepest level of the trees, got " +
                                             engine["level"].dump()});
  }
  if (!engine.contains("schedule")) {
    return;
  }
  if (engine.contains("level")) {
    problems.push_back(
        {"/engine/level", "expected none beside a schedule, whose lists have levels, got " +
                              engine["level"].dump()});
  }
  add_list_problems(engine, problems);
}

void add_schedule_key_problems(const json& engine, Problems& problems) {
  const json& schedule = engine["schedule"];
  if (scheduler_of(engine) == kRegionScheduler) {
    add_region_rule_problems(schedule, problems);
  } else {
    add_metric_rule_problems(schedule, problems);
  }
  add_metric_option_problems(schedule, problems);
  add_persistence_problems(engine, problems);
}

}  // namespace impetus::inline scenes
