// What a preview's controls say, as plain data: scheduler, lists, region, budget, contacts,
// response.
//
//   controls -> PreviewSettings -> Schedule, ContactModel, ..., for the next step
//
// A combination that no schedule allows is kept as it is, with the sentence that says why.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "experiments/record/staged_scene.hpp"

namespace impetus::inline run {

inline constexpr int kMostPreviewLists = 4;

/// What limits a step's work: nothing, units of work, or time by the clock.
enum class BudgetUnit { kUnlimited, kTests, kMilliseconds };

/// The controls of one priority list.
struct PreviewList {
  double share{1.0};      ///< relative to the other lists'
  int least_level{0};     ///< done whatever the budget
  int greatest_level{0};  ///< at the finest level: no limit
  /// What parts it from the next, by the name of the list rule; the last list needs none.
  std::map<std::string, double> limits{};
};

/// All that the preview's controls say.
struct PreviewSettings {
  std::string scheduler{"distance"};  ///< one of scheduler_names()
  int list_count{1};                  ///< 1 to kMostPreviewLists; two for "region"
  std::array<PreviewList, kMostPreviewLists> lists{};
  int finest_level{0};                               ///< of all trees of the scene
  RegionRule region{RegionKind::kTracked, 5.0, 60};  ///< for the scheduler "region"
  BudgetUnit budget{BudgetUnit::kUnlimited};
  int tests_per_step{500};
  double ms_per_step{0.2};
  bool all_phases{false};          ///< work counts contacts and response too
  std::string rule{"thresholds"};  ///< with limits; of "region" its own
  std::shared_ptr<const Traversal> traversal = make_traversal("depth-first");
  int persistence_steps{0};
  MetricOptions metric_options{};    ///< the scene's own; its terms for the scheduler "weighted"
  std::string reduction{"average"};  ///< one of reduction_names()
  int most_per_pair{4};
  Tunnelling tunnelling{Tunnelling::kStopAtEntry};
  ResponseMethod response{ResponseMethod::kInTurn};
  Rotation rotation{Rotation::kMidpoint};
};

/// The names of the metrics, and "region".
std::vector<std::string> scheduler_names();

/// As the scene's own schedule, region and budget are, where they fit the controls; otherwise one
/// list, a region about the mouse that is renewed every quarter of a second, no limit.
PreviewSettings settings_of(const StagedScene& scene);

/// Another scheduler, with thresholds spread over its range; "region" brings its two lists.
void choose_scheduler(PreviewSettings& settings, const std::string& scheduler);

/// Another number of lists, with thresholds spread anew.
void choose_list_count(PreviewSettings& settings, int count);

/// What the contacts, the work and the budget are to be.
ContactModel contacts_of(const PreviewSettings& settings);
WorkBudget budget_of(const PreviewSettings& settings);
WorkCosts costs_of(const PreviewSettings& settings);

/// The schedule they ask for, which may be impossible: see problem_of().
Schedule schedule_of(const PreviewSettings& settings);

/// One sentence when no world would take the schedule; otherwise empty.
std::string problem_of(const PreviewSettings& settings);

}  // namespace impetus::inline run
