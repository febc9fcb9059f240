// Candidate pairs by sweep and prune: the bodies' intervals along one axis, kept in order from step
// to step.
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

#include "engine/collision/broad_phase.hpp"
#include "engine/numerics/lanes.hpp"

namespace impetus::inline collision {

/// What a body covers along the axis of the sweep and across it.
struct SweptInterval {
  double least;
  double greatest;
  std::array<double, 2> across_least;
  std::array<double, 2> across_greatest;
  std::int32_t body;
  bool movable;
};

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
