// SPDX-License-Identifier: MIT
#include "experiments/scenes/engine_setup.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "experiments/scenes/engine_checks.hpp"

namespace impetus::inline scenes {
namespace {

std::vector<PairRestitution> restitutions_of(const Scene& scene) {
  std::vector<PairRestitution> restitutions;
  for (const MaterialPair& entry : scene.engine.materials.value_or(std::vector<MaterialPair>{})) {
    restitutions.push_back({material_number(scene, entry.pair[0]),
                            material_number(scene, entry.pair[1]), entry.restitution});
  }
  return restitutions;
}

void set_rule(const ScheduleSettings& schedule, Schedule& result) {
  if (schedule.scheduler == kRegionScheduler) {
    result.rule = make_list_rule(kRegionScheduler);
    return;
  }
  const std::string name = limits_key(schedule);
  result.rule = make_list_rule(name);
  if (const auto said = schedule.limits.find(name); said != schedule.limits.end()) {
    result.limits = said->second;
  }
}

std::shared_ptr<const Traversal> traversal_in(const ScheduleSettings& schedule) {
  return schedule.traversal ? make_traversal(*schedule.traversal) : Schedule().traversal;
}

/// Whether any of the metrics that take part in a schedule's decisions looks at the fixation.
bool measures_from_fixation(const ScheduleSettings& schedule) {
  const auto looks = [](const std::string& metric) {
    return metric != kRegionScheduler && !needs_terms(metric) &&
           (make_metric(metric)->terms() & kFixationTerm) != 0;
  };
  const auto terms = schedule.terms.value_or(std::vector<WeightedTerm>{});
  return looks(schedule.scheduler) ||
         std::any_of(terms.begin(), terms.end(),
                     [&](const WeightedTerm& term) { return looks(term.metric); });
}

}  // namespace

WorldSettings world_settings_of(const Scene& scene) {
  const EngineSettings& engine = scene.engine;
  WorldSettings settings = engine.world;
  settings.gravity_m_s2 = engine.gravity_m_s2.value_or(settings.gravity_m_s2);
  if (!engine.contacts.reduction.empty()) {
    settings.contacts.reduction = make_reduction(engine.contacts.reduction);
  }
  settings.contacts.most_per_pair = engine.contacts.most_per_pair;
  settings.materials = restitutions_of(scene);
  settings.wall_material = material_number(scene, scene.enclosure ? scene.enclosure->material : "");
  settings.costs = engine.budget ? engine.budget->counts : WorkCosts{};
  return settings;
}

int material_number(const Scene& scene, const std::string& name) {
  const std::set<std::string> materials = materials_of(scene);
  const auto found = materials.find(name);
  return found == materials.end() ? 0
                                  : 1 + static_cast<int>(std::distance(materials.begin(), found));
}

WorkBudget budget_of(const EngineSettings& engine) {
  WorkBudget budget;
  if (engine.budget) {
    budget.tests_per_step = engine.budget->tests_per_step.value_or(budget.tests_per_step);
    budget.ns_per_step = std::llround(engine.budget->ms_per_step.value_or(0.0) * 1e6);
  }
  return budget;
}

Schedule schedule_of(const EngineSettings& engine, double metres_per_degree, std::size_t bodies) {
  Schedule result;
  if (engine.level) {
    result.lists.front().least_level = *engine.level;
    result.lists.front().greatest_level = *engine.level;
  }
  if (!engine.schedule) {
    return result;
  }
  const ScheduleSettings& schedule = *engine.schedule;
  result.lists = schedule.lists;
  set_rule(schedule, result);
  if (!follows_region(result)) {
    result.metric =
        make_metric(schedule.scheduler, metric_options_of(engine, metres_per_degree, bodies));
  }
  result.traversal = traversal_in(schedule);
  result.persistence_steps = std::llround(steps_of(schedule.persistence_ms, engine));
  return result;
}

std::string limits_key(const ScheduleSettings& schedule) {
  const std::vector<std::string> keys = limited_list_rule_names();
  const auto said = std::find_if(keys.rbegin(), keys.rend(), [&](const std::string& key) {
    return schedule.limits.contains(key);
  });
  return said == keys.rend() ? keys.front() : *said;
}

int deepest_level_of(const EngineSettings& engine) {
  const int finest = engine.finest_level();
  if (engine.level) {
    return std::min(finest, *engine.level);
  }
  if (!engine.schedule) {
    return finest;
  }
  int deepest = 0;
  for (const PriorityList& list : engine.schedule->lists) {
    deepest = std::max(deepest, std::min(finest, list.greatest_level));
  }
  return deepest;
}

MetricOptions metric_options_of(const EngineSettings& engine, double metres_per_degree,
                                std::size_t bodies) {
  MetricOptions options;
  if (engine.schedule) {
    if (engine.schedule->point_deg) {
      options.point = screen_point_of(*engine.schedule->point_deg, metres_per_degree);
    }
    options.terms = engine.schedule->terms.value_or(options.terms);
    if (engine.schedule->noticing) {
      options.noticing = engine.schedule->noticing->among(bodies);
    }
  }
  return options;
}

RegionRule region_of(const EngineSettings& engine, double metres_per_degree) {
  if (engine.scheduler() != kRegionScheduler || !engine.region) {
    return {};
  }
  const RegionSettings& region = *engine.region;
  RegionRule rule;
  rule.kind = region.kind;
  rule.radius_deg = region.radius_deg;
  rule.renewal_steps = std::llround(steps_of(region.renewal_ms, engine));
  if (rule.kind == RegionKind::kFixed) {
    rule.point = screen_point_of(*region.point_deg, metres_per_degree);
  }
  return rule;
}

bool depends_on_gaze(const EngineSettings& engine) {
  if (!engine.schedule) {
    return false;
  }
  const bool tracked = engine.scheduler() == kRegionScheduler && engine.region &&
                       engine.region->kind == RegionKind::kTracked;
  return tracked || (traversal_in(*engine.schedule)->terms() & kAcuityTerm) != 0 ||
         (!engine.schedule->point_deg && measures_from_fixation(*engine.schedule));
}

TreeSettings tree_settings_of(const EngineSettings& engine, int deepest_level) {
  TreeSettings settings = engine.tree.value_or(TreeSettings{});
  settings.depth = engine.finest_level();
  if (deepest_level < settings.depth) {
    settings.built_depth = deepest_level;
  }
  return settings;
}

ScreenPoint screen_point_of(const ScreenPlace& place_deg, double metres_per_degree) {
  return {metres_per_degree * place_deg[0], metres_per_degree * place_deg[1]};
}

double steps_of(double duration_ms, const EngineSettings& engine) {
  return duration_ms / 1e3 * engine.step_hz;
}

bool is_whole(double steps) { return std::abs(steps - std::round(steps)) <= 1e-9 * steps; }

}  // namespace impetus::inline scenes
