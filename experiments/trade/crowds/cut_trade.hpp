// What is given up where a phase of a crowd's step is granted less than it asks for.
//
//   trajectory at the finest level ──every so often──> a step that is granted all
//     the same step, one phase granted a part of what it takes ──> who goes elsewhere, how visibly
//     a second of such steps, at a few of the moments          ──> who is seen elsewhere then
//
//   refinement   tests beyond the roots; contacts stay coarser
//   entry        of fast bodies along their ways; they stop early, or at coarser levels
//   response     contacts answered, the most visible first, where passes over all are not granted
//
// A phase is granted a part, from a 64th to all, of what it takes in the median of the moments.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/scheduling/work_meter.hpp"
#include "engine/trees/tree_settings.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/run/seen_apart.hpp"
#include "experiments/trade/crowds/tried_order.hpp"
#include "experiments/trade/trade_row.hpp"

namespace impetus::inline trade {

/// A phase that is cut, as the table calls it.
struct CutPhase {
  const char* name;
  WorkPhase phase;
  bool has_order;  ///< the schedule decides what comes first
};

inline constexpr std::array<CutPhase, 3> kCutPhases{{{"refinement", WorkPhase::kTests, true},
                                                     {"entry", WorkPhase::kEntry, false},
                                                     {"response", WorkPhase::kVisible, true}}};

/// Which orders to try where a phase has one, and how often.
struct CutRequest {
  std::vector<TriedOrder> orders;
  PartingThresholds thresholds;  ///< of who is seen elsewhere after a second
  double sampled_every_s{0.5};   ///< of the scene's time
  std::size_t courses{4};        ///< moments that are followed for a second
  std::uint64_t seed{1};
  double longest_s{30.0};
};

/// A step of which a phase was cut, beside the one that was granted all.
struct CutStep {
  /// Of all bodies: how far from where it would be each is a tenth of a second later, if it meets
  /// nobody; in minutes of arc at the fovea, by what the eye resolves where it is.
  double visible_error{0.0};
  double wrong_m_s{0.0};   ///< sum of the differences of velocities, of bodies that touch
  double moving_m_s{0.0};  ///< sum of what these velocities should be
};

/// The moments with one phase cut to one part, in one order.
struct CutCrowd {
  const CutPhase* phase{nullptr};
  std::size_t order_place{0};  ///< in CutRequest::orders
  std::int64_t part{1};        ///< a 64th, ..., a half, all: one over this
  std::int64_t budget{0};      ///< units of the phase
  std::vector<CutStep> steps;
  std::vector<double> elsewhere;  ///< share of the bodies after a second; by course
};

/// Cuts each phase that does something in the scene. All follows from the scene and the request.
std::vector<CutCrowd> cut_trade(const StagedScene& scene, const CutRequest& request,
                                const Progress& progress = {});

/// Tried in `orders`, as rows of the part "cut", against the step that is granted all.
///
///   visible_error         arcmin, mean of a step
///   wrong_velocity        share of the velocities, of bodies that touch
///   elsewhere_after_1s    share of the bodies, mean
std::vector<TradeRow> cut_rows(const std::vector<CutCrowd>& crowds,
                               const std::vector<TriedOrder>& orders, const std::string& subject);

/// The rows of the part "cut" as a page of Markdown: a line for each phase, order and measure, a
/// column for each part. Empty when there are none.
std::string cut_page(const std::vector<TradeRow>& rows);

}  // namespace impetus::inline trade
