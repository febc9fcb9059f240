// How long a whole trial keeps to the trajectory that it would have at the finest level.
//
//   finest level, unlimited budget   o──o──o──o──o
//   as tried                         o──o──o
//                                           ╲o──o    parted once the eye could tell the places, or
//                                                    the turns, of a body apart
//
// Collisions magnify differences, so trajectories part for good: what counts is when. Trials that
// have not parted by their end are censored. All end at the same time, so the estimate of Kaplan
// and Meier is the plain share that has parted, its median an order statistic, and "not by 10 s"
// when fewer than half have. (Kaplan and Meier 1958)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/trees/tree_settings.hpp"
#include "experiments/run/seen_apart.hpp"
#include "experiments/trade/crowds/tried_order.hpp"
#include "experiments/trade/trade_row.hpp"

namespace impetus::inline trade {

/// One way to simulate a trial.
struct PartingSetting {
  std::string kind;            ///< of tree; "": the scene's own
  int level{kUnlimitedLevel};  ///< the greatest; the scene's own scheduler keeps its own
  TriedOrder order{"distance"};
  std::optional<std::int64_t> budget{};  ///< units of work on tests beyond the floor, a step
};

inline constexpr double kNeverParted_s = std::numeric_limits<double>::infinity();

/// One trial beside its reference, which has trees of the same kind.
struct PartedTrial {
  double first_s{kNeverParted_s};  ///< when a first body parted
  double half_s{kNeverParted_s};   ///< when half of the bodies had
  double share_together{1.0};      ///< of the bodies, at the end
};

/// The trials of one setting.
struct PartedTrials {
  PartingSetting setting;
  std::vector<PartedTrial> trials;  ///< by start
};

/// Which settings to try, from how many starts, and when bodies count as parted.
struct PartingRequest {
  std::vector<PartingSetting> settings;  ///< of one kind one after the other
  std::int64_t starts{5};
  std::int64_t first_start{1};  ///< its number
  PartingThresholds thresholds;
  std::uint64_t seed{1};   ///< of what is random in an order
  double longest_s{30.0};  ///< of a trial: longer ones are cut, their bodies censored there
};

/// The scene with trees of `kind` at start `number`, from 1.
using StartOf = std::function<StagedScene(const std::string& kind, std::int64_t number)>;

/// The trials of every setting, from the same starts. The viewer looks at the screen's centre.
std::vector<PartedTrials> partings(const StartOf& start, const PartingRequest& request,
                                   const Progress& progress = {});

/// When trials part from their reference, as rows of the table.
///
///   first_parting, half_parted   seconds; median over the starts, with its interval; an empty
///   value
///                                when it is not reached by the trial's end
///   not_parted                   share of the starts without any parted body at the end
///   together                     share of the bodies at the end, mean over the starts
///
/// `subject` is the scene's name.
std::vector<TradeRow> parting_rows(const std::vector<PartedTrials>& partings,
                                   const std::string& subject);

}  // namespace impetus::inline trade
