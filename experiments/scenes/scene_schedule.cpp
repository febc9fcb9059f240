// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "engine/scheduling/metrics.hpp"
#include "experiments/scenes/scene_region.hpp"
#include "experiments/scenes/schedule_checks.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

PriorityList list_from(const json& entry) {
  PriorityList list;
  list.share = entry.value("share", list.share);
  list.least_level = entry.value("least_level", list.least_level);
  list.greatest_level = entry.value("greatest_level", list.greatest_level);
  return list;
}

std::shared_ptr<const Traversal> traversal_in(const json& schedule) {
  return schedule.contains("traversal") ? make_traversal(schedule["traversal"].get<std::string>())
                                        : Schedule().traversal;
}

void set_rule(const json& schedule, Schedule& result) {
  if (schedule["scheduler"].get<std::string>() == kRegionScheduler) {
    result.rule = make_list_rule(kRegionScheduler);
    return;
  }
  const std::string name = limits_key(schedule);
  result.rule = make_list_rule(name);
  result.limits = schedule.value(name, std::vector<double>{});
}

/// Whether any of the metrics that take part in a schedule's decisions looks at the fixation.
bool measures_from_fixation(const json& schedule) {
  std::set<std::string> names{schedule["scheduler"].get<std::string>()};
  for (const json& term : schedule.value("terms", json::array())) {
    names.insert(term["metric"].get<std::string>());
  }
  return std::any_of(names.begin(), names.end(), [](const std::string& name) {
    return name != kRegionScheduler && !needs_terms(name) &&
           (make_metric(name)->terms() & kFixationTerm) != 0;
  });
}

}  // namespace

std::string scheduler_of(const json& engine) {
  return engine.contains("schedule") ? engine["schedule"]["scheduler"].get<std::string>() : "";
}

ScreenPoint screen_point_of(const json& point_deg, double metres_per_degree) {
  return {metres_per_degree * point_deg[0].get<double>(),
          metres_per_degree * point_deg[1].get<double>()};
}

std::vector<std::string> limits_keys() {
  std::vector<std::string> keys;
  for (const std::string_view name : list_rule_names()) {
    if (make_list_rule(name)->has_limits()) {
      keys.emplace_back(name);
    }
  }
  return keys;
}

std::string limits_key(const json& schedule) {
  const std::vector<std::string> keys = limits_keys();
  const auto said = std::find_if(keys.rbegin(), keys.rend(), [&schedule](const std::string& key) {
    return schedule.contains(key);
  });
  return said == keys.rend() ? keys.front() : *said;
}

double steps_of(double duration_ms, const json& engine) {
  return duration_ms / 1e3 * engine["step_hz"].get<double>();
}

bool is_whole(double steps) { return std::abs(steps - std::round(steps)) <= 1e-9 * steps; }

Schedule schedule_of(const json& engine, double metres_per_degree) {
  Schedule result;
  if (engine.contains("level")) {
    const int level = engine["level"].get<int>();
    result.lists.front().least_level = level;
    result.lists.front().greatest_level = level;
  }
  if (!engine.contains("schedule")) {
    return result;
  }
  const json& schedule = engine["schedule"];
  result.lists.clear();
  for (const json& entry : schedule["lists"]) {
    result.lists.push_back(list_from(entry));
  }
  set_rule(schedule, result);
  if (!follows_region(result)) {
    result.metric = make_metric(scheduler_of(engine), metric_options_of(engine, metres_per_degree));
  }
  result.traversal = traversal_in(schedule);
  result.persistence_steps = std::llround(steps_of(schedule.value("persistence_ms", 0.0), engine));
  return result;
}

int deepest_level_of(const json& engine) {
  const int finest = engine.value("tree_depth", 0);
  if (engine.contains("level")) {
    return std::min(finest, engine["level"].get<int>());
  }
  if (!engine.contains("schedule")) {
    return finest;
  }
  int deepest = 0;
  for (const json& entry : engine["schedule"]["lists"]) {
    deepest = std::max(deepest, std::min(finest, list_from(entry).greatest_level));
  }
  return deepest;
}

MetricOptions metric_options_of(const json& engine, double metres_per_degree) {
  MetricOptions options;
  const json schedule = engine.value("schedule", json::object());
  if (schedule.contains("point_deg")) {
    options.point = screen_point_of(schedule["point_deg"], metres_per_degree);
  }
  for (const json& term : schedule.value("terms", json::array())) {
    options.terms.push_back({term["metric"].get<std::string>(), term.value("weight", 1.0),
                             term["urgent"].get<double>(), term["relaxed"].get<double>()});
  }
  return options;
}

bool depends_on_gaze(const json& engine) {
  if (region_of(engine, 1.0).kind == RegionKind::kTracked) {
    return true;
  }
  if (!engine.contains("schedule")) {
    return false;
  }
  if ((traversal_in(engine["schedule"])->terms() & kAcuityTerm) != 0) {
    return true;
  }
  if (engine["schedule"].contains("point_deg")) {
    return false;
  }
  return measures_from_fixation(engine["schedule"]);
}

std::vector<SceneProblem> schedule_problems(const json& engine) {
  std::vector<SceneProblem> problems;
  add_level_problems(engine, problems);
  if (engine.contains("schedule")) {
    add_schedule_key_problems(engine, problems);
  }
  if (engine.contains("schedule") && problems.empty()) {
    try {
      const std::string message = problem_of(schedule_of(engine, 1.0));
      if (!message.empty()) {
        problems.push_back({"/engine/schedule", message});
      }
    } catch (const std::invalid_argument& error) {
      problems.push_back({"/engine/schedule", error.what()});
    }
  }
  return problems;
}

}  // namespace impetus::inline scenes
