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

/// What candidate_pairs(bodies) returns, in place of what `pairs` held.
void find_among_all(const std::vector<MovedBound>& bodies, std::vector<PairBounds>& pairs);

/// What a body covers along the axis of the sweep and across it.
struct SweptInterval {
  double least;
  double greatest;
  std::array<double, 2> across_least;
  std::array<double, 2> across_greatest;
  std::int32_t body;
  bool movable;
};

/// The intervals of a sweep, each end in an array of its own: what is compared, a block at a time.
class SweptIntervals {
 public:
  /// Takes intervals sorted by their least ends; forgets those before.
  void take(const std::vector<SweptInterval>& sorted);

  /// Whether interval `first` begins within interval `index`, or there is none left.
  [[nodiscard]] bool reaches(std::size_t index, std::size_t first) const {
    return first < size_ && least_[first] <= greatest_[index];
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

  std::size_t size_{0};
  std::vector<double> least_;
  std::vector<double> greatest_;
  std::array<std::vector<double>, 2> across_least_;
  std::array<std::vector<double>, 2> across_greatest_;
};

/// Finds the candidate pairs of step after step, in memory that it keeps.
class SweepAndPrune {
 public:
  /// Finds what candidate_pairs(bodies) returns, in the same order; forgets what `pairs` held.
  void find(const std::vector<MovedBound>& bodies, std::vector<PairBounds>& pairs);

  /// The same, as a list of its own.
  std::vector<PairBounds> candidates(const std::vector<MovedBound>& bodies) {
    std::vector<PairBounds> pairs;
    find(bodies, pairs);
    return pairs;
  }

 private:
  void cover(const std::vector<MovedBound>& bodies, int axis);
  void sort();
  void part_into_strips();
  [[nodiscard]] std::size_t strip_at(double place_m) const;
  void sweep(std::size_t strip);
  void sort_found(std::size_t bodies);

  std::array<std::vector<std::int32_t>, 3> orders_;  ///< bodies along each axis, last time
  std::vector<SweptInterval> intervals_;
  std::vector<std::vector<SweptInterval>> strips_;  ///< those from strip_count_ on mean nothing
  std::size_t strip_count_{1};
  double strips_begin_m_{0.0};
  double strip_width_m_{1.0};
  SweptIntervals swept_;
  std::vector<BodyPair> found_;
  std::vector<BodyPair> half_sorted_;
  std::vector<std::size_t> places_;
};

}  // namespace impetus::inline collision
