// Candidate pairs, those whose bounding spheres could meet within the step, by sweep and prune: the
// bodies' intervals along one axis, kept in order from step to step.
//
//   x:  |--a--|   |---c---|
//          |---b---|        |--d--|      sorted by their least ends; a meets b, b meets c
//
// From one step to the next the order hardly changes, so an insertion sort takes about one
// comparison a body; after a teleport, which takes it many, an ordinary sort does. The order is a
// total one (least end, then body), so the result never depends on the order before: the memory
// saves time and decides nothing.
//
// Many bodies are swept strip by strip: a body is in each strip across the axis that it reaches,
// and a pair is found in the first strip that both reach. So a body is compared with those near it
// along two axes, and the cost of a body hardly depends on how many others there are.
//
// A sweep goes in rounds: each body is compared with the next block of those that begin behind it,
// then each with the block after that. So one that is stopped has compared everybody with those
// that begin nearest behind him.
//
// Intervals are conservative and pairs are tested as candidate_pairs() tests them, so the result is
// the same to the last bit. A body whose interval is not a finite number meets every other.
// (Baraff 1992; Cohen et al. 1995; Dingliana 2002, sec. 5.3.2)
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/numerics/lanes.hpp"
#include "engine/scheduling/priority.hpp"
#include "engine/scheduling/work_meter.hpp"

namespace impetus::inline collision {

/// What the broad phase needs of a body: its bound at the end of the step, how far it moved in
/// it (metres), and whether anything can move it.
struct MovedBound {
  Sphere bound;
  double travelled_m{0.0};
  bool movable{true};
};

/// Whether the bounds, grown by the distance both travelled, touch. a comes before b.
bool could_meet(const MovedBound& a, const MovedBound& b);

/// Every pair that could meet; in order of (b, a). Two immovable bodies never pair. All pairs are
/// tested: SweepAndPrune finds the same ones sooner.
/// (Dingliana 2002, sec. 5.3.2: space-time bounds)
std::vector<PairBounds> candidate_pairs(const std::vector<MovedBound>& bodies);

/// The bodies of candidate_pairs(bodies), in its order, in place of what `pairs` held.
void find_among_all(const std::vector<MovedBound>& bodies, std::vector<BodyPair>& pairs);

/// The pairs with their bodies' bounds, in place of what `candidates` held.
void take_bounds(const std::vector<MovedBound>& bodies, const std::vector<BodyPair>& pairs,
                 std::vector<PairBounds>& candidates);

/// What a body covers along the axis of the sweep and across it.
struct SweptInterval {
  double least;
  double greatest;
  std::array<double, 2> across_least;
  std::array<double, 2> across_greatest;
  std::int32_t body;
  bool movable;
  std::uint16_t first_strip{0};  ///< that it reaches
};

/// The intervals of a sweep, each end in an array of its own: what is compared, a block at a time.
/// Strip follows upon strip, with a gap between that nobody reaches.
class SweptIntervals {
 public:
  void clear();

  /// Adds a strip's intervals, sorted by their least ends. Returns the place of the first.
  std::size_t add(const std::vector<SweptInterval>& sorted);

  /// Whether the interval at `first`, of the same strip or in the gap behind it, begins within that
  /// at `index`.
  [[nodiscard]] bool reaches(std::size_t index, std::size_t first) const {
    return least_[first] <= greatest_[index];
  }

  /// Which of the kLanes intervals from `first` on meet interval `index` along all axes: a bit
  /// each.
  [[nodiscard]] std::uint32_t meeting(std::size_t index, std::size_t first,
                                      LaneWidth width = widest_lanes()) const;

  /// Of a block, for whom it is compared.
  struct Ends {
    const double* least;
    const double* greatest;
    const double* across_least[2];
    const double* across_greatest[2];
  };

 private:
  [[nodiscard]] Ends from(std::size_t index) const;

  std::vector<double> least_;
  std::vector<double> greatest_;
  std::array<std::vector<double>, 2> across_least_;
  std::array<std::vector<double>, 2> across_greatest_;
};

/// Finds the candidate pairs of step after step, in memory that it keeps.
class SweepAndPrune {
 public:
  /// Finds the bodies of candidate_pairs(bodies), in any order, in place of what `pairs` held.
  /// Where `work` does not grant the whole sweep: those of them that were found until then.
  void find(const std::vector<MovedBound>& bodies, std::vector<BodyPair>& pairs,
            PhaseWork* work = nullptr);

  /// Puts pairs of so many bodies in order of (b, a).
  void put_in_order(std::size_t bodies, std::vector<BodyPair>& pairs);

  /// What candidate_pairs(bodies) returns.
  std::vector<PairBounds> candidates(const std::vector<MovedBound>& bodies);

 private:
  void cover(const std::vector<MovedBound>& bodies, int axis);
  void sort();
  void part_into_strips();
  [[nodiscard]] std::size_t strip_at(double place_m) const;
  /// A body of a strip, and the place where its next block begins.
  struct Sweeping {
    std::size_t strip;
    std::size_t place;
    std::size_t next;
  };

  void begin_sweep();
  void sweep(PhaseWork* work, std::vector<BodyPair>& pairs);
  void find_in_block(const Sweeping& one, std::uint32_t meeting, std::vector<BodyPair>& pairs);

  std::array<std::vector<std::int32_t>, 3> orders_;  ///< bodies along each axis, last time
  std::vector<SweptInterval> intervals_;
  std::vector<std::vector<SweptInterval>> strips_;  ///< those from strip_count_ on mean nothing
  std::size_t strip_count_{1};
  double strips_begin_m_{0.0};
  double strip_width_m_{1.0};
  SweptIntervals swept_;
  std::vector<std::size_t> strip_places_;  ///< of each strip's first interval in swept_
  std::vector<Sweeping> sweeping_;         ///< who still reaches somebody
  std::vector<BodyPair> half_sorted_;
  std::vector<std::size_t> places_;
};

}  // namespace impetus::inline collision
