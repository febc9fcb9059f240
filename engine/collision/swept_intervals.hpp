// Intervals of bodies along three axes, sorted along the first, each end in an array of its own:
// what a sweep compares, a block at a time.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

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

}  // namespace impetus::inline collision
