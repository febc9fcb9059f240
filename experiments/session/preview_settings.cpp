// SPDX-License-Identifier: MIT
#include "experiments/session/preview_settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <typeinfo>

#include "engine/scheduling/metrics.hpp"

namespace impetus {
namespace {

constexpr const char* kRegion = "region";

std::size_t at(int index) { return static_cast<std::size_t>(index); }

int finest_level_of(const World& world) {
  int finest = 0;
  for (const BodyModel& body : world.models()) {
    finest = std::max(finest, body.tree->level_count() - 1);
  }
  return finest;
}

/// Metrics carry no name: the one of the same kind has it.
std::string name_of(const Schedule& schedule) {
  if (schedule.rule == ListRule::kRegion) {
    return kRegion;
  }
  if (!schedule.metric) {
    return "distance";
  }
  const PriorityMetric& own = *schedule.metric;
  for (const std::string_view name : metric_names()) {
    if (needs_terms(name)) {
      continue;
    }
    const auto known = make_metric(name);
    const PriorityMetric& metric = *known;
    if (typeid(own) == typeid(metric)) {
      return std::string(name);
    }
  }
  return "distance";
}

void spread_thresholds(PreviewSettings& settings) {
  const ThresholdRange range = threshold_range(settings.scheduler);
  for (int list = 0; list + 1 < settings.list_count; ++list) {
    const double share = (list + 1.0) / settings.list_count;
    settings.lists[at(list)].threshold = range.urgent + share * (range.relaxed - range.urgent);
  }
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

ThresholdRange threshold_range(const std::string& scheduler) {
  static const std::map<std::string, ThresholdRange> known{{"distance", {"m", 0.0, 2.0}},
                                                           {"eccentricity", {"°", 0.0, 30.0}},
                                                           {"projected-gap", {"°", 15.0, 0.0}},
                                                           {"size", {"°", 15.0, 0.0}},
                                                           {"velocity", {"°/s", 0.0, 60.0}}};
  const auto found = known.find(scheduler);
  return found == known.end() ? ThresholdRange{"", 0.0, 100.0} : found->second;
}

PreviewSettings settings_of(const StagedScene& scene) {
  const Schedule& schedule = scene.world.settings().schedule;
  PreviewSettings settings;
  settings.finest_level = finest_level_of(scene.world);
  for (PreviewList& list : settings.lists) {
    list.greatest_level = settings.finest_level;
  }
  settings.scheduler = name_of(schedule);
  settings.list_count = std::min(static_cast<int>(schedule.lists.size()), kMostPreviewLists);
  settings.region = region_of(scene);
  take_budget(settings, scene.budget);
  spread_thresholds(settings);
  for (int i = 0; i < settings.list_count; ++i) {
    const PriorityList& list = schedule.lists[at(i)];
    PreviewList& shown = settings.lists[at(i)];
    shown.share = list.share;
    shown.least_level = std::min(list.least_level, settings.finest_level);
    shown.greatest_level = std::min(list.greatest_level, settings.finest_level);
    if (at(i) < schedule.thresholds.size()) {
      shown.threshold = schedule.thresholds[at(i)];
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
  spread_thresholds(settings);
}

Schedule schedule_of(const PreviewSettings& settings) {
  Schedule schedule;
  const bool by_region = settings.scheduler == kRegion;
  schedule.rule = by_region ? ListRule::kRegion : ListRule::kThresholds;
  schedule.metric = by_region ? nullptr : make_metric(settings.scheduler);
  schedule.lists.clear();
  for (int i = 0; i < settings.list_count; ++i) {
    const PreviewList& list = settings.lists[at(i)];
    const bool limited = list.greatest_level < settings.finest_level;
    schedule.lists.push_back(
        {list.share, list.least_level, limited ? list.greatest_level : kUnlimitedLevel});
    if (!by_region && i + 1 < settings.list_count) {
      schedule.thresholds.push_back(list.threshold);
    }
  }
  return schedule;
}

std::string problem_of(const PreviewSettings& settings) {
  return problem_of(schedule_of(settings));
}

}  // namespace impetus
