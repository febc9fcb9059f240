// Bodies that are too fast to be tested where the step ends alone are tested along their ways, and
// stop where they first touch.
//
//   entries   of the fast pairs, on the ways the bodies would take
//   stop      both bodies of the earliest; they are moved anew, by less, and their pairs are looked
//             at again; and so on until no pair has an entry
//   at last   bodies that are stopped too often stop together with all that they could meet, at the
//             first entry there was before anybody stopped
//
// Safe when no entry is left: every fast pair was found free of one on the ways both took. A stop
// changes a way only after it, and by the turn of the shorter step; both are looked at again. Safe
// at last too: until the first entry nobody had stopped, so all were on the ways that were looked
// at first, on which no pair had touched by then; and no body meets one that is not its candidate.
// What a stopped body lost of the step is lost; its momenta are not touched but by the gravity of
// the shorter step, and it turned by what the integrator makes of that, so its energy is as good as
// after any step (at last: as that of a pose between two steps).
//
// Where the step's tests are bounded, or the work is metered, they go to the pairs in the order of
// the candidates, and then of their stops. A pair for which none are left is not searched, and does
// not stop anybody; one whose search they end in goes on by what a slow pair may, and stops. When
// no work is left for stops, those that are known are left undone, as if nobody had searched.
// (Mirtich 1996; Dingliana 2002, sec. 5.3.2)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/collision/entry/time_of_entry.hpp"
#include "engine/dynamics/body.hpp"
#include "engine/dynamics/motion.hpp"
#include "engine/scheduling/work_costs.hpp"
#include "engine/scheduling/work_meter.hpp"
#include "engine/scheduling/workers.hpp"
#include "engine/volumes/enclosure.hpp"

namespace impetus::inline dynamics {

/// How often a body is stopped in a step before it is stopped together with others.
inline constexpr int kMostStops = 16;

/// A step as it was made, of bodies that were not stopped: their states before it and their trees.
struct StepMade {
  double dt_s;
  const std::vector<BodyModel>& models;
  const std::vector<BodyState>& before;
  const std::vector<PairBounds>& candidates;
  int greatest_level;  ///< that any pair may be refined to
  const WorkCosts& costs;
  Rotation rotation;
  int most_stops{kMostStops};
  /// Of each body; none: nothing falls. A body that falls is looked at on the way from where it was
  /// to where it stops, straight as its turn is steady: so the ways of all bodies join from step to
  /// step, and none passes another on them unseen.
  std::span<const Fall> falls{};
  std::int64_t most_tests{kUnlimitedTests};  ///< of all searches
  PhaseWork* work{nullptr};                  ///< of the same, where it is metered, and of stops
  Workers* workers{nullptr};                 ///< who search at once; they change nothing
  const Enclosure* walls{nullptr};           ///< that end the ways of centres, if any do
  EntryRules entry_rules{EntryRules::kNodeWays};
};

/// Who was stopped, and what finding it took.
struct Stopping {
  std::vector<StoppedAtEntry> stopped;  ///< in the order of the candidates
  std::int64_t work{0};                 ///< of all tests along the ways
  std::int64_t tests{0};                ///< of node pairs: at most StepMade::most_tests
  std::vector<BodyPair> unsearched;  ///< fast pairs for which no tests were left, by their bodies
  bool ran_out{false};               ///< of tests, before a search or in it, or of work

  /// Whether the pair is one of `unsearched`.
  [[nodiscard]] bool lacked_tests(BodyPair bodies) const;
};

/// An entry that was found on ways that may have changed since.
struct FoundEntry {
  double time{0.0};
  std::size_t pair{0};
};

/// What was found of a pair before it was its turn, within so many tests; 0: it was not searched.
struct SearchedAhead {
  Entry entry;
  std::int64_t most_tests{0};
};

/// The two of whom a worker searches the entry: nobody else writes beside them.
struct alignas(128) TreesOnTheWay {
  PlacedTree a;
  PlacedTree b;
};

/// What the search keeps from step to step, for the memory alone: it means nothing between them.
struct EntryMemory {
  std::vector<BodyPath> whole_ways;  ///< of bodies that nothing stops
  std::vector<double> farthest_m;    ///< that any point of each body goes
  std::vector<BodyPath> ways;
  std::vector<int> stops;                      ///< how often each body was stopped
  std::vector<std::optional<double>> pending;  ///< entries of the candidates on their ways
  std::vector<std::optional<double>> first;    ///< the same before anybody was stopped
  std::vector<std::optional<double>> last;     ///< at which a candidate stopped a body last
  std::vector<FoundEntry> found;               ///< a heap, the earliest first
  std::vector<std::uint32_t> first_of_body;    ///< where each body's candidates begin
  std::vector<std::uint32_t> candidates_of_body;
  std::vector<std::uint32_t> looked_at;   ///< candidates that are searched next
  std::vector<SearchedAhead> ahead;       ///< by candidate
  std::vector<TreesOnTheWay> on_the_way;  ///< by worker
  Stopping result;
};

/// Puts the bodies of `states`, which are at the end of the step, back to where they must stop.
/// `placed` are their trees, anywhere. What it returns is part of `memory`.
const Stopping& stop_at_entry(const StepMade& step, std::vector<BodyState>& states,
                              const std::vector<PlacedTree>& placed, EntryMemory& memory);

}  // namespace impetus::inline dynamics
