// SPDX-License-Identifier: MIT
#include "experiments/run/preview_settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/numerics/at.hpp"
#include "engine/scheduling/metrics.hpp"
#include "experiments/run/level_collision.hpp"

namespace impetus::inline run {
namespace {

constexpr const char* kRegion = "region";

std::string name_of(const StagedScene& scene) {
  if (follows_region(scene.world.settings().schedule)) {
    return kRegion;
  }
  return scene.scheduler.empty() ? "distance" : scene.scheduler;
}

/// As much of the scheduler's range, or of the limits' own, to each list.
void spread_limits(PreviewSettings& settings) {
  const MeasureRange range = measure_range(settings.scheduler);
  for (int list = 0; list + 1 < settings.list_count; ++list) {
    const double share = (list + 1.0) / settings.list_count;
    for (const std::string& rule : limited_list_rule_names()) {
      const ListLimits& limits = *make_list_rule(rule)->limits();
      settings.lists[at(list)].limits[rule] =
          limits.is_of_metric ? range.urgent + share * (range.relaxed - range.urgent)
                              : limits.least + (limits.most - limits.least) / settings.list_count;
    }
  }
}

/// Where the scene has no terms: central and with a large gap, both alike.
std::vector<WeightedTerm> usual_terms() {
  std::vector<WeightedTerm> terms;
  for (const char* metric : {"eccentricity", "projected-gap"}) {
    const MeasureRange range = measure_range(metric);
    terms.push_back({metric, 1.0, range.urgent, range.relaxed});
  }
  return terms;
}

void take_world(PreviewSettings& settings, const StagedScene& scene) {
  const WorldSettings& world = scene.world.settings();
  settings.traversal = world.schedule.traversal;
  settings.persistence_steps = static_cast<int>(world.schedule.persistence_steps);
  if (world.schedule.rule->limits() != nullptr) {
    settings.rule = list_rule_name(*world.schedule.rule);
  }
  settings.all_phases = !(world.costs == WorkCosts{});
  settings.metric_options = scene.metric_options;
  if (settings.metric_options.terms.empty()) {
    settings.metric_options.terms = usual_terms();
  }
  if (!scene.reduction.empty()) {
    settings.reduction = scene.reduction;
  }
  settings.most_per_pair = world.contacts.most_per_pair;
  settings.tunnelling = world.tunnelling;
  settings.response = world.response;
  settings.rotation = world.rotation;
}

RegionRule region_of(const StagedScene& scene) {
  constexpr double kUsualRadius_deg = 5.0;
  constexpr double kUsualRenewal_s = 0.25;
  RegionRule region = scene.region;
  if (region.kind == RegionKind::kNone) {
    region = {RegionKind::kTracked, kUsualRadius_deg, 0};
  }
  if (region.renewal_steps == 0) {
    region.renewal_steps = std::max<std::int64_t>(1, std::llround(kUsualRenewal_s * scene.step_hz));
  }
  return region;
}

void take_budget(PreviewSettings& settings, const WorkBudget& budget) {
  if (budget.ns_per_step > 0) {
    settings.budget = BudgetUnit::kMilliseconds;
    settings.ms_per_step = static_cast<double>(budget.ns_per_step) / 1e6;
  } else if (budget.tests_per_step < kUnlimitedTests) {
    settings.budget = BudgetUnit::kTests;
    settings.tests_per_step = static_cast<int>(
        std::min<std::int64_t>(budget.tests_per_step, std::numeric_limits<int>::max()));
  }
}

}  // namespace

std::vector<std::string> scheduler_names() {
  std::vector<std::string> names;
  for (const std::string_view name : metric_names()) {
    if (!needs_terms(name)) {
      names.emplace_back(name);
    }
  }
  names.emplace_back(kRegion);
  return names;
}

PreviewSettings settings_of(const StagedScene& scene) {
  const Schedule& schedule = scene.world.settings().schedule;
  PreviewSettings settings;
  settings.finest_level = finest_level_of(scene.world);
  for (PreviewList& list : settings.lists) {
    list.greatest_level = settings.finest_level;
  }
  settings.scheduler = name_of(scene);
  settings.list_count = std::min(static_cast<int>(schedule.lists.size()), kMostPreviewLists);
  settings.region = region_of(scene);
  take_budget(settings, scene.budget);
  take_world(settings, scene);
  spread_limits(settings);
  for (int i = 0; i < settings.list_count; ++i) {
    const PriorityList& list = schedule.lists[at(i)];
    PreviewList& shown = settings.lists[at(i)];
    shown.share = list.share;
    shown.least_level = std::min(list.least_level, settings.finest_level);
    shown.greatest_level = std::min(list.greatest_level, settings.finest_level);
    if (at(i) < schedule.limits.size()) {
      shown.limits[settings.rule] = schedule.limits[at(i)];
    }
  }
  return settings;
}

void choose_scheduler(PreviewSettings& settings, const std::string& scheduler) {
  settings.scheduler = scheduler;
  choose_list_count(settings, settings.list_count);
}

void choose_list_count(PreviewSettings& settings, int count) {
  constexpr int kListsOfRegion = 2;
  settings.list_count =
      settings.scheduler == kRegion ? kListsOfRegion : std::clamp(count, 1, kMostPreviewLists);
  spread_limits(settings);
}

ContactModel contacts_of(const PreviewSettings& settings) {
  return {make_reduction(settings.reduction), settings.most_per_pair};
}

WorkCosts costs_of(const PreviewSettings& settings) {
  return settings.all_phases ? kAllPhases : WorkCosts{};
}

WorkBudget budget_of(const PreviewSettings& settings) {
  WorkBudget budget;
  if (settings.budget == BudgetUnit::kMilliseconds) {
    budget.ns_per_step = std::llround(settings.ms_per_step * 1e6);
  } else if (settings.budget == BudgetUnit::kTests) {
    budget.tests_per_step = settings.tests_per_step;
  }
  return budget;
}

Schedule schedule_of(const PreviewSettings& settings) {
  Schedule schedule;
  const bool by_region = settings.scheduler == kRegion;
  schedule.rule = make_list_rule(by_region ? kRegion : settings.rule);
  schedule.metric = by_region
                        ? nullptr
                        : make_metric(settings.scheduler,
                                      options_for(settings.scheduler, settings.metric_options));
  schedule.traversal = settings.traversal;
  schedule.persistence_steps = settings.persistence_steps;
  schedule.lists.clear();
  for (int i = 0; i < settings.list_count; ++i) {
    const PreviewList& list = settings.lists[at(i)];
    const bool limited = list.greatest_level < settings.finest_level;
    schedule.lists.push_back(
        {list.share, list.least_level, limited ? list.greatest_level : kUnlimitedLevel});
    if (!by_region && i + 1 < settings.list_count) {
      schedule.limits.push_back(list.limits.at(settings.rule));
    }
  }
  return schedule;
}

std::string problem_of(const PreviewSettings& settings) {
  try {
    return problem_of(schedule_of(settings));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

}  // namespace impetus::inline run
