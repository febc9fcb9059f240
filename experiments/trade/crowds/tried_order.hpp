// An order of work that is tried on a scene: which pair comes first, and in which order pairs are
// refined.
//
//   a metric by its name   one list of all pairs, to the finest level
//   "random"               the same, by a number drawn for each pair
//   "scene"                the scene's own lists, levels and order, whatever is asked
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/record/staged_scene.hpp"

namespace impetus::inline trade {

inline constexpr const char* kOwnScheduler = "scene";
inline constexpr const char* kRandomScheduler = "random";

/// An order of work: what decides a pair's urgency, and how the pairs are gone through.
struct TriedOrder {
  std::string scheduler;
  std::string traversal{"depth-first"};
};

/// The traversals that are asked for, or all when none is. Throws InputError that lists the names
/// there are when one is unknown.
std::vector<std::string> tried_traversals(const std::vector<std::string>& asked);

/// What can be tried on a scene: "scene", "random", and the metrics, of which those made of terms
/// need the scene's own.
std::vector<std::string> schedulers_for(const StagedScene& scene);

/// Each scheduler with each traversal; the scene's own once, as it is. Throws InputError that lists
/// what can be tried when a scheduler cannot.
std::vector<TriedOrder> tried_orders(const StagedScene& scene,
                                     const std::vector<std::string>& schedulers,
                                     const std::vector<std::string>& traversals);

/// The schedule of an order. Nothing persists from steps before. What is random follows from
/// `seed`.
Schedule schedule_of(const TriedOrder& order, const StagedScene& scene, std::uint64_t seed);

}  // namespace impetus::inline trade
