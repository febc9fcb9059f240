// SPDX-License-Identifier: MIT
#include "experiments/scenes/engine_checks.hpp"

#include <stdexcept>

#include "experiments/scenes/engine_setup.hpp"

namespace impetus::inline scenes {
namespace {

const std::string kPlace = "/engine/schedule";

void add_list_problems(const EngineSettings& engine, SceneProblems& problems) {
  const int deepest = engine.finest_level();
  const std::string at_most =
      "expected at most " + std::to_string(deepest) + ", the deepest level of the trees";
  const std::vector<PriorityList>& lists = engine.schedule->lists;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const std::string place = kPlace + "/lists/" + std::to_string(i);
    const PriorityList& list = lists[i];
    if (list.least_level > deepest) {
      problems.add_got(place + "/least_level", at_most);
    }
    if (list.greatest_level != kUnlimitedLevel && list.greatest_level > deepest) {
      problems.add_got(place + "/greatest_level", at_most);
    }
    if (list.least_level > list.greatest_level) {
      problems.add_got(place + "/least_level",
                       "expected at most greatest_level " + std::to_string(list.greatest_level));
    }
  }
}

void add_level_problems(const EngineSettings& engine, SceneProblems& problems) {
  const int deepest = engine.finest_level();
  if (engine.level && *engine.level > deepest) {
    problems.add_got("/engine/level", "expected at most " + std::to_string(deepest) +
                                          ", the deepest level of the trees");
  }
  if (!engine.schedule) {
    return;
  }
  if (engine.level) {
    problems.add_got("/engine/level", "expected none beside a schedule, whose lists have levels");
  }
  add_list_problems(engine, problems);
}

void add_region_rule_problems(const ScheduleSettings& schedule, SceneProblems& problems) {
  if (schedule.lists.size() != 2) {
    problems.add(kPlace + "/lists", "expected two lists, inside and outside the region, got " +
                                        std::to_string(schedule.lists.size()));
  }
  for (const std::string& key : limited_list_rule_names()) {
    const auto limits = schedule.limits.find(key);
    if (limits != schedule.limits.end() && !limits->second.empty()) {
      problems.add_got(kPlace + "/" + key, "expected none with the scheduler region");
    }
  }
}

void add_metric_rule_problems(const ScheduleSettings& schedule, SceneProblems& problems) {
  const std::string key = limits_key(schedule);
  for (const std::string& other : limited_list_rule_names()) {
    if (other != key && schedule.limits.contains(other)) {
      problems.add_got(kPlace + "/" + other, "expected none beside " + key);
    }
  }
  const auto limits = schedule.limits.find(key);
  const std::size_t needed = schedule.lists.size() - 1;
  const std::size_t given = limits == schedule.limits.end() ? 0 : limits->second.size();
  if (given != needed) {
    problems.add(kPlace + "/" + key, "expected one fewer than lists, " + std::to_string(needed) +
                                         ", got " + std::to_string(given));
  }
}

void add_metric_option_problems(const ScheduleSettings& schedule, SceneProblems& problems) {
  const std::string message = "expected none with the scheduler " + schedule.scheduler;
  if (!needs_terms(schedule.scheduler)) {
    if (schedule.terms) {
      problems.add_got(kPlace + "/terms", message);
    }
  } else if (!schedule.terms) {
    problems.add_missing(kPlace, "terms", "for the scheduler " + schedule.scheduler);
  }
  if (!takes_point(schedule.scheduler) && schedule.point_deg) {
    problems.add_got(kPlace + "/point_deg", message);
  }
}

std::string whole_steps_message(const SceneProblems& problems) {
  return "expected a whole number of steps of 1/" + problems.written("/engine/step_hz") + " s";
}

void add_kind_problems(const EngineSettings& engine, SceneProblems& problems) {
  const RegionSettings& region = *engine.region;
  const double steps = steps_of(region.renewal_ms, engine);
  if (steps < 1.0 || !is_whole(steps)) {
    const std::string place = "/engine/region/renewal_ms";
    problems.add(place, whole_steps_message(problems) + ", got " +
                            problems.written_or(place, region.renewal_ms));
  }
  const std::string kind = word_for(region.kind, region_names());
  const bool is_fixed = region.kind == RegionKind::kFixed;
  if (is_fixed && !region.point_deg) {
    problems.add_missing("/engine/region", "point_deg", "for kind " + kind);
  }
  if (!is_fixed && region.point_deg) {
    problems.add_got("/engine/region/point_deg", "expected none for kind " + kind);
  }
}

}  // namespace

void add_schedule_problems(const EngineSettings& engine, SceneProblems& problems) {
  add_level_problems(engine, problems);
  if (!engine.schedule) {
    return;
  }
  const ScheduleSettings& schedule = *engine.schedule;
  if (schedule.scheduler == kRegionScheduler) {
    add_region_rule_problems(schedule, problems);
  } else {
    add_metric_rule_problems(schedule, problems);
  }
  add_metric_option_problems(schedule, problems);
  if (!is_whole(steps_of(schedule.persistence_ms, engine))) {
    problems.add_got(kPlace + "/persistence_ms", whole_steps_message(problems));
  }
  if (!problems.empty()) {
    return;
  }
  try {
    const std::string message = problem_of(schedule_of(engine, 1.0));
    if (!message.empty()) {
      problems.add(kPlace, message);
    }
  } catch (const std::invalid_argument& error) {
    problems.add(kPlace, error.what());
  }
}

void add_region_problems(const EngineSettings& engine, SceneProblems& problems) {
  const bool by_region = engine.scheduler() == kRegionScheduler;
  if (by_region && !engine.region) {
    problems.add_missing("/engine", "region", "for the scheduler region");
  }
  if (!by_region && engine.region) {
    problems.add("/engine/region", "expected the scheduler region with it, got " +
                                       (engine.schedule ? '"' + engine.scheduler() + '"'
                                                        : std::string("no schedule")));
  }
  if (by_region && engine.region) {
    add_kind_problems(engine, problems);
  }
}

void add_material_problems(const Scene& scene, SceneProblems& problems) {
  const std::set<std::string> materials = materials_of(scene);
  const auto entries = scene.engine.materials.value_or(std::vector<MaterialPair>{});
  std::set<std::set<std::string>> stated;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string place = "/engine/materials/" + std::to_string(i) + "/pair";
    for (std::size_t side = 0; side < 2; ++side) {
      if (!materials.contains(entries[i].pair[side])) {
        problems.add_got(place + "/" + std::to_string(side),
                         "expected a material that a body, the crowd or the enclosure has");
      }
    }
    if (!stated.insert({entries[i].pair[0], entries[i].pair[1]}).second) {
      problems.add(place, "expected a pair of its own, got " + problems.written(place) + " again");
    }
  }
}

void add_budget_problems(const EngineSettings& engine, SceneProblems& problems) {
  if (!engine.budget) {
    return;
  }
  const bool by_tests = engine.budget->tests_per_step.has_value();
  if (by_tests == engine.budget->ms_per_step.has_value()) {
    problems.add("/engine/budget",
                 std::string("expected one of the keys \"tests_per_step\" and \"ms_per_step\", "
                             "got ") +
                     (by_tests ? "both" : "none"));
  }
}

void add_tree_problems(const EngineSettings& engine, SceneProblems& problems) {
  if (!engine.tree) {
    return;
  }
  if (!engine.tree_depth) {
    problems.add_missing("/engine", "tree_depth", "beside \"tree\"");
  }
  problems.add_tree_problem("/engine/tree", problem_of(tree_settings_of(engine)));
}

std::set<std::string> materials_of(const Scene& scene) {
  std::set<std::string> names;
  for (const BodySettings& body : scene.named_bodies()) {
    names.insert(body.material);
  }
  for (const NamedFigure& figure : scene.named_figures()) {
    names.insert(figure.material);
  }
  if (scene.crowd) {
    names.insert(scene.crowd->material);
  }
  if (scene.figure_crowd) {
    names.insert(scene.figure_crowd->material);
  }
  if (scene.enclosure) {
    names.insert(scene.enclosure->material);
  }
  names.erase("");
  return names;
}

}  // namespace impetus::inline scenes
