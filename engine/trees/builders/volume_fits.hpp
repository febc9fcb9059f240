// The volume of each kind that reaches least beyond an object, round a part of its surface.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "engine/trees/builders/part_shape.hpp"
#include "engine/trees/builders/reach_beyond.hpp"
#include "engine/volumes/volume.hpp"

namespace impetus::inline trees {

/// A search for better parameters that asks for nothing but scores: a step along each parameter
/// either way, kept when it helps; half the step when none does. (Hooke and Jeeves 1961) Parameters
/// about zero with no greater a score than zero's own, after `rounds` of at most 2 N scores each.
/// `score(parameters, enough)` may return anything above `enough` once it is known to exceed it.
template <std::size_t N, typename Score>
std::array<double, N> compass_search(std::array<double, N> steps, int rounds, const Score& score) {
  std::array<double, N> best{};
  double least = score(best, 1e300);
  for (int round = 0; round < rounds; ++round) {
    bool helped = false;
    for (std::size_t i = 0; i < N; ++i) {
      for (const double sign : {1.0, -1.0}) {
        std::array<double, N> tried = best;
        tried[i] += sign * steps[i];
        const double got = score(tried, least);
        if (got < least) {
          least = got;
          best = tried;
          helped = true;
          break;
        }
      }
    }
    if (!helped) {
      for (double& step : steps) {
        step *= 0.5;
      }
    }
  }
  return best;
}

/// A volume that holds the points of the part's shape but for rounding.
struct Fit {
  Volume volume;
  double reach_m{0.0};                 ///< of reach_beyond_m()
  Matrix3 frame{Matrix3::Identity()};  ///< columns: the axes of the volume, or the part's
};

/// What a fit is made from; `frames` are those to start at.
struct FitTask {
  const PartShape* shape;
  DistanceToUse solid;
  std::vector<Matrix3> frames;
  Effort effort;
};

Fit fit_sphere(const FitTask& task);
Fit fit_line(const FitTask& task);
Fit fit_rectangle(const FitTask& task);
Fit fit_box(const FitTask& task);

/// The same core or orientation, with the radius or the extents that hold `corners`, and as much
/// more as rounding asks for: `margin_m` or a power of two of it. holds() is true of every corner.
Volume grown_to_hold(const Volume& volume, const std::vector<Vector3>& corners, double margin_m);

}  // namespace impetus::inline trees
