// When two bodies first touch on their ways within a step, by conservative advancement.
//
//   t ──► bound the time for which no pair of nodes can touch ──► move on by it ──┐
//   ▲                                                                             │
//   └──── apart, and the step not over ◄──────────────────────────────────────────┘
//
// Two nodes touch no sooner than they close the gap between them on the ways that they go from here
// (node_ways.hpp), and `hair` further on they overlap by no more than it. Nodes count as the
// refinement counts them: a pair whose parents are apart does not touch. The bound of a pair of
// trees is found by branch and bound over their node pairs.
//
// Trees of spheres are searched a block of siblings at a time: those that could touch in time are
// looked at closely, in their order. Tests that are skipped are counted, so a search costs what it
// is worth, in whatever way it is done.
//
// Bodies that already overlap at the start may go on as long as they do not overlap by more; those
// that overlap by more than they are thick are left to the response.
// (Mirtich 1996; Tang, Kim and Manocha 2009; Dingliana 2002, sec. 5.3.2)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "engine/collision/entry/body_path.hpp"
#include "engine/collision/entry/slow_way.hpp"
#include "engine/collision/placed_tree.hpp"
#include "engine/scheduling/priority.hpp"
#include "engine/scheduling/work_meter.hpp"
#include "engine/trees/volume_tree.hpp"

namespace impetus::inline collision {

/// Node pairs that are looked at for one pair of bodies, when nothing less is asked for; then they
/// go on by what a slow pair may, and stop there.
inline constexpr std::int64_t kMostEntryTests = 20'000;

/// How a search bounds when nodes touch, and in which order it asks: by the rules of a recording
/// format.
enum class EntryRules {
  kDirected,      ///< below 7: by how fast points can come towards each other, in order
  kNearestFirst,  ///< 7: the same; each look begins with the nodes that were nearest in the look
                  ///< before and goes on with the nearest of siblings
  kNodeWays,      ///< from 8 on: by the way of each node, in order
};

/// Two bodies, their ways, and how finely they are looked at. Both trees must outlive it, and are
/// left where the search ends.
struct PairOnTheWay {
  PlacedTree& a;
  PlacedTree& b;
  const BodyPath& path_a;
  const BodyPath& path_b;
  int greatest_level;
  std::int64_t most_tests{kMostEntryTests};  ///< at least 1
  PhaseWork* work{nullptr};  ///< asked for the tests, where work is metered; then it ends there too
  EntryRules rules{EntryRules::kNodeWays};
};

/// Whether the bodies move further against each other within the step than this share of what a
/// slow pair may.
bool is_fast(const PairOnTheWay& pair, double share_of_slow_way = 1.0);

/// What a search found, and what it took.
struct Entry {
  std::optional<double> time;  ///< share of the step after which both must stop, if they must
  std::int64_t tests{0};       ///< of node pairs
  bool refused{false};         ///< by the meter, so that the search ended early
};

/// When the bodies overlap, by at most an eighth of slow_way_m, so early that what is left of their
/// way would carry them further by a quarter of it.
Entry time_of_entry(const PairOnTheWay& pair);

/// What is done about bodies that move further in a step than they are thick. (Dingliana 2002, sec.
/// 5.3.2)
enum class Tunnelling {
  kIgnored,      ///< bodies are tested where the step ends
  kCapped,       ///< fast pairs stay at levels whose nodes are thicker than the way: Alg. 5.3.1
  kStopAtEntry,  ///< fast pairs are tested along their way, and stopped where they first touch
};

/// A pair that would have passed into or through each other unseen, and was stopped.
struct StoppedAtEntry {
  BodyPair bodies;
  double fraction{0.0};  ///< of the step that both were moved
};

}  // namespace impetus::inline collision
