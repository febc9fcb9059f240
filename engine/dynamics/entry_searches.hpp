// The searches for entries of one step: which pairs are fast, when they first touch on the ways of
// their bodies, and what finding it takes. Some are made before it is their turn.
//
//   in turn    p0, p1, p2 …     each asks for its work, is counted, and gives its entry
//   ahead      p0 │ p1 │ p2 …   searched by several workers at once, nobody asked
//
// What a search finds depends on the ways of its two bodies alone, unless its tests run out. So
// when it is the pair's turn what was found ahead counts, once all its tests are granted; if they
// are not, or may not be so many, it is searched again, and ends where it would have ended.
// Entries, counts and grants are those of one worker.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/dynamics/stop_at_entry.hpp"

namespace impetus::inline dynamics {

/// Looks for the entries of a step's candidates, named by their places among them.
class EntrySearches {
 public:
  EntrySearches(const StepMade& step, const std::vector<BodyState>& states,
                const std::vector<PlacedTree>& placed, EntryMemory& memory);

  /// Nobody stops, as far as can be told without a search. Leaves some ways unknown.
  [[nodiscard]] bool all_are_slow();

  /// Finds what every body goes by when nothing stops it: before the first look.
  void find_whole_ways();

  /// The way of a body that takes `share` of the step: its state is where it stops.
  [[nodiscard]] BodyPath way_of(std::size_t body, double share) const;

  /// Finds the entries of `pairs` on the bodies' present ways, in this order, each `noted` with its
  /// place. None where a pair is slow, or no work is left.
  template <typename Note>
  void look_at(std::span<const std::uint32_t> pairs, const Note& note) {
    std::size_t ahead = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (i == ahead) {
        ahead += search_ahead(pairs.subspan(i));
      }
      note(pairs[i], look_at(pairs[i]));
    }
  }

  /// Whether so much more may be done.
  [[nodiscard]] bool has_work(std::int64_t units) {
    return step_.work == nullptr || step_.work->spend(units);
  }

  /// Nobody is searched: pairs that are not surely slow are taken for fast.
  void leave_fast_pairs();

 private:
  [[nodiscard]] const BodyPair& bodies(std::size_t pair) const {
    return step_.candidates[pair].pair;
  }
  double farthest_of(std::size_t body);
  [[nodiscard]] bool is_slow(std::size_t pair, double share);
  [[nodiscard]] double share_of_slow_way(std::size_t pair) const;
  [[nodiscard]] PairOnTheWay on_the_way(std::size_t pair, int worker, std::int64_t most_tests);
  std::optional<double> look_at(std::size_t pair);
  std::size_t search_ahead(std::span<const std::uint32_t> pairs);
  void search_ahead(std::size_t pair, int worker, std::int64_t most_tests);
  [[nodiscard]] bool counts(const SearchedAhead& ahead, std::int64_t most_tests);

  const StepMade& step_;
  const std::vector<BodyState>& states_;
  const std::vector<PlacedTree>& placed_;
  EntryMemory& memory_;
  Stopping& result_;
};

}  // namespace impetus::inline dynamics
