// What a scene asks of collision handling: which bodies meet, how fast, and how many pairs a step
// has to refine.
//
//   the scene at its finest levels ──step──> collisions that begin: who, how fast, how spinning
//          └─ a copy, at the coarsest level ──step──> pairs whose outermost nodes overlap
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/trees/tree_settings.hpp"
#include "experiments/record/staged_scene.hpp"
#include "experiments/trade/impacts/impact_pair.hpp"

namespace impetus::inline trade {

/// Two bodies that met.
struct BodyMeeting {
  std::size_t body_a{0};
  std::size_t body_b{0};
  MeetingMotion motion;
};

struct SceneDemand {
  std::vector<BodyMeeting> meetings;  ///< of two bodies, in their order in time
  /// Pairs of bodies that refinement begins with, in each step that has any.
  std::vector<double> pairs;
  std::int64_t steps{0};          ///< that were simulated
  std::int64_t touching_most{0};  ///< pairs that touch at the finest level, in the fullest step
};

/// Simulates the scene to its end, at most 2,400 steps of it, without its budget and schedule.
SceneDemand demand_of(const StagedScene& scene, const Progress& progress = {});

}  // namespace impetus::inline trade
