// Priority lists: which pairs get which share of a step's work, and how deep they may go.
//
//   pairs --metric and thresholds, or a region--> list 0 | list 1 | ... --shares--> refinement
//
// All good, all bad, tracked, random and yoked are all the same thing: which pairs fall into which
// list, and each list's least and greatest level. (Dingliana 2002, sec. 5.1.2 and 6.3.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/scheduling/priority.hpp"

namespace impetus::inline scheduling {

inline constexpr int kMostLists = 16;
inline constexpr int kUnlimitedLevel = std::numeric_limits<int>::max();

struct PriorityList {
  double share{1.0};   ///< of the step's work beyond the floor, relative to the other lists'
  int least_level{0};  ///< done whatever the budget, as part of the floor
  int greatest_level{kUnlimitedLevel};  ///< never exceeded
};

/// A disc about a point of the screen, as the eye sees it.
struct GazeRegion {
  ScreenPoint centre;
  double radius_deg{0.0};
};

/// Whether the place of the collision projects inside the region.
bool inside(const GazeRegion& region, const PairBounds& bounds, const Viewer& viewer);

/// What decides a pair's list.
enum class ListRule {
  kThresholds,  ///< its metric against `thresholds`
  kRegion,      ///< inside the step's region: list 0; outside, or without a region: list 1
  /// Its rank by the metric among the step's pairs against `pair_shares`. Of equal measures the
  /// pair first in the broad phase's order has the higher rank, so a share may part them.
  kPairShares,
};

/// Which pair of a list gets the next block of work. (Dingliana 2002, fig. 5.1)
enum class Traversal {
  kDepthFirst,    ///< the first that is unfinished: one pair after the other
  kBreadthFirst,  ///< the one at the coarsest level: level after level
  kBestFirst,     ///< the one whose next level is expected to remove most visible gap per work
  /// The one of which finer levels are expected to remove most of what the viewer could see, per
  /// work: gaps that only coarse bounds leave, where the eye resolves them.
  kVisibleFirst,
};

/// How the work of a step is shared. As it stands: one list, nearest first.
struct Schedule {
  std::shared_ptr<const PriorityMetric> metric;  ///< none: distance
  std::vector<PriorityList> lists = std::vector<PriorityList>(1);
  ListRule rule{ListRule::kThresholds};
  /// One fewer than lists, in the metric's own unit, from high priority to low: a pair falls into
  /// the first list whose threshold it meets, or else into the last.
  std::vector<double> thresholds;
  Traversal traversal{Traversal::kDepthFirst};
  /// For kPairShares, one fewer than lists: the share of a step's pairs that each list but the last
  /// takes, in [0, 1], together at most 1.
  std::vector<double> pair_shares{};
  /// A pair that touches keeps the highest priority it had in this many steps before; 0: none.
  /// (Dingliana 2002, sec. 5.3.1)
  std::int64_t persistence_steps{0};
};

/// What is wrong with the schedule, as "schedule: expected ..., got ..."; empty when nothing is.
std::string problem_of(const Schedule& schedule);

/// A pair with its place in the schedule.
struct ScheduledPair {
  BodyPair pair;
  int list{0};
};

/// And with what orders it within its list: of larger priorities the pair that came first.
struct MeasuredPair {
  ScheduledPair scheduled;
  double priority{0.0};
  std::int32_t place{0};  ///< among the pairs as they came
};

/// The schedule's metric, or distance when it names none.
const PriorityMetric& metric_of(const Schedule& schedule);

/// Whether the metric decides which list a pair falls into; else the region does, or there is one.
inline bool metric_decides_lists(const Schedule& schedule) {
  return schedule.rule != ListRule::kRegion && schedule.lists.size() > 1;
}

/// Measures the pairs of `bounds` and gives each its list: what `pairs` held before is forgotten.
/// They are in no order yet.
void measure(const std::vector<PairBounds>& bounds, const Schedule& schedule, const Viewer& viewer,
             const Fixation& fixation, const std::optional<GazeRegion>& region,
             std::vector<MeasuredPair>& pairs);

/// The same without measuring any: no pair has a priority yet. Precondition: not
/// metric_decides_lists(schedule).
void put_into_lists(const std::vector<PairBounds>& bounds, const Schedule& schedule,
                    const Viewer& viewer, const std::optional<GazeRegion>& region,
                    std::vector<MeasuredPair>& pairs);

/// Whether x goes before y: by list, and by falling priority within each; equal priorities keep the
/// order in which they came, and what is not a number comes last.
bool goes_before(const MeasuredPair& x, const MeasuredPair& y);

/// The pairs by list, and by falling priority within each; equal priorities keep their order.
std::vector<ScheduledPair> scheduled(const std::vector<PairBounds>& bounds,
                                     const Schedule& schedule, const Viewer& viewer,
                                     const Fixation& fixation,
                                     const std::optional<GazeRegion>& region);

}  // namespace impetus::inline scheduling
