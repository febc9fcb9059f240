// SPDX-License-Identifier: MIT
#include "engine/numerics/trigonometry.hpp"

#include <cmath>
#include <numbers>

namespace impetus {
namespace {

/// Taylor series on |x| ≤ π/4 radians, where the first term left out is below 1e-18.
SineCosine on_first_octant(double x) {
  const double square = x * x;
  double sine = 0.0;
  double cosine = 0.0;
  for (int term = 9; term >= 1; --term) {
    sine = -square / ((2.0 * term) * (2.0 * term + 1.0)) * (1.0 + sine);
    cosine = -square / ((2.0 * term - 1.0) * (2.0 * term)) * (1.0 + cosine);
  }
  return {x * (1.0 + sine), 1.0 + cosine};
}

}  // namespace

SineCosine sine_cosine_deg(double angle_deg) {
  // floor and the subtraction are exact in binary for these sizes, hence the same everywhere.
  const double quarter_turns = std::floor(angle_deg / 90.0 + 0.5);
  const double rest_deg = angle_deg - 90.0 * quarter_turns;
  const SineCosine base = on_first_octant(rest_deg * (std::numbers::pi / 180.0));
  switch (static_cast<long long>(quarter_turns) & 3) {
    case 0:
      return base;
    case 1:
      return {base.cosine, -base.sine};
    case 2:
      return {-base.sine, -base.cosine};
    default:
      return {-base.cosine, base.sine};
  }
}

double metres_per_degree(double viewing_distance_m) {
  const SineCosine half = sine_cosine_deg(0.5);
  return 2.0 * viewing_distance_m * (half.sine / half.cosine);
}

}  // namespace impetus
