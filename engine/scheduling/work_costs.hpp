// What the phases of a step cost, in units of work: whole numbers, so that a budget means the same
// on every machine.
//
//   work of a step = tests done + contacts modelled + contacts responded to, each times its cost
//
// A unit is the test of two spheres. The costs were calibrated offline, by the benchmark that
// compares them (tests/bench/work_bench.cpp); they are data of the step, not of the machine.
// (Dingliana 2002, eq. 3.9, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace impetus::inline scheduling {

/// As it stands, node-pair tests alone count.
struct WorkCosts {
  std::int64_t sphere_test{1};      ///< of two nodes that are spheres
  std::int64_t volume_test{1};      ///< of any other two nodes, or of a node and a wall
  std::int64_t model{0};            ///< of an overlapping pair of nodes made a contact
  std::int64_t response{0};         ///< to one contact that was left by the reduction
  std::int64_t volume_model{0};     ///< added to `model` when two nodes are not both spheres
  std::int64_t hinged_response{0};  ///< added to `response` where a part of a figure is touched

  friend bool operator==(const WorkCosts&, const WorkCosts&) = default;
};

/// All phases of collision handling, as calibrated when recordings began to rest on it; what is
/// measured today stands beside it in engine/README.md.
inline constexpr WorkCosts kAllPhases{1, 16, 3, 100, 60, 1000};

/// Far above any sensible ratio, and far below what could overflow.
inline constexpr std::int64_t kGreatestCost = 1'000'000;

/// What is wrong with the costs, as "work costs: expected ..., got ..."; empty when nothing is.
std::string problem_of(const WorkCosts& costs);

}  // namespace impetus::inline scheduling
