// How much of what could be seen of a crowd's collisions each order of work removes.
//
//   trajectory at the finest level ──every so often──> a step, the same for all orders
//     a step ──order, budget──> level of every pair ──> visible error left   (pair_levels.hpp)
//            ──the same work──> what chance, breadth-first and hindsight would have removed
//
// Work is what tests cost beyond those of the roots, which no order could spare: modelling and
// response follow from where refinement stands. Fast bodies are tested where the step ends, for the
// searches along their ways are the same in every order. Each sampled step starts from a copy of
// the trajectory's world, and the viewer looks at a body drawn for it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/trees/tree_settings.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/trade/crowds/pair_levels.hpp"
#include "experiments/trade/crowds/tried_order.hpp"

namespace impetus::inline trade {

/// Which orders to try, within which budgets, how often.
struct CrowdRequest {
  std::vector<TriedOrder> orders;
  /// Units of work on tests beyond the roots', a step; none: usual_budgets().
  std::vector<std::int64_t> budgets;
  double sampled_every_s{0.25};  ///< of the scene's time
  std::uint64_t seed{1};         ///< of where the viewer looks, and of all that is random
  double longest_s{30.0};        ///< of the scene's time: no more of it is tried
};

/// A sampled step, whatever the order.
struct SampledStep {
  std::int64_t step{0};
  std::int64_t pairs{0};        ///< whose roots overlap
  std::int64_t finest_work{0};  ///< until all stand at their finest levels
  VisibleError at_roots;
  VisibleError at_finest;  ///< what no order could remove
};

/// What became of it in one order, within one budget.
struct OrderedStep {
  std::int64_t work{0};
  VisibleError left;
  /// Of the error at the roots: by this order, and with as much work by random orders, depth-first
  /// and breadth-first (means over the same ones for all), and at most in hindsight.
  VisibleError removed;
  VisibleError by_chance;
  VisibleError breadth_first;
  VisibleError in_hindsight;
  std::int64_t contacts{0};   ///< responded to
  double energy_change{0.0};  ///< of the bodies' energy, relative to what their motion had
  std::int64_t ns{0};         ///< by the clock: of World::step
};

/// The sampled steps in one order, within one budget.
struct OrderedCrowd {
  TriedOrder order;
  std::int64_t budget{0};
  std::vector<OrderedStep> steps;
};

/// What all orders did to the sampled steps.
struct CrowdTrade {
  std::vector<SampledStep> steps;
  std::vector<OrderedCrowd> orders;  ///< by budget, the orders as asked for within each
};

/// Shares of what the finest levels of the median step take, from a 64th to all of it, each twice
/// the one before; none where nothing was sampled.
std::vector<std::int64_t> usual_budgets(const StagedScene& scene, const CrowdRequest& request);

/// Tries the orders on the scene. All but OrderedStep::ns follows from the scene and the request.
/// Precondition: budgets and the time between samples are positive.
CrowdTrade crowd_trade(const StagedScene& scene, const CrowdRequest& request, const Clock& clock,
                       const Progress& progress = {});

}  // namespace impetus::inline trade
