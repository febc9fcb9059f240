// What a scene asks of collision handling: which bodies meet, how fast, and how many pairs a step
// has to refine.
//
//   the scene at its finest levels ──step──> collisions that begin: who, how fast, how spinning
//          └─ a copy, at the coarsest level ──step──> pairs whose outermost nodes overlap
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/trees/tree_settings.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/record/staged_scene.hpp"
#include "experiments/trade/impacts/impact_pair.hpp"
#include "experiments/trade/trade_option.hpp"
#include "experiments/trade/trade_row.hpp"

namespace impetus::inline trade {

/// Two bodies that met.
struct BodyMeeting {
  std::size_t body_a{0};
  std::size_t body_b{0};
  MeetingMotion motion;
};

/// What a scene asked of collision handling in all its steps.
struct SceneDemand {
  std::vector<BodyMeeting> meetings;  ///< of two bodies, in their order in time
  /// Pairs of bodies that refinement begins with, in each step that has any.
  std::vector<double> pairs;
  std::int64_t steps{0};          ///< that were simulated
  std::int64_t touching_most{0};  ///< pairs that touch at the finest level, in the fullest step
};

/// Simulates the scene to its end, at most 2,400 steps of it, without its budget and schedule.
SceneDemand demand_of(const StagedScene& scene, const Progress& progress = {});

/// Milliseconds of each step in which bodies touch, all phases included, without budget: of the
/// whole scene, or of what can be run in `most_s` seconds. Empty when nothing touches.
std::vector<double> step_times_ms(const StagedScene& scene, const Clock& clock, double most_s);

/// The same as rows of the part "run": median, p95 and p99, for the option that the scene ran with.
std::vector<TradeRow> run_rows(const std::string& title, const TradeOption& option,
                               const std::vector<double>& times_ms);

/// Pairs of bodies that a step of the scene refines, of the steps that have any: their 95th
/// percentile; 1 when there is none.
double pairs_per_step(const SceneDemand& demand);

std::vector<TradeRow> scene_rows(const SceneDemand& demand, const std::string& title);

}  // namespace impetus::inline trade
